#pragma once
// Random scenes of the coupled machine: a ball between two stops in a mass on a spring, undriven and undamped but for
// its contacts, over masses 1e-2 to 1e2 kg, mass ratios 1e-3 to 1e3, w0 h up to 0.9, stiffnesses 1e2 to 1e13,
// clearances 1e-5 to 0.1 m, and two edges of that: a ball that crosses its clearance within a step, and a ball of three
// to a thousand times the main mass. The bounds are what the energy at the start allows, no tighter and no wider.

#include <random>
#include <string>

#include "host_ref/simulation.hpp"

namespace impact::host {

enum class Edge { none, crossing, heavy_ball };

struct CoupledScene {
  Request request;
  double energy = 0;  // at the start, J
};

// The same for the same index, on every machine.
CoupledScene coupled_scene(Law law, Edge edge, unsigned index);

double energy_of(const Scene& scene, const Sample& sample);  // of masses and main spring, J

// The command that runs it.
std::string text_of(const Request& request);

// Steps the scene and keeps the largest energy seen while the ball is apart.
struct CoupledRun {
  bool is_accepted = false, has_fault = false;
  double gain = 0;      // over the energy at the start
  double returned = 0;  // what the ledger ever went back by, over the energy at the start
};
CoupledRun run_coupled(const CoupledScene& scene, long steps);

}  // namespace impact::host
