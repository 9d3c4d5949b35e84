// The paper's claims about its figures, tested with the kernel's numbers, and the conventions on which they depend.
//
// The paper states neither the drive's frequency nor the definition of its clearance. Its amplitudes follow with 40
// rad/s, stops at +-d/2, a start at rest in the middle, and 5 s of motion. The natural frequency of the main mass is
// 31.62 rad/s. Driven at that, without absorber, it would grow without bound.
//
// Nor does it state how c1 follows from a variable restitution e (figure 8). It may follow from (2.3) and (2.9) at one
// speed, here 0.8 m/s, or from (2.9) at each impact. Or it may be the c1 for which the law has that e at that speed.
// The paper does not state either whether Hooke-Newton may pull.
//
// After some 3 s the motion with Hertz and Hooke-Newton depends on rounding. Claims about them are tested on 33 starts
// of the ball within 0.16 mm of the middle, by median or by number.

#include "paper_runs.hpp"

namespace impact::host {
namespace {

constexpr double interval = 2e-3;

Request bare_request() {
  Request request = paper_request(Law::hertz, Stepper::moment, 1e-3);
  request.scene.clearance = 1;
  return request;
}

// Largest |x1| and energy dissipated by contact for each of the 33 starts, in ascending order.
struct Starts {
  std::vector<double> maxima, dissipated;
  double median_maximum() const { return maxima[16]; }
  double median_dissipated() const { return dissipated[16]; }
};
Starts starts(Request request, double duration = 5) {
  Starts result;
  for (int i = -16; i <= 16; ++i) {
    request.scene.x2 = 1e-5 * i;
    const Samples samples = kernel_samples(request, interval, duration);
    result.maxima.push_back(largest_x1(samples));
    result.dissipated.push_back(samples.back().energy_dissipated);
    EXPECT_TRUE(std::isfinite(result.maxima.back() + result.dissipated.back())) << i;  // a NaN cannot be sorted
  }
  std::sort(result.maxima.begin(), result.maxima.end());
  std::sort(result.dissipated.begin(), result.dissipated.end());
  return result;
}

// The ways to determine c1 from a restitution.
enum class From { paper, law, each_impact };

Request request_with(Law law, Tension tension, double e, From from) {
  // Hooke-Newton without damping requires ten steps per contact.
  Request request = paper_request(law, Stepper::moment, law == Law::hooke_newton && e == 1 ? 5e-4 : 1e-3, tension);
  if (law == Law::hertz) return request;
  const Impact impact{law, 32600, 0, 0.3 / 1.3, 0.8, tension};
  request.scene.contact_damping =
      from == From::law ? contact_damping(impact, e).value() : paper_contact_damping(impact, e).value();
  if (from == From::each_impact && law == Law::hunt_crossley) {
    request.damping = Damping::hunt_crossley;
    request.scene.restitution = e;
  }
  return request;
}

TEST(PaperClaims, BareSystemReaches37Point6Millimetres) {
  for (const double duration : {2.0, 5.0})
    EXPECT_NEAR(largest_x1(kernel_samples(bare_request(), interval, duration)), 37.6e-3, 0.06e-3);
}

TEST(PaperClaims, HuntCrossleyAttenuatesTo17Point6Millimetres) {
  const Samples reference = reference_samples(paper_request(Law::hunt_crossley, Stepper::moment, 1e-4), interval, 5);
  EXPECT_NEAR(largest_x1(reference), 17.6e-3, 0.05e-3);
  for (const Stepper stepper :
       {Stepper::moment, Stepper::average, Stepper::linear, Stepper::fox_goodwin, Stepper::central}) {
    const Samples samples = kernel_samples(paper_request(Law::hunt_crossley, stepper, 1e-4), interval, 5);
    // In this scene errors decay, so no figure can show them.
    EXPECT_LT(largest_difference(samples, reference), 1e-5) << name_of(stepper);
  }
}

TEST(PaperClaims, HookeNewtonAttenuatesToTheSame) {
  for (const Tension tension : {Tension::clamp, Tension::allow}) {
    const Starts all = starts(paper_request(Law::hooke_newton, Stepper::moment, 1e-3, tension));
    EXPECT_NEAR(all.median_maximum(), 17.6e-3, 0.2e-3);
    EXPECT_LT(all.maxima.back(), largest_x1(kernel_samples(bare_request(), interval, 5)));
  }
}

// With Hertz the main mass can exceed the 37.55 mm of the system without absorber, as the paper's figure 4 shows. In 5
// s 3 of 33 starts do so (the exact middle: 38.1 mm by the reference), in 20 s half of them. The root mean square is
// below that without absorber. No start attenuates as much as the other laws.
TEST(PaperClaims, HertzCanAmplify) {
  const double bare = largest_x1(kernel_samples(bare_request(), interval, 5));
  const Request hertz = paper_request(Law::hertz, Stepper::moment, 1e-3);
  const auto amplified = [bare](const Starts& all) {
    return std::count_if(all.maxima.begin(), all.maxima.end(), [bare](double x) { return x > bare; });
  };
  const Starts in_5_seconds = starts(hertz), in_20_seconds = starts(hertz, 20);
  EXPECT_GE(amplified(in_20_seconds), 1);
  for (const Law law : {Law::hooke_newton, Law::hunt_crossley})
    EXPECT_EQ(amplified(starts(paper_request(law, Stepper::moment, 1e-3), 20)), 0);
  for (const Law law : {Law::hooke_newton, Law::hunt_crossley})
    EXPECT_GT(in_5_seconds.maxima.front(), starts(paper_request(law, Stepper::moment, 1e-3)).median_maximum());
}

// Figure 8 at e = 1, where nothing dissipates: Hunt-Crossley equals Hertz, and Hooke-Newton stays below both.
TEST(PaperClaims, WithoutDampingHookeNewtonIsLowest) {
  const Request hertz = paper_request(Law::hertz, Stepper::moment, 1e-3);
  const Request hunt_crossley = request_with(Law::hunt_crossley, Tension::clamp, 1, From::law);
  EXPECT_EQ(hunt_crossley.scene.contact_damping, 0);
  // The formulas are the same, with terms of 0 in one. Only amplified rounding differs, as in accuracy_test.cpp.
  EXPECT_LT(largest_difference(kernel_samples(hertz, interval, 1), kernel_samples(hunt_crossley, interval, 1)), 1e-12);
  EXPECT_LT(starts(request_with(Law::hooke_newton, Tension::clamp, 1, From::law)).median_maximum(),
            starts(hertz).median_maximum());
}

// Figure 8 at e = 0.68: Hunt-Crossley has the lowest maximum in 5 s for a constant c1, by either formula, with tension
// or without. With c1 from each impact's speed this is false, since slow impacts then lose less. It is also false over
// 20 s with the paper's c1: the motion changes to another one, of 26 mm.
TEST(PaperClaims, AtTheStatedRestitutionHuntCrossleyIsLowest) {
  for (const Tension tension : {Tension::clamp, Tension::allow})
    for (const From from : {From::paper, From::law}) {
      const auto maximum_of = [&](Law law) { return starts(request_with(law, tension, 0.68, from)).median_maximum(); };
      const double hooke_newton = maximum_of(Law::hooke_newton), hertz = maximum_of(Law::hertz);
      EXPECT_LT(maximum_of(Law::hunt_crossley), hooke_newton);
      EXPECT_LT(hooke_newton, hertz);
    }
  EXPECT_GT(starts(request_with(Law::hunt_crossley, Tension::clamp, 0.68, From::each_impact)).median_maximum(), 18e-3);
  EXPECT_GT(starts(request_with(Law::hunt_crossley, Tension::clamp, 0.68, From::paper), 20).median_maximum(), 18e-3);
}

// Figure 8: over restitutions from 0.3 to 1, Hunt-Crossley's maximum varies more than Hooke-Newton's, for each
// convention of c1.
TEST(PaperClaims, HuntCrossleyIsMoreSensitiveToRestitution) {
  for (const From from : {From::paper, From::law, From::each_impact}) {
    const auto spread = [from](Law law) {
      double least = 1, most = 0;
      for (const double e : {0.3, 0.5, 0.68, 0.8, 0.9, 1.0}) {
        const double x = starts(request_with(law, Tension::clamp, e, from)).median_maximum();
        least = smaller(least, x);
        most = larger(most, x);
      }
      return most - least;
    };
    EXPECT_GT(spread(Law::hunt_crossley), spread(Law::hooke_newton));
  }
}

// Figure 10, energy dissipated in 5 s: Hunt-Crossley's is above Hooke-Newton's, and Hertz dissipates none. At e = 0.68
// this is true for each convention, and for all restitutions if c1 gives the law that restitution. With the paper's
// formulas impacts lose less than e says, and Hooke-Newton dissipates most below e = 0.5 (0.6 with tension).
TEST(PaperClaims, HuntCrossleyDissipatesMost) {
  const auto dissipated = [](Law law, Tension tension, double e, From from) {
    return starts(request_with(law, tension, e, from)).median_dissipated();
  };
  for (const Tension tension : {Tension::clamp, Tension::allow}) {
    for (const From from : {From::paper, From::law, From::each_impact}) {
      EXPECT_GT(dissipated(Law::hunt_crossley, tension, 0.68, from),
                dissipated(Law::hooke_newton, tension, 0.68, from));
    }
    for (const double e : {0.3, 0.5, 0.8, 0.9}) {
      const double hooke_newton = dissipated(Law::hooke_newton, tension, e, From::law);
      EXPECT_GT(dissipated(Law::hunt_crossley, tension, e, From::law), hooke_newton) << e;
      EXPECT_GT(hooke_newton, 0.5);
    }
    EXPECT_GT(dissipated(Law::hooke_newton, tension, 0.3, From::paper),
              dissipated(Law::hunt_crossley, tension, 0.3, From::paper));
  }
  // The tolerance is the ledger's own error (energy_ledger_test.cpp).
  EXPECT_NEAR(dissipated(Law::hertz, Tension::clamp, 1, From::law), 0, 1e-4);
}

}  // namespace
}  // namespace impact::host
