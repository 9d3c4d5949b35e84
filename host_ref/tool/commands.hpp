#pragma once
// What the tool does with its settings.

#include <host_ref/tool/options.hpp>

namespace impact::host {

// The main job: one scene as CSV, one row every N steps, its plot and its rig. Returns the exit code: 0, or 3 if the
// kernel raised a fault.
int write_trajectory(const Settings& settings, const std::vector<Argument>& arguments);

// Runs many scenes on all cores (README.md, Sweeps). A row is written when its scene is finished. The fingerprint in
// drive_samples shows rows from an older version of the file. With --output, the rows that an interrupted run of the
// same sweep left are kept, and an incomplete last one is dropped. A finished file is in the order of the scenes.
// Returns the exit code: 0, or 3 if the kernel raised a fault in a scene.
int run_sweep(const Settings& settings, const std::vector<Argument>& arguments);

// Nanoseconds per step on this machine for each law, stepper and number format: law,newmark,numeric,host_ns_per_step.
// It is the paper's scene over 2 s at h = 0.1 ms, for impulsive with stops of 10^6 times the stiffness. The fastest of
// five runs counts, because disturbances only slow a run down.
void write_benchmark(const Settings& settings);

// A header for firmware with the scene, bounds, step and types of a run. Its absorber computes the same bits. `made` is
// the request as it was planned. `arguments` is the command, which the header has as a comment.
std::string rig_text(const Request& made, const std::vector<Argument>& arguments);

}  // namespace impact::host
