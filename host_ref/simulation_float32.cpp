#include "host_ref/simulation_of.hpp"

template impact::host::Planned impact::host::plan_simulation<impact::Float32>(const Request&, const Bounds&);
