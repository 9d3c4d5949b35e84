#pragma once
// Random numbers for scenes, the same on every machine, and the stiffness of a stop for a given contact time.

#include <cmath>
#include <impact/scene.hpp>
#include <random>

namespace impact {

class Random {
 public:
  explicit Random(unsigned long seed = 1) : bits_(seed) {}
  double share() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }  // from 0 to 1
  double between(double least, double most) { return least + (most - least) * share(); }
  double wide(double least, double most) { return least * std::pow(most / least, share()); }  // log-uniform
  bool is(double chance) { return share() < chance; }
  template <class Value, size_t size> Value one_of(const Value (&values)[size]) { return values[bits_() % size]; }

 private:
  std::mt19937_64 bits_;
};

// Sets the stiffness at which an undamped impact at `speed` takes `contact_time`. Returns the penetration, m.
inline double set_contact_time(Scene& scene, bool is_linear, double contact_time, double speed) {
  const double mu = 1 / (1 / scene.main_mass + 1 / scene.ball_mass), pi = 3.141592653589793;
  scene.contact_stiffness = is_linear ? mu * pi * pi / (contact_time * contact_time)
                                      : mu * std::pow(3.218 / contact_time, 2.5) / std::sqrt(speed);
  return is_linear ? speed * contact_time / pi : std::pow(1.25 * mu * speed * speed / scene.contact_stiffness, 0.4);
}

}  // namespace impact
