#!/bin/sh
# Wrong programs, and the first message that each gets: messages.sh COMPILER PROJECT
# A mistake in a value or a call gets exactly one message. One in an argument gets its own message first, in under ten
# lines.
. "$(dirname "$0")/../folder.sh"
compiler=$1 project=$2
needs "$compiler"
failures=0
# The programs' common header is precompiled, for those that are compiled without flags of their own.
mkdir "$folder/impact"
echo '#include <impact/absorber.hpp>' >"$folder/read.hpp"
"$compiler" -std=c++17 -I "$project/kernel/include" -x c++-header "$folder/read.hpp" -o "$folder/impact/absorber.hpp.gch"
case $compiler in
  clang*) read_before="-include-pch $folder/impact/absorber.hpp.gch" ;;
  *) read_before="-I $folder" ;;
esac

# wrong COUNT MESSAGE FLAG...: the program on the input has COUNT errors ("any", or "short": under ten lines), and the
# first contains MESSAGE.
wrong() {
  count=$1 message=$2 && shift 2
  cat >"$folder/program.cpp"
  [ $# -gt 0 ] || set -- $read_before  # a list
  if "$compiler" -std=c++17 -fsyntax-only "$@" -I "$project/kernel/include" "$folder/program.cpp" 2>"$folder/errors"; then
    echo "compiles, but must fail with: $message" && failures=1 && return
  fi
  first=$(grep -E 'error: ' "$folder/errors" | head -n 1)
  echo "$first" >>"$folder/seen"
  errors=$(grep -cE 'error: ' "$folder/errors")
  case $first in *"$message"*) ;; *) echo "expected first message: $message" && echo "  found: $first" && failures=1 ;; esac
  [ "$count" != short ] || {
    count=any lines=$(wc -l <"$folder/errors")
    [ "$lines" -lt 10 ] || { echo "$lines lines, expected fewer than 10, for: $message" && cat "$folder/errors" && failures=1; }
  }
  [ "$count" = any ] || [ "$count" = "$errors" ] || {
    echo "$errors errors, expected $count, for: $message" && grep 'error: ' "$folder/errors" | sed 's/^/  /' && failures=1
  }
}

# rig [SCENE [BOUNDS [STEP]]]: the first lines of a program, the paper's rig with these changes.
rig() {
  cat <<END
#include <impact/absorber.hpp>
struct Rig {
  static constexpr impact::Scene scene = [] {
    impact::Scene s;
    ${1-}
    return s;
  }();
  static constexpr impact::Bounds bounds = [] {
    impact::Bounds b;
    ${2-}
    return b;
  }();
  static constexpr double step = ${3:-1e-4};
};
END
}

