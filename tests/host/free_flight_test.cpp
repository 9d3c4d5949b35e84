// The free flight of the main mass by Moment's exact flow: resonance, no spring, overdamping and every drive, in every
// format.
//
// In double the tolerance is 10^4 roundings of 1e-16 of the amplitude. In 32 bits it is that of accuracy_test.cpp for
// bounds of 62.5 mm, and proportional to the bound.

#include "paper_runs.hpp"

namespace impact::host {
namespace {

constexpr double interval = 2e-3;

// A ball at rest, half a metre away from its stops.
Request far_from_stops(double step) {
  Request request = paper_request(Law::hertz, Stepper::moment, step);
  request.scene.clearance = 1;
  request.bounds = Bounds{0.5, 8, 0.05, 10};
  return request;
}

double floor_of(Numeric numeric) {
  switch (numeric) {
    case Numeric::fixed32:
      return 8 * 2e-9;
    case Numeric::float32:
      return 8 * 1e-8;
    default:
      return 0;
  }
}

// Compares x1 with a function of time.
template <class Exact> void expect_motion(Request request, Exact exact) {
  for (const Numeric numeric : {Numeric::float64, Numeric::fixed32, Numeric::float32}) {
    request.numeric = numeric;
    double error = 0, amplitude = 0;
    for (const Sample& sample : kernel_samples(request, interval, 1)) {
      error = larger(error, std::abs(sample.x1 - exact(sample.t)));
      amplitude = larger(amplitude, std::abs(exact(sample.t)));
    }
    EXPECT_LE(error, std::max(1e-12 * amplitude, floor_of(numeric)))
        << name_of(numeric) << ", h = " << request.step << ", amplitude " << amplitude;
  }
}

void expect_reference(const Request& request) {
  const Samples samples = reference_samples(request, interval, 1);
  expect_motion(request, [&](double t) { return samples[static_cast<size_t>(std::lround(t / interval))].x1; });
}

class FreeFlight : public testing::TestWithParam<double> {};

TEST_P(FreeFlight, GrowsAtResonanceWithoutDamping) {
  Request request = far_from_stops(GetParam());
  request.scene.main_damping = 0;
  const double w = request.scene.drive_pulsation = std::sqrt(request.scene.main_stiffness / request.scene.main_mass);
  const double rate = request.scene.drive_amplitude / (2 * request.scene.main_mass * w * w);
  expect_motion(request, [&](double t) { return rate * (std::sin(w * t) - w * t * std::cos(w * t)); });
}

TEST_P(FreeFlight, NearResonance) {
  Request request = far_from_stops(GetParam());
  request.scene.main_damping = 0;
  request.scene.drive_pulsation = std::sqrt(request.scene.main_stiffness / request.scene.main_mass) * (1 + 1e-7);
  expect_reference(request);
}

TEST_P(FreeFlight, PaperSceneAtItsOwnPulsation) {
  Request request = far_from_stops(GetParam());
  request.scene.drive_pulsation = 31.62;
  expect_reference(request);
}

TEST_P(FreeFlight, DriveOfNoPulsationIsNone) {
  Request request = far_from_stops(GetParam());
  request.scene.drive_pulsation = 0;
  for (const Numeric numeric : {Numeric::float64, Numeric::fixed32, Numeric::float32, Numeric::float32_plain}) {
    request.numeric = numeric;
    for (const Sample& sample : kernel_samples(request, interval, 0.1)) EXPECT_EQ(sample.x1, 0) << name_of(numeric);
  }
  request.scene.main_damping = 0;
  request.scene.x1 = 0.03;
  const double w = std::sqrt(request.scene.main_stiffness / request.scene.main_mass);
  expect_motion(request, [&](double t) { return 0.03 * std::cos(w * t); });
}

TEST_P(FreeFlight, DampedVibrationWithoutDrive) {
  Request request = far_from_stops(GetParam());
  request.drive = DriveKind::none;
  request.scene.main_damping = 2;
  request.scene.x1 = 0.1;
  request.scene.v1 = -0.5;
  const double decay = 1, w = std::sqrt(1000.0 - decay * decay);
  expect_motion(request, [&](double t) {
    return std::exp(-decay * t) * (0.1 * std::cos(w * t) + (-0.5 + decay * 0.1) / w * std::sin(w * t));
  });
}

TEST_P(FreeFlight, WithoutASpring) {
  Request request = far_from_stops(GetParam());
  request.scene.main_stiffness = request.scene.main_damping = 0;
  const double w = request.scene.drive_pulsation, scale = 10 / (w * w);
  expect_motion(request, [&](double t) { return scale * (w * t - std::sin(w * t)); });
  request.scene.main_damping = 5;
  expect_reference(request);
}

TEST_P(FreeFlight, Overdamped) {
  Request request = far_from_stops(GetParam());
  request.scene.main_damping = 6 * std::sqrt(1000.0);  // three times critical
  request.scene.x1 = 0.2;
  expect_reference(request);
}

TEST_P(FreeFlight, SampledDriveIsLinearBetweenSamples) {
  Request request = far_from_stops(GetParam());
  request.drive = DriveKind::sampled;
  for (int n = 1; n <= std::lround(1 / request.step); ++n) request.samples.push_back(10 * std::sin(1e3 * n * n));
  expect_reference(request);
}

INSTANTIATE_TEST_SUITE_P(Steps, FreeFlight, testing::Values(2e-3, 1e-3, 1e-4));

// Newmark's method changes the frequency by (w h)^2 |1/12 - beta|/2 <= (w h)^2/12, relatively. In a time t the phase
// error is at most w t times that.
TEST(PointwiseFlight, GrowsAtResonanceToSecondOrder) {
  for (const Stepper stepper : {Stepper::average, Stepper::linear, Stepper::fox_goodwin, Stepper::central})
    for (const double step : {1e-3, 1e-4}) {
      Request request = far_from_stops(step);
      request.stepper = stepper;
      request.scene.main_damping = 0;
      const double w = request.scene.drive_pulsation = std::sqrt(1000.0);
      const double rate = 10 / (2 * w * w), detuning = w * step * w * step / 12;
      for (const Sample& sample : kernel_samples(request, interval, 1)) {
        const double wt = w * sample.t;
        EXPECT_NEAR(sample.x1, rate * (std::sin(wt) - wt * std::cos(wt)), rate * (1 + wt) * (1 + wt) * detuning)
            << name_of(stepper) << " " << sample.t;
      }
    }
}

}  // namespace
}  // namespace impact::host
