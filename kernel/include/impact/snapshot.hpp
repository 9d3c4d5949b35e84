// SPDX-License-Identifier: MIT
#pragma once
// What a task reads while an interrupt steps: a whole snapshot of one step, without a lock and without turning an
// interrupt off. The writer fills the one of two slots that is not published and then publishes it:
//
//     writer    begun = n + 1        slot[(n + 1) & 1] = snapshot      published = n + 1
//     reader    n = published        copy = slot[n & 1]                whole if begun - n <= 1
//
// The slot that a reader copies is written again only by the second publication after, which then has begun. So a copy
// is whole whoever interrupts whom, on one core or two, for any number of readers: a try fails only where two steps
// begin during its own dozen loads. After four tries, that is after eight steps in which the reader had next to no
// time, it says so instead. One writer. Loads and stores of one word, no read-modify-write: the same on a Cortex-M0.

#include <stdint.h>

#include <impact/fault.hpp>

namespace impact {

// In native numbers, as of the absorber's getters.
template <class Value>
struct Snapshot {
  Value displacement, velocity, ball_displacement, ball_velocity;
  Value contact_force;  // 0 without the feature ContactForce
  uint32_t steps;       // since the start or the last reset(): retune() does not touch it
  Fault fault;
  bool is_touching;
  bool is_whole;  // false after four interrupted tries
};

// The memory of the feature Snapshots; empty without it.
template <class Value, bool is_named>
class SnapshotWindow {};

template <class Value>
class SnapshotWindow<Value, true> {
 public:
  // Before anyone reads.
  constexpr Snapshot<Value>& first() { return slots_[0]; }

  // `write` fills the slot.
  template <class Write>
  void publish(Write write) {
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