# scene COUNT MESSAGE CHANGES [LAW [STEP [BOUNDS [PART]]]]
scene() {
  wrong "$1" "$2" <<END
$(rig "$3" "${6-}" "${5-}")
impact::Absorber<Rig, impact::${4:-HuntCrossley}, impact::Moment, impact::Sine, impact::Fixed32${7:+, impact::$7}> absorber;
END
}
scene 1 'Rig::scene.main_mass: 1e-9 to 1e9 kg' 's.main_mass = -1;'
scene 1 'Rig::scene.main_mass: 1e-9 to 1e9 kg' 's.main_mass = __builtin_nan("");'
scene 1 'Rig::scene.main_stiffness: 0 to 1e12 N/m' 's.main_stiffness = -1;'
scene 1 'Rig::scene.main_damping: 0 to 1e9 N s/m' 's.main_damping = -1;'
scene 1 'Rig::scene.ball_mass: 1e-9 to 1e9 kg' 's.ball_mass = 0;'
scene 1 'Rig::scene.clearance: 0 to 1e12 m' 's.clearance = -0.02;'
scene 1 'Rig::scene.clearance: no ball within Bounds::displacement reaches a stop' 's.clearance = 12;'
grep -q "StopInReach<400000, false>" "$folder/errors" || { echo "the message lacks the largest clearance, StopInReach<400000, false>" && failures=1; }
scene 1 'Rig::scene.contact_stiffness: 1e-3 to 1e18' 's.contact_stiffness = 0;'
scene 1 'Rig::scene.contact_damping: 0 to 1e18' 's.contact_damping = -1;'
scene 1 'Rig::scene.restitution: 0.01 to 1' 's.restitution = 1.5;'
scene 1 'Rig::scene.drive_amplitude: 0 to 1e9 N' 's.drive_amplitude = -1;'
scene 1 'Rig::scene.drive_pulsation: 0 to 1e6 rad/s' 's.drive_pulsation = 1e7;'
scene 1 'Rig::scene.drive_pulsation: 0, or from 2^-24 rad per step to 1e6 rad/s' 's.drive_pulsation = 1e-5;'
scene 1 'Rig::scene.x1: -1e3 to 1e3 m' 's.x1 = 1e4;'
scene 1 'Rig::scene.x1 and x2: -1e3 to 1e3 m, and the ball no deeper in a stop than Bounds allow' 's.x2 = 0.09;'
scene 1 'Rig::scene.v2: -1e3 to 1e3 m/s' 's.v2 = 1e4;'
scene 1 'Bounds::displacement: 1e-9 to 1e6 m' 's.x1 = 1;'
scene 1 'Bounds::speed: 1e-9 to 1e6 m/s' 's.v1 = 3;'
scene 1 'Bounds::force: 0 to 1e9 N' '' HuntCrossley 1e-4 'b.force = -1;'
scene 1 'Rig::step: from 1e-9 s to the longest_step_in_nanoseconds' '' HuntCrossley 0.1
grep -q 'Step<4859898, false>' "$folder/errors" || { echo "the message lacks the longest step that compiles, Step<4859898, false>" && failures=1; }
scene 1 'Rig::step: from 1e-9 s to the longest_step_in_nanoseconds' '' HuntCrossley 0
scene 1 'Rig::step: too few steps per contact for this stepper' '' HuntCrossley 5e-3
grep -Eq 'StepsPerContact<4859898, false>' "$folder/errors" || { echo "the message lacks the longest step, StepsPerContact<4859898, false>" && failures=1; }
# A restitution that the law ignores, and one that it uses.
scene 1 'Rig::scene.restitution is stated, but this law does not read it' 's.restitution = 0.7;'
scene 1 'Rig::scene.restitution is stated, but this law does not read it' 's.restitution = 0.7; s.contact_damping = 0;' Hertz
scene 1 'Rig::step: from 1e-9 s to the longest_step_in_nanoseconds' 's.restitution = 0.7;' Exact 0.1
# A law whose damping follows from the restitution, without one, and with another law's damping.
scene 1 'Rig::scene.restitution is not stated' '' Exact
scene 1 'Rig::scene.contact_damping is stated, but this law does not read it' 's.restitution = 0.7; s.contact_damping = 1e5;' Exact
# A field that is too large, and a weight by which the spring sags beyond the bounds.
scene 1 'Bounds::base_acceleration: 0 to 1e6 m/s^2, and at most 0.06 Bounds::displacement/step^2 together' '' HuntCrossley 1e-3 \
  'b.base_acceleration = 1e6;' BaseAcceleration
scene 1 'In Fixed32 it may also be too large for these Bounds' 's.gravity = -1e6;' HuntCrossley 1e-3 '' Gravity
scene 1 'Bounds::displacement: no less than main_mass * gravity / main_stiffness' 's.gravity = -9.81; s.main_stiffness = 90;' \
  HuntCrossley 1e-4 '' Gravity
# A part's value without the part, and a part without its value.
scene 1 "Rig::scene.gravity is stated: append Gravity to the absorber's type" 's.gravity = -9.81;'
scene 1 "Rig::bounds.base_acceleration is stated: append BaseAcceleration to the absorber's type" '' HuntCrossley 1e-4 'b.base_acceleration = 3;'
scene 1 "Rig::scene.ball_friction is stated: append DryFriction to the absorber's type" 's.ball_friction = 0.1;'
scene 1 "Gravity is among the absorber's parts: state Rig::scene.gravity, m/s^2" '' HuntCrossley 1e-4 '' Gravity
scene 1 "BaseAcceleration is among the absorber's parts: state Rig::bounds.base_acceleration, m/s^2" '' HuntCrossley 1e-4 '' BaseAcceleration
scene 1 "DryFriction is among the absorber's parts: state Rig::scene.ball_friction, N" '' HuntCrossley 1e-4 '' DryFriction
# The c1 of another law, and an unstated c1 beside a stated law or stiffness.
scene 1 'Rig::scene.contact_damping: more than ten times critical for HookeNewton' 's.contact_damping = 19560;' HookeNewton
unstated='Rig::scene.contact_damping is not stated, and its default belongs to HuntCrossley with the default contact_stiffness. State c1'
scene 1 "$unstated" '' HookeNewton
scene 1 "$unstated" 's.contact_stiffness = 1e5;' HookeNewton
scene 1 "$unstated" 's.contact_stiffness = 1e6;'

