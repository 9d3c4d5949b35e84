#pragma once
// Random scenes of the coupled machine: a ball between two stops in a mass on a spring. Only the contacts are damped.
//
//     main mass 1e-2 to 1e2 kg     mass ratio 1e-3 to 1e3      w0 h up to 0.9
//     stiffness 1e2 to 1e13        clearance 1e-5 to 0.1 m
//
// Some scenes are at an edge: a ball that crosses its clearance within a step, or one of 3 to 1000 times the main mass.
// The drive is none, a sine of 1e-4 to 2.9 rad per step, or samples. Half of the sines are within 5 % of the main
// mass's own frequency. Samples are noise, a square wave, or a force that always pushes in the direction of motion.
//
// The bounds are exactly what the energy at the start and the drive allow. With the total energy E, E' <= F |v1| and
// |v1| <= (2 E/M)^(1/2). Therefore (2 E)^(1/2) grows by at most F t/M^(1/2), and in a field a by at most a t (M +
// m)^(1/2).

#include <array>
#include <string>

#include "host_ref/simulation.hpp"

namespace impact::host {

enum class Edge { none, crossing, heavy_ball };
inline constexpr Edge every_edge[] = {Edge::none, Edge::crossing, Edge::heavy_ball};
enum class Samples { noise, square_wave, along };

struct CoupledScene {
  Request request;
  long steps = 0;
  double energy = 0;                 // at the start, J
  Samples samples = Samples::noise;  // of drive and base
  double base = 0;                   // the base's largest acceleration, m/s^2
};

// The coordinates of a scene, each from 0 to 1. The last three are for its parts.
constexpr size_t coordinates = 18;
using Place = std::array<double, coordinates>;
enum class Parts { none, some };
CoupledScene coupled_scene(Law law, Edge edge, DriveKind drive, Parts parts, const Place& place);

// A random scene. The same index gives the same scene on every machine. Every second scene has a drive.
CoupledScene coupled_scene(Law law, Edge edge, unsigned index, Parts parts = Parts::none);

// The command that runs a scene. Its files of samples, one per step, exist only in the run itself.
constexpr const char *drive_file = "FORCES", *base_file = "ACCELERATIONS";
std::string text_of(const Request& request);

// Steps the scene. The energy gain of contacts is the energy of both masses and the main spring, minus the energy at
// the start and the work of drive and field. It is measured while the ball is apart, relative to the energy at the
// start plus the largest work until then. The work is that of the exact flight. Contact and friction may move a mass by
// a further x in a step. The work on x lies between x times the smallest and x times the largest force in the step, and
// the larger one counts.
struct CoupledRun {
  bool is_accepted = false, has_fault = false;
  double gain = 0;
  double returned = 0;  // the largest decrease of the ledger, relative to the same energy
  // The same two numbers with friction and its ledger.
  double rubbed = 0, rubbed_back = 0;
};
CoupledRun run_coupled(const CoupledScene& scene);

}  // namespace impact::host
