// The smallest firmware with one absorber. A configuration's memory is this image's size minus that of the image
// without an absorber.

#ifdef IMPACT_LABEL

#include "configurations.hpp"

namespace impact::target {

// The budgeted configuration with this label.
template <class First, class... Others> constexpr auto labelled(List<First, Others...>) {
  if constexpr (is_same(First::label.text, IMPACT_LABEL))
    return First{};
  else
    return labelled(List<Others...>{});
}
using Measured = decltype(labelled(Budgeted{} + BudgetedWithParts{}));

}  // namespace impact::target

using impact::target::Measured;

static Measured::Absorber<100> absorber;

[[gnu::noinline]] static void step() { Measured::advance(absorber); }

#else

static void step() {}

#endif

int main() {
  for (;;) step();
}
