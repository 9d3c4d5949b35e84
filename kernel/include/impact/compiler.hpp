// SPDX-License-Identifier: MIT
#pragma once
// Hints for GCC 12 about a step, in one place. Each was measured by `ctest -R step_cost` on the target named.
//
//     call boundary     Format::calls_contact: a step in contact is a call of its own (call_contact in
//                       step/step.hpp). Otherwise a free step saves the registers of the contact: Cortex-M, RISC-V.
//     reload_state      after a contact was solved the state is read from memory again. Otherwise copies of it are kept
//                       on the stack meanwhile: all cores without a large register file (Format::has_spare_registers).
//     solve             a contact's solve() is always inlined, or its Reaction goes through memory: four sub-steps cost
//                       3434 instead of 1688 instructions (Cortex-M3). So is a law's stored(), or it is called where
//                       nobody reads it.
//     its pieces        are inlined, or they read the plan's constants from memory: 2098 instead of 1688 instructions
//                       for four sub-steps, 697 instead of 647 for an impact (Cortex-M3).
//     kept penetration  is compared with its limit where the contact keeps it, not in a register until then: Cortex-M0.
//     not const         an impulse that several branches make is not a `const` local: GCC keeps such a one in memory.
//     afresh impulse    the response to an impulse is one piece of code behind the branches that lead to it. Otherwise
//                       it is copied to each: 370 bytes with one stop on RISC-V, by `ctest -R leaving_out`.
//     small approach    StopApproach<Model> has only the members that a contact reads; Phase::apart is assigned where a
//                       contact could be cleared as a whole. Otherwise each contact calls memset: Cortex-M0.
//     lasting           of a friction is made from the plan's number. A copy of the plan's struct keeps the whole plan
//                       in the image, 590 bytes by `ctest -R leaving_out`: Cortex-M.
//     m.state = {}      start() clears the state by its machine: through a reference GCC calls memset.
//     cold              the making of a plan is optimised for size: 11 % of an image that makes one at run time with
//                       -O2, by `size` on Cortex-M3. It also compiles in nine tenths of the time.
//     start()           writes the contact's phase again behind `state = {}`: without it GCC 12 cannot evaluate an
//                       absorber's constructor as a constant expression.

#include <impact/numeric/high_product.hpp>

namespace impact {

template <class Model> [[gnu::always_inline]] constexpr void reload_state(typename Model::State& state) {
  if constexpr (!Model::Format::has_spare_registers) reload(state);
}

}  // namespace impact