# chosen MESSAGE CHANGES [LAW [STEP [BOUNDS [FORMAT]]]]: with the rule's stepper and the manual's converters, only this
# message appears.
chosen() {
  wrong 1 "$1" <<END
$(rig "$2" "${5-}" "${4-}")
using Law = impact::${3:-Exact};
using Absorber = impact::Absorber<Rig, Law, impact::Chosen<>, impact::Sampled, impact::${6:-Fixed32}, impact::ContactForce>;
static Absorber absorber;
constexpr impact::Converter dac{2048, 2047 / 0.05, 0, 4095}, adc{2048, 2048 / 10.0, 0, 4095};
constexpr impact::ToCounts<Absorber, impact::Quantity::displacement> to_dac(dac);
constexpr impact::ToCounts<Absorber, impact::Quantity::contact_force> to_motor(dac);
constexpr impact::FromCounts<Absorber> from_adc(adc);
constexpr auto push = Absorber::sample_of(2.5);
int tick(int counts) {
  absorber.step(from_adc(counts));
  return to_dac(absorber) + to_motor(absorber);
}
END
}
for format in Fixed32 Float32 Float32Plain Float64; do
  chosen 'Rig::scene.restitution: 0.01 to 1' 's.restitution = 0;' Exact 1e-4 '' $format
done
chosen 'Rig::scene.restitution: 0.01 to 1' 's.restitution = 0;' Flores
for law in Exact HuntCrossley HookeNewton; do
  chosen 'Rig::scene.main_mass: 1e-9 to 1e9 kg' 's.main_mass = 0;' $law
  chosen 'Rig::scene.ball_mass: 1e-9 to 1e9 kg' 's.ball_mass = 0;' $law
  chosen 'Rig::scene.contact_stiffness: 1e-3 to 1e18' 's.contact_stiffness = 0;' $law
done
chosen 'Rig::scene.gravity: -1e6 to 1e6 m/s^2' 's.gravity = __builtin_nan("");'
chosen 'Bounds::speed: 1e-9 to 1e6 m/s' '' Exact 1e-4 'b.speed = 0;'
chosen 'Bounds::displacement: 1e-9 to 1e6 m' 's.x1 = 1;'
chosen 'Bounds::force: 0 to 1e9 N' '' Exact 1e-4 'b.force = -1;'
for step in 0 0.2 '__builtin_nan("")'; do chosen 'Rig::step: from 1e-9 s to the longest_step_in_nanoseconds' '' Exact "$step"; done

# absorber COUNT MESSAGE ARGUMENTS [STATEMENTS]: an absorber of the paper's rig.
absorber() {
  wrong "$1" "$2" <<END
$(rig)
struct NoBounds {
  static constexpr impact::Scene scene{};
  static constexpr double step = 1e-4;
};
struct NoForce : Rig {
  static constexpr impact::Bounds bounds{0.1, 2, 0, 0};
};
struct Shaken : Rig {
  static constexpr impact::Bounds bounds{0.1, 2, 0, 10, 30};
};
struct NotStatic {
  impact::Scene scene{};
  impact::Bounds bounds{};
  double step = 1e-4;
};
struct NoTraits {};
struct NoContact : impact::Moment {
  template <class, class>
  struct Contact {};
};
using namespace impact;
Absorber<$3> absorber;
void use() { ${4-} }
END
}
absorber short 'the rig has no static bounds: write static constexpr impact::Bounds bounds' 'NoBounds, HuntCrossley, Moment, Sine, Fixed32'
absorber short 'the rig has no static scene: write static constexpr impact::Scene scene' 'NotStatic, HuntCrossley, Moment, Sine, Fixed32'
absorber short 'the fifth argument must be a format, such as Fixed32 or Float32' 'Rig, HuntCrossley, Moment, Sine, float'
absorber short 'the second argument must be a law' 'Rig, NoTraits, Moment, Sine, Fixed32'
absorber short 'the third argument must be a stepper' 'Rig, HuntCrossley, Sine, Moment, Fixed32'
absorber short "the stepper's Contact<Format, Law> is not a contact" 'Rig, HuntCrossley, NoContact, Sine, Fixed32'
absorber any 'arguments must be features' 'Rig, HuntCrossley, Moment, Sine, Fixed32, Float32'
for twice in EnergyLedger Snapshots DryFriction; do
  absorber any 'two features are of one kind: name each feature once' "Rig, HuntCrossley, Moment, Sine, Fixed32, $twice, $twice"
