#pragma once
// Random scenes of the coupled machine: a ball between two stops in a mass on a spring, undamped but for its contacts,
// over masses 1e-2 to 1e2 kg, mass ratios 1e-3 to 1e3, w0 h up to 0.9, stiffnesses 1e2 to 1e13, clearances 1e-5 to 0.1
// m, and two edges of that: a ball that crosses its clearance within a step, and a ball of three to a thousand times
// the main mass. Undriven, driven by a sine of 1e-4 to 2.9 rad a step, half of them within 5 % of the main mass's own,
// or by samples: noise, a square wave, or a force that always pushes where the main mass goes.
//
// The bounds are what the energy at the start and the drive allow, no tighter and no wider: with E the energy of all,
// E' <= F |v1| and |v1| <= (2 E/M)^(1/2), so that (2 E)^(1/2) grows by no more than F t/M^(1/2), and in a field of a by
// no more than a t (M + m)^(1/2).

#include <array>
#include <string>

#include "host_ref/simulation.hpp"

namespace impact::host {

enum class Edge { none, crossing, heavy_ball };
enum class Samples { noise, square_wave, along };

struct CoupledScene {
  Request request;
  long steps = 0;
  double energy = 0;                 // at the start, J
  Samples samples = Samples::noise;  // of drive and base
  double base = 0;                   // the base's largest acceleration, m/s^2
};

// What a scene is drawn by: each coordinate from 0 to 1. The last three are of its parts.
constexpr size_t coordinates = 18;
using Place = std::array<double, coordinates>;
enum class Parts { none, some };
CoupledScene coupled_scene(Law law, Edge edge, DriveKind drive, Parts parts, const Place& place);

// One at random, the same for the same index on every machine: every other one is driven.
CoupledScene coupled_scene(Law law, Edge edge, unsigned index, Parts parts = Parts::none);

// The command that runs it. It names the files of samples, one a step, that only the run itself knows.
constexpr const char *drive_file = "FORCES", *base_file = "ACCELERATIONS";
std::string text_of(const Request& request);

// Steps the scene. The energy that contact has made is that of both masses and the main spring, less the energy at the
// start and the work of drive and field; counted while the ball is apart, over the energy at the start and the most
// work until then. The work is that of the exact flight, and in a step with contact or friction that on the
// displacement x by them as well: it lies between x times the least and the largest force in the step, and the most is
// taken.
struct CoupledRun {
  bool is_accepted = false, has_fault = false;
  bool is_warned = false;  // of a stepper that was named, that it may gain energy
  double gain = 0;
  double returned = 0;  // what the ledger ever went back by, over the same
  // The same gain with what friction's ledger has taken, and what that ever went back by.
  double rubbed = 0;
};
CoupledRun run_coupled(const CoupledScene& scene);

}  // namespace impact::host
