#include "host_ref/simulation_of.hpp"

template impact::host::Planned impact::host::plan_simulation<impact::Float32Plain>(const Request&, const Bounds&);
