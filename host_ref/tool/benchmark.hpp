#pragma once
// Nanoseconds per step on this machine for each law, stepper and number format: law,newmark,numeric,host_ns_per_step.
// It is the paper's scene over 2 s at h = 0.1 ms, for impulsive with stops of 10^6 times the stiffness. The fastest of
// five runs counts, because disturbances only slow a run down.

#include <host_ref/tool/settings.hpp>

namespace impact::host {

void write_benchmark(const Settings& settings);

}  // namespace impact::host
