// A search for a step that takes longer than those of the paper's scene. It sets random states directly, with
// penetrations and speeds from 2^-24 of twice their bounds on, at either side, apart, touching and released. Each is
// followed for some steps. It covers every budgeted configuration on the paper's scene, and generated scenes, whose
// constants shift by other amounts: ten on a Cortex-M3, two elsewhere. Prints rows for within_budget.sh and where the
// longest step was. Fails unless it has found every change of the contact's phase, and every fault. step_cost.cpp
// starts it, and has the steps of the budgeted configurations.

#include <board/console.hpp>

#include "counted_steps.hpp"

namespace impact::target {
namespace {

constexpr uint32_t instructions_to_spend = 6000000;  // per scene of a configuration
constexpr int steps_from_a_state = 8;
#if defined(__ARM_ARCH_7M__)
constexpr bool is_cortex_m3 = true;
#else
constexpr bool is_cortex_m3 = false;
#endif

class Random {
 public:
  uint32_t bits() {  // Marsaglia's xorshift32
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_;
  }
  uint32_t below(uint32_t count) { return (bits() >> 8) % count; }
  double fraction() { return static_cast<int32_t>(bits() >> 1) * constant::power_of_two(-31); }
  // A number of either sign and any order of magnitude down to 2^-24 of the bound.
  double scattered(double bound) {
    const double size = bound * (1 - 0.5 * fraction()) * constant::power_of_two(-static_cast<int>(below(24)));
    return below(2) != 0 ? size : -size;
  }

 private:
  uint32_t state_ = 2463534242;
};

struct Longest {
  uint32_t steps = 0, sum = 0, largest = 0;
  Phase before{}, after{};  // before and after the longest step
};
struct Found {
  Longest sound, faulty;        // steps without and with a fault
  uint32_t ways[2][3][3] = {};  // counts by stop, phase before and phase after
  uint32_t faults[4] = {};

