#pragma once
// What the tool does with its settings.

#include <host_ref/tool/options.hpp>

namespace impact::host {

// The main job: one scene as CSV, one row every N steps, its plot and its rig. Returns the exit code: 0, or 3 if the
// kernel raised a fault.
int write_trajectory(const Settings& settings, const std::vector<Argument>& arguments);

// Runs many scenes on all cores. The input is a CSV whose header names options, with one scene per line. The output has
// one row per scene:
//
//     scene,<the stated options>,max_x1,rms_x1,attenuation,energy_dissipated,impacts,fault
//
// `scene` is the number of the line among the scenes, from 1. `attenuation` is 1 - max |x1| / max |x1| of the same main
// mass without absorber, and empty if that does not move. With a drive file there is a column drive_samples before
// max_x1. It is a fingerprint of the samples, so that rows from an older version of the file are detected.
//
// A row is written when its scene is finished. With --output, the rows that an interrupted run of the same sweep left
// are kept, and an incomplete last one is dropped. A finished file is sorted in the order of the scenes.
//
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