done
wrong any 'Chosen<> requires a rig' <<END
#include <impact/absorber.hpp>
using namespace impact;
Absorber<AtRunTime, HuntCrossley, Chosen<>, Sine, Fixed32> absorber;
END
for other in 'NoForce, Hertz' 'Rig, HuntCrossley'; do
  absorber 1 "Chosen<Rig, Law> has another rig or law than the absorber: name Chosen<>" "Rig, Hertz, Chosen<$other>, Sine, Fixed32"
done
wrong 1 "an absorber's plan is read only: absorber.retune(plan)" <<END
#include <impact/absorber.hpp>
using Absorber = impact::Absorber<impact::AtRunTime, impact::Hertz, impact::Moment, impact::Sine, impact::Fixed32>;
void change(Absorber& absorber, const Absorber::PlanType& plan) { absorber.plan = plan; }
END
absorber 1 'an absorber AtRunTime is made from a plan' 'AtRunTime, HuntCrossley, Moment, Sine, Fixed32'
absorber 1 'the drive is Sampled: state Rig::bounds.force' 'NoForce, HuntCrossley, Moment, Sampled, Fixed32'
absorber 1 'step() without a sample, but the drive is Sampled' 'Rig, HuntCrossley, Moment, Sampled, Fixed32' 'absorber.step();'
absorber 1 'step(sample), but the drive takes none' 'Rig, HuntCrossley, Moment, Sine, Fixed32' 'absorber.step({100});'
absorber 1 "this sample has another type than the format's values" 'Rig, HuntCrossley, Moment, Sampled, Fixed32' 'absorber.step(1.5f);'
absorber 1 "this sample has another type than the format's values" 'Rig, HuntCrossley, Moment, Sampled, Fixed32' 'absorber.step(int32_t{7});'
absorber 1 "this sample has another type than the format's values" 'Rig, HuntCrossley, Moment, Sampled, Float32' 'absorber.step(100);'
absorber 1 'retune() requires a plan AtRunTime' 'Rig, HuntCrossley, Moment, Sine, Fixed32' 'absorber.retune(absorber.plan);'
absorber 1 'contact_force() requires the feature ContactForce' 'Rig, HuntCrossley, Moment, Sine, Fixed32' 'absorber.contact_force();'
absorber 1 'impact_speed() requires the feature ImpactLog' 'Rig, HuntCrossley, Moment, Sine, Fixed32' 'absorber.impact_speed();'
absorber 1 'peak_force() requires the feature ImpactLog' 'Rig, HuntCrossley, Moment, Sine, Fixed32' 'absorber.peak_force();'
absorber 1 'snapshot() requires the feature Snapshots' 'Rig, HuntCrossley, Moment, Sine, Fixed32' 'absorber.snapshot();'

# A number in braces, another quantity, and a value for which a converter takes its own type.
sampled='Rig, HuntCrossley, Moment, Sampled, Fixed32'
absorber 1 'step({..}): a number in braces, such as a converter' "$sampled" 'absorber.step({100});'
absorber 1 'this sample is another quantity: for a force use FromCounts<Absorber>' "$sampled" \
  'using A = decltype(absorber); FromCounts<A, Quantity::displacement> from({2048, 20480, 0, 4095}); absorber.step(from(7));'
absorber 2 'this sample is another quantity: for a force use' "Shaken, HuntCrossley, Moment, Sampled, Float32, BaseAcceleration" \
  'absorber.step(absorber.base_sample_of(1.0), absorber.sample_of(1.0));'
absorber 1 'ToCounts reads its quantity itself: pass the absorber or its snapshot()' "$sampled" \
  'ToCounts<decltype(absorber), Quantity::displacement> to({2048, 40940, 0, 4095}); to(absorber.velocity());'
absorber 1 'the contact force requires the feature ContactForce' 'Rig, HuntCrossley, Moment, Sine, Fixed32, Snapshots' \
  'ToCounts<decltype(absorber), Quantity::contact_force> to({2048, 20, 0, 4095}); to(absorber.snapshot());'
absorber 1 'correct(dx, dv): first a displacement, then a velocity' "$sampled" \
  'using A = decltype(absorber); FromCounts<A, Quantity::velocity> from({2048, 2048, 0, 4095}); absorber.correct(from(7), {});'
absorber 1 'correct(dx, dv): first a displacement, then a velocity' "$sampled" \
  'using A = decltype(absorber); FromCounts<A, Quantity::displacement> from({2048, 20480, 0, 4095}); absorber.correct(from(7), from(7));'
absorber 1 'friction_dissipated() requires DryFriction and EnergyLedger' 'Rig, HuntCrossley, Moment, Sine, Float32, EnergyLedger' \
  'absorber.friction_dissipated();'
