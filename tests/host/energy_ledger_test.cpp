// The energy ledger over half a second of the paper's scene. Dissipation by contact and work of the drive are compared
// with the reference, and their balance with the energies of the motion.

#include "paper_runs.hpp"

namespace impact::host {
namespace {

constexpr double duration = 0.5;

struct Variant {
  Law law;
  Tension tension;
};
constexpr Variant variants[] = {{Law::hertz, Tension::clamp},
                                {Law::hunt_crossley, Tension::clamp},
                                {Law::hooke_newton, Tension::clamp},
                                {Law::hooke_newton, Tension::allow}};

// The largest errors over the run, J. The balance, at instants without contact, is the sum of kinetic energies, main
// spring, main damper and dissipation by contact, minus the work of the drive. The trapezoidal rule suffices for the
// damper, since c is small.
struct Errors {
  double dissipated, drive_work, balance;
};

Errors errors_of(const Request& request) {
  const Samples kernel = kernel_samples(request, request.step, duration);
  const Samples reference = reference_samples(request, request.step, duration);
  const Scene& scene = request.scene;
  Errors largest{};
  double damped = 0;
  for (size_t n = 1; n < kernel.size(); ++n) {
    const Sample &before = kernel[n - 1], &now = kernel[n];
    const auto keep = [](double& most, double error) { most = larger(most, std::abs(error)); };
    damped += scene.main_damping * request.step * (before.v1 * before.v1 + now.v1 * now.v1) / 2;
    if (now.penetration > 0) continue;
    keep(largest.dissipated, now.energy_dissipated - reference[n].energy_dissipated);
    keep(largest.drive_work, now.drive_work - reference[n].drive_work);
    keep(largest.balance, mechanical_energy(scene, now) + now.energy_dissipated + damped - now.drive_work);
  }
  return largest;
}

// With Moment, the motion's error is negligible compared with the ledger's. The ledger assumes drive and rates that are
// linear in a step, so it is of second order. For Hooke-Newton the factor depends on where in their steps the force
// jumps. At 1 ms the error is below 1 % of an impact's 0.3 J, and that of what is dissipated below 0.1 %.
TEST(EnergyLedger, IsOfSecondOrder) {
  for (const auto& [law, tension] : variants) {
    const Errors coarse = errors_of(paper_request(law, Stepper::moment, 1e-3, tension));
    for (const double error : {coarse.dissipated, coarse.drive_work, coarse.balance}) EXPECT_LT(error, 3e-3);
    EXPECT_LT(coarse.dissipated, 3e-4);
    for (const double step : {5e-4, 2.5e-4, 1.25e-4, 1e-5}) {
      const Errors error = errors_of(paper_request(law, Stepper::moment, step, tension));
      const double fall = (law == Law::hooke_newton ? 3 : 1.25) * step * step / 1e-6;
      EXPECT_LT(error.dissipated, fall * coarse.dissipated) << name_of(law) << " " << step;
      EXPECT_LT(error.drive_work, fall * coarse.drive_work) << name_of(law) << " " << step;
      EXPECT_LT(error.balance, fall * coarse.balance) << name_of(law) << " " << step;
    }
  }
}

// With average acceleration these rules are an exact balance. The remaining error is that of the test's sum over the
// main damper, c h^2/12 of the change of d(v1^2)/dt: c h^2/12 * 0.5 s * (2 * 40/s)^2 * (1 m/s)^2.
TEST(EnergyLedger, BalancesAverageAcceleration) {
  for (const auto& [law, tension] : variants)
    for (const double step : {1e-3, 1e-4}) {
      EXPECT_LT(errors_of(paper_request(law, Stepper::average, step, tension)).balance,
                0.01 * step * step / 12 * 0.5 * 6400)
          << name_of(law) << " " << step;
    }
}

// The ledger in 32 bits against double. Fixed32 rounds the three factors of an entry to 2^-31 of at most 2 J: an
// average force at its bound times a penetration of 2^-6 m. Float32 rounds some 5 J to 24 bits, and its motion by 2e-7
// m with 10 N.
TEST(EnergyLedger, In32BitsIsThatOfDouble) {
  for (const auto& [law, tension] : variants)
    for (const double step : {1e-3, 1e-4, 1e-5}) {
      Request request = paper_request(law, Stepper::moment, step, tension);
      const Sample exact = kernel_samples(request, duration, duration).back();
      request.bounds = Bounds{0.0625, 2, 0.0156, 10};
      for (const Numeric numeric : {Numeric::fixed32, Numeric::float32}) {
        request.numeric = numeric;
        const Sample rounded = kernel_samples(request, duration, duration).back();
        const double bound =
            numeric == Numeric::fixed32 ? 3 * 2 * 0x1p-31 * duration / step + 2e-7 : 5 * 0x1p-24 + 2e-6;
        EXPECT_NEAR(rounded.energy_dissipated, exact.energy_dissipated, bound) << name_of(law) << " " << step;
        EXPECT_NEAR(rounded.drive_work, exact.drive_work, bound) << name_of(law) << " " << step;
      }
    }
}

// The bound of displacement allows rates of a step that are 10^4 times the penetrations. With their unit as that of
// forces, an LSB was 8 N, and the second step of this contact, whose force is 2.4 N on average, did no work. An LSB of
// v2 changes the work by 1e-5, and the phase of the contact in the step by 2e-3.
TEST(EnergyLedger, OfFixed32HasWorkOfForcesFarBelowTheUnitOfRates) {
  Request request;
  request.scene =
      scene_of(18.056230048672653, 562375.8718658582, 0, 19.900048007607214, 0.06982344970793633, 6362103156295.825,
               661965128952583, 0, 0, 0, -0.0025345495425073373, 0.03321885695634879, 0.004800608406780541);
  request.drive = DriveKind::none;
  request.step = 1.4685487050347006e-3;
  request.bounds = Bounds{0.03530191581408315, 0.005697610099778938};
  for (const Stepper stepper : {Stepper::automatic, Stepper::moment_n}) {
    request.stepper = stepper;
    request.numeric = Numeric::float64;
    const Sample exact = kernel_samples(request, duration, duration).back();
    request.numeric = Numeric::fixed32;
    const Sample rounded = kernel_samples(request, duration, duration).back();
    EXPECT_GT(exact.impacts, 0);
    EXPECT_NEAR(rounded.energy_dissipated, exact.energy_dissipated, 2e-3 * exact.energy_dissipated);
  }
}

}  // namespace
}  // namespace impact::host