  void add(uint32_t instructions, uint32_t left, Phase from, Phase to, Fault fault) {
    Longest& kind = fault == Fault::none ? sound : faulty;
    ++kind.steps;
    kind.sum += instructions;
    if (instructions > kind.largest) kind.largest = instructions, kind.before = from, kind.after = to;
    ++ways[left][static_cast<uint32_t>(from)][static_cast<uint32_t>(to)];
    const auto reason = static_cast<uint32_t>(fault);
    if (reason < 4) ++faults[reason];
  }
};

// States reach twice the bounds, which formats represent before they raise a fault. Returns false if the absorber
// rejects the state. Not inlined, since that takes a fifth more time to compile.
template <class Absorber>
[[gnu::noinline]] bool place(Absorber& absorber, const Scene& scene, const Bounds& bounds, bool can_be_released,
                             Random& random) {
  const auto& plan = Absorber::plan;
  auto saved = absorber.save();
  auto& state = saved.state;
  const bool left = random.below(2) != 0;
  const double apart = scene.clearance / 2 + random.scattered(2 * bounds.penetration);
  const double x1 = (3 * random.fraction() - 1.5) * (bounds.displacement - apart);
  state.x1 = plan.units.state_at(x1);
  state.x2 = plan.units.state_at(left ? x1 - apart : x1 + apart);
  state.dx1 = plan.units.state(random.scattered(2 * bounds.speed) * plan.step);
  state.dx2 = plan.units.state(random.scattered(2 * bounds.speed) * plan.step);
  state.contact = {};
  state.at_left = left;
  state.fault = Fault::none;
  if constexpr (Absorber::Field::is_sampled) {
    const typename Absorber::Value sample = Absorber::base_sample_of(random.scattered(bounds.base_acceleration));
    state.by_field = in<unit::Field>(Absorber::Field::at_end(plan, sample));
  }
  if constexpr (Absorber::Friction::is_friction) {
    // The ball slides in either direction, with or without a reversal.
    DryFriction::slide(plan, state, random.below(2) != 0);
    if (random.below(3) == 0) state.lasting = in<unit::Position>(Absorber::Format::largest_sample(1e30));
  }
  const auto inside = plan.units.penetration(mirrored(state.x2 - state.x1, left));
  if (is_positive(inside) && random.below(3) != 0) {
    state.contact.start(plan.contact, plan.units,
                        {inside, mirrored(plan.units.relative(state.dx2 - state.dx1), left), {}});
    if (can_be_released && random.below(3) == 0) state.contact.phase = Phase::released;
  }
  return absorber.restore(saved);
}

template <class Configuration, class Rig, class Absorber> void search(Step step, Found& found) {
  static Absorber absorber;
  uint32_t index = 0;
  Random random;
  const bool can_be_released = Configuration::is_linear;
  for (uint32_t spent = 0; spent < instructions_to_spend;) {
    spent += 1000;
    if (!place(absorber, Rig::scene, Rig::bounds, can_be_released, random)) continue;
    for (int i = 0; i < steps_from_a_state; ++i) {
      const Phase before = absorber.state().contact.phase;
      Configuration::sample(index++);
      const uint32_t instructions = instructions_of(step, &absorber);
      spent += instructions;
      const auto& state = absorber.state();
      found.add(instructions, state.at_left, before, state.contact.phase, state.fault);
      absorber.clear_fault();
    }
  }
}

void print_row(const char* label, const char* quantity, const Longest& found) {
  if (found.steps == 0) return;
  constexpr const char* phases[] = {"apart", "touching", "released"};
  board::print(IMPACT_TARGET, ",", label, ",", quantity, ",", found.sum / found.steps, ",", found.largest, "\n");
  board::print("# the longest from ", phases[static_cast<uint32_t>(found.before)], " to ",
               phases[static_cast<uint32_t>(found.after)], ", of ", found.steps, " steps\n");
}

bool is_covered(uint32_t count, const char* what, uint32_t which) {
  if (count != 0) return true;
  board::print("# the search has missed ", what, " ", which, "\n");
  return false;
}
// At both stops, every change of phase that the law has: 0 apart, 1 touching, 2 released. In fixed point also every
// fault.
bool has_every_transition(const Found& found, bool can_be_released, bool can_fault) {
  bool has = true;
  for (const auto& ways : found.ways)
    for (uint32_t from = 0; from < 3; ++from)
      for (uint32_t to = 0; to < 3; ++to)
        if ((from < 2 && to < 2) || (can_be_released && from != 0))
          has = is_covered(ways[from][to], "the way between phases", 10 * from + to) && has;
  // A fault of displacement or of speed suffices, since one check finds and one function clamps both.
  if (can_fault) has = is_covered(found.faults[1] + found.faults[2], "fault", 1) && has;
  if (can_fault) has = is_covered(found.faults[3], "fault", 3) && has;
  return has;
}

// A scene of random masses, stiffnesses and step, the same in every compilation.
constexpr double spread(uint32_t& seed, double least, double most) {  // logarithmic
  seed = seed * 1664525 + 1013904223;
  const double octaves = constant::exponent_above(most / least) * static_cast<double>(seed >> 8) / (1 << 24);
  const int whole = static_cast<int>(octaves);
  const double value = least * constant::power_of_two(whole) * (1 + octaves - whole);
  return value < most ? value : most;
}
template <uint32_t number> struct GeneratedRig {
  static constexpr Scene make_scene() {
    uint32_t seed = number * 2654435761u;
    Scene scene;
    scene.main_mass = spread(seed, 0.2, 5);
    scene.ball_mass = scene.main_mass * spread(seed, 0.05, 1);
    scene.main_stiffness = spread(seed, 10, 10000);
    scene.main_damping = spread(seed, 0.001, 1);
    scene.clearance = spread(seed, 0.001, 0.1);
    scene.contact_stiffness = spread(seed, 3000, 3e5);
    scene.contact_damping = scene.contact_stiffness * spread(seed, 0.01, 1);
    scene.stops = number % 4 == 0 ? Stops::left : number % 4 == 1 ? Stops::right : Stops::both;
    return scene;
  }
  static constexpr double make_step() {
    uint32_t seed = number * 40503u + 1;
    return spread(seed, 2e-5, 1e-3);
  }
  static constexpr Scene scene = make_scene();
  static constexpr Bounds bounds{0.1, 2, 0.03, 10};  // the default bounds, with a stated penetration
  static constexpr double step = make_step();
};

// An upright scene on a base that shakes, with friction.
template <uint32_t number> struct GeneratedRigWithParts : GeneratedRig<number> {
  static constexpr Scene make_scene() {
    uint32_t seed = number * 69069u + 7;
    Scene scene = GeneratedRig<number>::scene;
    scene.gravity = -9.81;
    scene.ball_friction = scene.ball_mass * spread(seed, 1, 10);
    return scene;
  }
  static constexpr Scene scene = make_scene();
  static constexpr Bounds bounds{0.1, 2, 0.03, 10, 10};
};

#if defined(IMPACT_WITH_PARTS)
using Searched = WithAllParts<Fixed32, HuntCrossley, Moment, Sine>;
template <uint32_t number> using SearchedRig = GeneratedRigWithParts<number>;
template <uint32_t number>
using SearchedAbsorber =
    Absorber<SearchedRig<number>, HuntCrossley, Moment, Sine, Fixed32, BaseAcceleration, DryFriction>;
#else
using Searched = Configuration<HuntCrossley, Moment, Fixed32, Sine>;
template <uint32_t number> using SearchedRig = GeneratedRig<number>;
template <uint32_t number> using SearchedAbsorber = Absorber<SearchedRig<number>, HuntCrossley, Moment, Sine, Fixed32>;
#endif
template <uint32_t... numbers> void search_scenes(Found& found) {
  (search<Searched, SearchedRig<numbers>, SearchedAbsorber<numbers>>(advance<Searched, SearchedAbsorber<numbers>>,
                                                                     found),
   ...);
}

}  // namespace

int search_longest() {
  bool has_all = true;
  const Steps* steps = counted_steps;
  for_each(Counted{}, [&has_all, &steps](auto configuration) {
    using Configuration = decltype(configuration);
    using Long = typename Configuration::template Absorber<1000>;
    using Short = typename Configuration::template Absorber<100>;
    Found found;
    search<Configuration, typename Configuration::template Rig<1000>, Long>(steps->at_1000_us, found);
    search<Configuration, typename Configuration::template Rig<100>, Short>(steps->at_100_us, found);
    ++steps;
    print_row(Configuration::label.text, "search", found.sound);
    print_row(Configuration::label.text, "search_fault", found.faulty);
    has_all = has_every_transition(found, Configuration::is_linear, Configuration::is_fixed) && has_all;
  });
#if !defined(IMPACT_WITH_FRICTION)
  Found found;
  search_scenes<1, 2>(found);
  if constexpr (is_cortex_m3) search_scenes<3, 4, 5, 6, 7, 8, 9, 10>(found);
  print_row(Searched::label.text, "search_scenes", found.sound);
  print_row(Searched::label.text, "search_scenes_fault", found.faulty);
  has_all = has_every_transition(found, false, true) && has_all;
#endif
  return has_all ? 0 : 1;
}

}  // namespace impact::target
