// The errors of the method and of rounding over 1 s of the paper's scene, and the main mass's free flight.

#include "paper_runs.hpp"

namespace impact::host {
namespace {

// The error of the method: x1 of the kernel in double, every 10 ms, against the reference. The bounds are the errors of
// prototypes of these schemes, to two digits; with sub-steps and with the rule, the kernel's own. Those of Moment fall
// with the fourth power of the step. At 10 us little more than the reference's own error would remain. With the other
// laws no stop pulls in this scene, so that tension changes nothing. The classical schemes equal the textbook's
// (textbook_newmark_test.cpp).
struct Prototype {
  Law law;
  Stepper stepper;
  std::vector<std::pair<double, double>> errors;  // step, s, and error, m
  Tension tension = Tension::clamp;
};

void PrintTo(const Prototype& prototype, std::ostream* out) {
  *out << name_of(prototype.law) << (prototype.tension == Tension::allow ? " with tension " : " ")
       << name_of(prototype.stepper);
}

class Accuracy : public testing::TestWithParam<Prototype> {};

TEST_P(Accuracy, IsNoWorseThanThePrototype) {
  const auto& [law, stepper, errors, tension] = GetParam();
  for (const auto& [step, error] : errors) {
    const Request request = paper_request(law, stepper, step, tension);
    const double half_a_digit = 0.05 * std::pow(10, std::floor(std::log10(error)));
    EXPECT_LE(error_of(request, 0.01, 1), error + half_a_digit) << step;
  }
}

const Prototype moments[] = {
    {Law::hertz, Stepper::moment, {{2e-3, 4.0e-6}, {1e-3, 5.7e-7}, {5e-4, 2.8e-8}, {1e-4, 3.1e-11}}},
    {Law::hunt_crossley, Stepper::moment, {{2e-3, 1.7e-7}, {1e-3, 1.3e-8}, {5e-4, 1.1e-9}, {1e-4, 1.2e-12}}},
    {Law::hooke_newton, Stepper::moment, {{1e-3, 1.0e-3}, {5e-4, 1.2e-5}, {1e-4, 1.6e-8}, {1e-5, 1e-11}}},
    {Law::hertz, Stepper::moment, {{1e-4, 3.1e-11}}, Tension::allow},
    {Law::hunt_crossley, Stepper::moment_4, {{5e-3, 8.5e-9}, {2.5e-3, 5.6e-10}, {1e-3, 3.2e-11}}},
    {Law::hunt_crossley, Stepper::moment_8, {{5e-3, 3.5e-9}, {2.5e-3, 1.3e-10}, {1e-3, 1.1e-12}}},
    {Law::hunt_crossley, Stepper::automatic, {{5e-3, 8.5e-9}, {2.5e-3, 1.2e-8}, {1e-3, 8.9e-9}}},
    {Law::hunt_crossley, Stepper::moment, {{1e-4, 1.2e-12}}, Tension::allow},
    {Law::hooke_newton,
     Stepper::moment,
     {{1e-3, 2.1e-5}, {5e-4, 2.2e-6}, {1e-4, 1.0e-7}, {1e-5, 1e-11}},
     Tension::allow}};
INSTANTIATE_TEST_SUITE_P(Moment, Accuracy, testing::ValuesIn(moments));

// The rounding error of 32 bits: Fixed32 and Float32 against double at the same step, over 1 s of the paper's scene. It
// is at most a tenth of the method's error, or a floor of 2e-9 m (Fixed32) or 1e-8 m (Float32).
//
// A scene may require more digits than the format has. A change dv of one impact's speed moves x1 by A dv within the
// second. A is some 0.2 s for Hunt-Crossley, whose losses reduce the effect, 1 s for Hertz, and 4 to 11 s for
// Hooke-Newton. For an impact at the speed v a format resolves
//
//     dv = 2^-24 v (Float32) or 2^-31 v (Fixed32), an LSB of the constants that scale the impact;
//     in Fixed32 also 2^-31 (unit of penetration) / h / sqrt(N), the LSB of the rate, over the N steps of a contact.
//
// If 2 A dv exceeds the floor, as for Hertz in Float32 and for Hooke-Newton, it replaces the floor.
//
// With a classical scheme, Hooke-Newton's force jumps in the step that first detects the contact. An LSB may decide
// which step that is. The two runs then differ by the error of the method, which is the bound.

constexpr double interval = 2e-3;

struct Rounded {
  Law law;
  Tension tension;
  Stepper stepper;
  Numeric numeric;
  double step;
};

void PrintTo(const Rounded& rounded, std::ostream* out) {
  *out << name_of(rounded.law) << (rounded.tension == Tension::allow ? " with tension " : " ")
       << name_of(rounded.stepper) << " " << name_of(rounded.numeric) << " " << rounded.step;
}

// The bounds that a user would state: twice what the scene reaches, rounded up to a power of two.
Bounds bounds_of(const Rounded& rounded) {
  Bounds bounds{0.0625, 2, 0.0156, 10};
  if (rounded.law == Law::hooke_newton) bounds.penetration = rounded.step > 1e-3 ? 0.0078 : 0.0039;
  return bounds;
}

// The largest change of x1 per change of the ball's first speed, s.
double amplification(Request request, const Samples& samples) {
  constexpr double change = 1e-8;  // m/s
  double largest = 0;
  for (const double sign : {-1, 1}) {
    request.scene.v2 = sign * change;
    largest = larger(largest, largest_difference(kernel_samples(request, interval, 1), samples) / change);
  }
  return largest;
}

class Rounding : public testing::TestWithParam<Rounded> {};

TEST_P(Rounding, AddsLittleToTheMethodsError) {
  const Rounded rounded = GetParam();
  Request request = paper_request(rounded.law, rounded.stepper, rounded.step, rounded.tension);
  const Samples reference = reference_samples(request, interval, 1), exact = kernel_samples(request, interval, 1);
  const bool is_fixed = rounded.numeric == Numeric::fixed32;
  request.numeric = rounded.numeric;
  if (is_fixed) request.bounds = bounds_of(rounded);
  const ErrorParts parts = error_parts(reference, exact, kernel_samples(request, interval, 1));

  double bound = larger(is_fixed ? 2e-9 : 1e-8, 0.1 * parts.method);
  if (rounded.law == Law::hooke_newton && rounded.stepper != Stepper::moment) {
    bound = larger(bound, parts.method);
  } else if (rounded.law == Law::hooke_newton || (rounded.law == Law::hertz && !is_fixed)) {
    double speed = 0;
    for (const Sample& sample : exact) speed = larger(speed, std::abs(sample.v2 - sample.v1));
    const Scene& scene = request.scene;
    const double reduced_mass = scene.main_mass * scene.ball_mass / (scene.main_mass + scene.ball_mass);
    const double steps =
        *contact_time({rounded.law, scene.contact_stiffness, scene.contact_damping, reduced_mass, speed}) /
        rounded.step;
    const double undetermined =
        is_fixed ? 0x1p-31 * (speed + request.bounds->penetration / rounded.step / std::sqrt(steps)) : 0x1p-24 * speed;
    request.numeric = Numeric::float64;
    request.bounds.reset();
    bound = larger(bound, 2 * amplification(request, exact) * undetermined);
  }
  EXPECT_LE(parts.rounding, bound) << "method's error: " << parts.method;
  std::printf("  rounding %.1e m, method %.1e m, bound %.1e m\n", parts.rounding, parts.method, bound);
}

std::vector<Rounded> all() {
  std::vector<Rounded> result;
  for (const Numeric numeric : {Numeric::fixed32, Numeric::float32})
    for (const Stepper stepper : {Stepper::moment, Stepper::average})
      for (const double step : {2e-3, 1e-3, 1e-4, 1e-5}) {
        result.push_back({Law::hertz, Tension::clamp, stepper, numeric, step});
        result.push_back({Law::hunt_crossley, Tension::clamp, stepper, numeric, step});
        // Four steps per contact are too few.
        if (step > 1e-3 && stepper == Stepper::moment) continue;
        result.push_back({Law::hooke_newton, Tension::clamp, stepper, numeric, step});
        result.push_back({Law::hooke_newton, Tension::allow, stepper, numeric, step});
      }
  return result;
}

INSTANTIATE_TEST_SUITE_P(All, Rounding, testing::ValuesIn(all()));

// Where a stop's stiffness is small in the units of a step, it is shifted to the left before it multiplies an impulse.
// Otherwise Fixed32 would differ from double by 1e-9 m in the median of these scenes with narrow bounds.
TEST(RoundingOfAStiffness, IsSmallBesideThatOfTheState) {
  constexpr double step = 1e-4;
  std::vector<double> differences;
  for (int i = 0; i < 40; ++i) {
    const Scene scene = scene_of(0.806, 4.8, 0.008, 0.38, 0.0048, 7.95e8, 1.5e10, 0.1 + 7e-4 * i, 5.75);
    const Bounds narrow{0.0343, 0.199, 0, 0.128};
    auto fixed = accepted<Absorber<AtRunTime, HuntCrossley, Moment, Sine, Fixed32>>(scene, narrow, step);
    auto exact = accepted<Absorber<AtRunTime, HuntCrossley, Moment, Sine, Float64>>(scene, narrow, step);
    double largest = 0;
    for (int n = 0; n < 4000; ++n) {
      fixed.step();
      exact.step();
      largest = larger(largest, std::abs(fixed.reading().x1 - exact.reading().x1));
    }
    differences.push_back(largest);
    EXPECT_TRUE(std::isfinite(largest)) << i;  // a NaN cannot be sorted
  }
  std::sort(differences.begin(), differences.end());
  EXPECT_LT(differences[20], 6e-10);
}

// The free flight of the main mass by Moment's exact flow, against the reference, which has its closed forms
// (reference_test.cpp): resonance, no spring, overdamping and every drive, in every format.
//
// In double the tolerance is 10^4 roundings of 1e-16 of the amplitude. In 32 bits it is that of Rounding for bounds of
// 62.5 mm, and proportional to the bound.

// A ball at rest, half a metre away from its stops.
Request far_from_stops(double step) {
  Request request = paper_request(Law::hertz, Stepper::moment, step);
  request.scene.clearance = 1;
  request.bounds = Bounds{0.5, 8, 0.05, 10};
  return request;
}

void expect_reference(Request request, const char* what) {
  const Samples exact = reference_samples(request, interval, 1);
  const double amplitude = largest_x1(exact);
  for (const auto& [numeric, floor] :
       {std::pair(Numeric::float64, 0.0), {Numeric::fixed32, 8 * 2e-9}, {Numeric::float32, 8 * 1e-8}}) {
    request.numeric = numeric;
    EXPECT_LE(largest_difference(kernel_samples(request, interval, 1), exact), std::max(1e-12 * amplitude, floor))
        << what << " in " << name_of(numeric) << ", amplitude " << amplitude;
  }
}

struct Flight {
  const char* what;
  double main_stiffness, main_damping, drive_pulsation, x1 = 0, v1 = 0;
};
const double own_pulsation = std::sqrt(1000.0);
const Flight flights[] = {{"resonance without damping", 1000, 0, own_pulsation},
                          {"near resonance", 1000, 0, own_pulsation*(1 + 1e-7)},
                          {"the paper's scene near its own pulsation", 1000, 0.01, 31.62},
                          {"a drive of no pulsation", 1000, 0, 0, 0.03},
                          {"a damped vibration", 1000, 2, 0, 0.1, -0.5},
                          {"no spring", 0, 0, 40},
                          {"no spring but a damper", 0, 5, 40},
                          {"three times critical damping", 1000, 6 * own_pulsation, 40, 0.2}};

class FreeFlight : public testing::TestWithParam<double> {};

TEST_P(FreeFlight, IsTheReferences) {
  for (const auto& [what, stiffness, damping, pulsation, x1, v1] : flights)
    for (const DriveKind drive : {DriveKind::sine, DriveKind::none}) {
      Request request = far_from_stops(GetParam());
      request.drive = drive;
      request.scene.main_stiffness = stiffness;
      request.scene.main_damping = damping;
      request.scene.drive_pulsation = pulsation;
      request.scene.x1 = x1;
      request.scene.v1 = v1;
      expect_reference(request, what);
    }
}

TEST_P(FreeFlight, SampledDriveIsLinearBetweenSamples) {
  Request request = far_from_stops(GetParam());
  request.drive = DriveKind::sampled;
  for (int n = 1; n <= std::lround(1 / request.step); ++n) request.samples.push_back(10 * std::sin(1e3 * n * n));
  expect_reference(request, "samples");
}

INSTANTIATE_TEST_SUITE_P(Steps, FreeFlight, testing::Values(2e-3, 1e-3, 1e-4));

}  // namespace
}  // namespace impact::host