absorber 1 'FromCounts converts samples of a drive: name Sampled as the drive' 'Rig, HuntCrossley, Moment, Sine, Float32' \
  'FromCounts<decltype(absorber)> from({2048, 204.8, 0, 4095});'

# constant MESSAGE FORMAT DECLARATION: a converter that no circuit can have, or a sample beyond its bound. Clang names
# the call in a note.
constant() {
  message=$1
  case $compiler in *clang*) message='must be initialized by a constant expression' ;; esac
  wrong any "$message" <<END
$(rig)
using Absorber = impact::Absorber<Rig, impact::HuntCrossley, impact::Moment, impact::Sampled, impact::$2>;
constexpr $3;
END
  grep -q "$1" "$folder/errors" || { echo "no message contains: $1" && failures=1; }
  echo "$1" >>"$folder/seen"
}
for way in 'ToCounts<Absorber, impact::Quantity::displacement>' 'FromCounts<Absorber>'; do
  constant a_converters_least_count_is_above_its_most Fixed32 "impact::$way convert({2048, 40940, 4095, 0})"
  constant a_converter_has_no_counts_per_si_unit Fixed32 "impact::$way convert({2048, 0, 0, 4095})"
done
for format in Fixed32 Float32; do  # 200 N where Bounds::force is 10
  constant a_converters_end_is_more_than_the_bound_of_its_quantity $format 'impact::FromCounts<Absorber> convert({2048, 2048 / 200.0, 0, 4095})'
  constant a_sample_is_more_than_its_bound $format 'auto push = Absorber::sample_of(11.0)'
done

# Units that do not mix (impact/numeric/in.hpp). With matching units the same program compiles.
mixed() {
  cat <<END
#include <impact/absorber.hpp>
using Format = impact::$1;
using Value = Format::Value;
Format::Units units{};
Format::Long state{};
Value value{};
impact::Push<Value> push{};
impact::Force<Value> force{};
impact::Penetration<Value> penetration{}, rate{};
impact::Increment<Value> increment{};
impact::GainOf<Format::Gain, impact::unit::Force, impact::unit::Push> gain{};
auto result() { return $2; }
END
}
for format in Fixed32 Float32; do
  for mistake in 'units.push(state, penetration)' 'units.push(state, value)' 'units.displace(state, push)' \
    'gain * penetration' 'gain * push' 'penetration + gain * force' 'rate + increment' 'push - value' 'value - push' \
    'impact::Push<Value>(penetration)' 'penetration = push'; do
    mixed $format "$mistake" >"$folder/mixed.cpp" && wrong any '' <"$folder/mixed.cpp"
  done
  mixed $format 'units.push(state, push + gain * force), rate + units.increment_of_rate(increment)' >"$folder/fits.cpp"
  "$compiler" -std=c++17 -fsyntax-only $read_before -I "$project/kernel/include" "$folder/fits.cpp" || failures=1
done

# A setting of the compiler.
echo '#include <impact/absorber.hpp>' >"$folder/include.cpp"
case $compiler in g++*) major=GNUC ;; *) major=clang_major ;; esac
wrong 2 'impact needs GCC 9 or Clang 9' -U__${major}__ -D__${major}__=8 <"$folder/include.cpp"
wrong 2 "impact needs a float's arithmetic in float" -m32 -mno-sse -ffreestanding <"$folder/include.cpp"
for flag in -std=gnu++11 -std=gnu++14; do wrong 2 'impact needs C++17' $flag <"$folder/include.cpp"; done
for flag in -ffast-math -Ofast -ffinite-math-only; do wrong 2 'impact needs IEEE arithmetic' $flag <"$folder/include.cpp"; done
case $compiler in *clang*) ;; *)
  wrong any 'without -fsingle-precision-constant' -fsingle-precision-constant <"$folder/include.cpp" ;;
esac

# The manual quotes only messages that this test has seen.
awk -F'`' '/^\| wrong \| first message/ { on = 1 } on && !/^\|/ { exit } on && NF > 2 { print $(NF - 1) }' "$project/kernel/README.md" \
  >"$folder/quoted"
[ "$(wc -l <"$folder/quoted")" -ge 10 ] || { echo "kernel/README.md quotes fewer than 10 messages in its table of wrong programs" && failures=1; }
while read -r quoted; do
  grep -qF -- "$quoted" "$folder/seen" || { echo "kernel/README.md quotes a message that no program above gets: $quoted" && failures=1; }
done <"$folder/quoted"
exit $failures
