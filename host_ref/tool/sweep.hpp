#pragma once
// Many scenes: one a line of a CSV whose header names options, one summary row each, on all cores. A row is
//
//     scene,<the options given>,max_x1,rms_x1,attenuation,energy_dissipated,impacts,fault
//
// with a column drive_samples before max_x1 where a drive file is among the options: a fingerprint of its samples, so
// that rows of a file that has changed since are not taken for those of this sweep.
// scene: number of the line among the scenes, from 1. attenuation: 1 - max |x1| / max |x1| of the same main mass
// without absorber; empty when that does not move. Rows are written as scenes finish. With --output, rows that a file
// of the same sweep already holds are kept, a torn last one is dropped, and a finished file is put in the order of the
// scenes.

#include <host_ref/tool/options.hpp>

namespace impact::host {

// Returns the exit code: 0, or 3 when the kernel raised a fault in a scene.
int run_sweep(const Settings& settings, const std::vector<Argument>& arguments);

}  // namespace impact::host
