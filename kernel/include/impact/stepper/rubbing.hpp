// SPDX-License-Identifier: MIT
#pragma once
// Dry friction within a step, for a contact that feels it (motion/friction.hpp has that of whole steps). A flight
// contains the friction that the step began with. Where the sliding turns or ends, the rest of the step needs another
// one. The rate of sliding goes from v0 to v1 in a part of the step, with the bow 6 (D - (v0 + v1)/2) over the
// displacement D. z of the part is left after the turn, with a correction of its first value for the bow:
//
//     z = v1/(v1 - v0)           z = v1/(v1 - v0 - (1 - z) bow)
//
//     abs(f + v1 - v0) <= r      it sticks           friction takes v1
//     otherwise                  it slides back      friction takes z (r - f), at most v1
//
// f and r are what the friction so far and the full one take of the rate in that part. Derivation: docs/flight.md.

#include <impact/numeric/formula.hpp>
#include <impact/numeric/in.hpp>

namespace impact {

// The friction of a step, in the coordinates of the stop. Friction counts as what it takes of the rate in a step.
template <class Format> struct Rubbing {
  using Penetration = impact::Penetration<typename Format::Value>;

  Penetration full;   // 0: none
  Penetration force;  // of the flight; then at the step's end
  GainOf<typename Format::Gain, unit::Penetration, unit::Penetration> main_share;  // of what it takes
  int slides;                // 1 into the stop, -1 out of it, 0 if it sticks
  bool meets_stop;           // false: all of the step was flight
  bool has_turned;           // before the stop
  Penetration displacement;  // of the flight, if it has turned
  GainOf<typename Format::ClampedGain, unit::Penetration, unit::Number> half_by_full;  // 1/(2 r)
  typename Format::Energy quarter;  // with sub-steps: of what friction dissipates in this step, over R
  // With a contact that takes no time: what it prevents of the flight's displacement, how friction changes rate and
  // penetration at the step's end, and the latter times the part of the step since the impact. For the ledger of a ball
  // that has turned before it comes to rest: half of what its displacement differs from that of a flight with the last
  // friction alone.
  Penetration prevented, taken, moved, aged, half_late;
};

// A quarter of an impulse of up to 4 r, over r.
template <class Format>
constexpr auto quarter_over(GainOf<typename Format::ClampedGain, unit::Penetration, unit::Number> half_by_full,
                            Penetration<typename Format::Value> impulse) {
  return bare(half_by_full * Penetration<typename Format::Value>(Format::value(half(impulse))));
}

// The friction in a part of the step.
template <class Format> struct PartRubbing {
  using Value = typename Format::Value;
  using Penetration = impact::Penetration<Value>;

  Penetration full, force;
  int slides;

  // What friction takes of the rate, its moment about the part's end, over the part's duration, and the average rate
  // that it works against: besides the work of the friction so far on the part's displacement, it takes `rate` times
  // (v1 - rate - z f)/2.
  struct Taken {
    Penetration rate, moment, lost_at;
  };
  // At the part's end, with `rate` as if the friction had not changed.
  template <bool has_bow = false>
  constexpr Taken follow(Penetration before, Penetration rate, [[maybe_unused]] Penetration bow = {}) {
    if (slides > 0 ? is_positive(rate) : slides < 0 && is_negative(rate)) return {};
    const bool back = is_negative(rate), turns = !is_positive(mirrored(before, back));
    const Penetration end = mirrored(rate, back), start = mirrored(before, back), needed = force + (rate - before);
    auto left = Format::quotient(positive_part(end), turns ? positive_part(end - start) : positive_part(end));
    if constexpr (has_bow)
      if (turns && is_positive(end - start - mirrored(bow, is_negative(bow)))) {
        const Penetration bent = mirrored(bow, back), chord = end - start - bent + Format::value(left * bent);
        if (is_positive(chord - end)) left = Format::quotient(positive_part(end), positive_part(chord));
      }
    const Penetration before_turn = Format::value(left * mirrored(force, back));
    Penetration taken = end;
    if (turns && !is_positive(mirrored(needed, is_negative(needed)) - full)) {
      slides = 0;
      force = needed;
    } else {
      const Penetration turned = Format::value(left * (full - mirrored(force, back)));
      if (is_positive(taken - turned)) taken = turned;
      slides = back ? -1 : 1;
      force = mirrored(full, back);
    }
    const Penetration lost_at = Format::value(half(end - taken - before_turn));
    taken = mirrored(taken, back);
    return {taken, Format::value(half(Format::value(left * taken))), mirrored(lost_at, back)};
  }
};

}  // namespace impact
