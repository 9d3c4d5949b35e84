#include "host_ref/simulation_of.hpp"

template impact::host::Planned impact::host::plan_simulation<impact::Fixed32>(const Request&, const Bounds&);
