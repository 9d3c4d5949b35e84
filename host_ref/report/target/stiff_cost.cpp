// What a second at a stop like steel costs: instructions of the kernel's formats for this core, and of event-rk4 in
// float with newlib's sine and power. A row is target,method,numeric,microseconds,contact_steps,instructions of the
// whole run.

#include <board/console.hpp>
#include <host_ref/report/stiff_scene.hpp>

#include "instruction_counter.hpp"

extern "C" int* __errno() {
  static int error;
  return &error;
}

namespace impact::report {
namespace {

struct Counted {
  template <class Model>
  void operator()(const char* method, const char* numeric, int microseconds, int contact_steps, Model& model) const {
    uint32_t instructions = 0;
    for (int i = 0; i < static_cast<int>(stiff_duration * 1e6 / microseconds + 0.5); ++i)
      instructions += target::instructions_of([](void* run) { static_cast<Model*>(run)->step(); }, &model);
    board::print(IMPACT_TARGET ",", method, ",", numeric, ",", static_cast<uint32_t>(microseconds), ",",
                 static_cast<uint32_t>(contact_steps), ",", instructions, "\n");
  }
};

}  // namespace
}  // namespace impact::report

int main() {
  using namespace impact;
  board::print("target,method,numeric,microseconds,contact_steps,instructions\n");
#ifdef IMPACT_HAS_FPU
  report::run_at_steel<Float32>("float32", report::Counted{});
  report::run_at_steel<Float32Plain>("float32-plain", report::Counted{});
#else
  report::run_at_steel<Fixed32>("fixed32", report::Counted{});
#endif
  report::run_events_at_steel(report::Counted{});
  return 0;
}
