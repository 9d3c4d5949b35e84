// The smallest firmware around one absorber. What a configuration takes is this image's size less that of the one
// without an absorber.

#ifdef IMPACT_CONFIGURATION

#include "configurations.hpp"

using Measured = impact::target::Configuration<IMPACT_CONFIGURATION>;

static Measured::Absorber<100> absorber;

[[gnu::noinline]] static void step() { Measured::advance(absorber, 0); }

#else

static void step() {}

#endif

int main() {
  for (;;) step();
}
