// SPDX-License-Identifier: MIT
#pragma once
// A snapshot of one step that a task reads while an interrupt steps, without a lock and with interrupts on. The writer
// fills the one of two slots that is not published and then publishes it:
//
//     writer    begun = n + 1        slot[(n + 1) & 1] = snapshot      published = n + 1
//     reader    n = published        copy = slot[n & 1]                whole if begun - n <= 1
//
// The slot that a reader copies is written again only by the second publication after, which then has begun. So a copy
// is whole whoever interrupts whom, on one core or two, for any number of readers and one writer. A try fails only if
// two steps begin during its dozen loads; after four such tries `is_whole` is false. There are only loads and stores of
// one word and no read-modify-write, so it is the same on a Cortex-M0.

#include <stdint.h>

#include <impact/fault.hpp>

namespace impact {

// The values of one step, in native numbers, as the absorber's getters return them.
template <class Value> struct Snapshot {
  Value displacement, velocity, ball_displacement, ball_velocity;
  Value contact_force;  // 0 without the feature ContactForce
  uint32_t steps;       // since the start or the last reset(), modulo 2^32; retune() keeps it
  Fault fault;
  bool is_touching;  // true if the step ended in contact
  bool is_whole;     // false after four interrupted tries: the values may be of two steps
};

// The memory of the feature Snapshots; empty without it.
template <class Value, bool is_named> class SnapshotWindow {};

template <class Value> class SnapshotWindow<Value, true> {
 public:
  // Before anyone reads.
  constexpr Snapshot<Value>& first() { return slots_[0]; }

  // `write` fills the slot.
  template <class Write> void publish(Write write) {
    const uint32_t number = published_ + 1;
    watched(begun_) = number;
    fence();
    write(slots_[number & 1]);
    fence();
    watched(published_) = number;
  }

  Snapshot<Value> read() const {
    for (int tries = 1;; ++tries) {
      const uint32_t number = watched(published_);
      fence();
      Snapshot<Value> copy = slots_[number & 1];
      fence();
      copy.is_whole = watched(begun_) - number <= 1;
      if (copy.is_whole || tries == 4) return copy;
    }
  }

 private:
  static volatile uint32_t& watched(uint32_t& word) { return word; }
  static const volatile uint32_t& watched(const uint32_t& word) { return word; }
  static void fence() { __atomic_thread_fence(__ATOMIC_SEQ_CST); }

  Snapshot<Value> slots_[2]{};
  uint32_t begun_ = 0, published_ = 0;
};

}  // namespace impact
