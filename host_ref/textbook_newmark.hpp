#pragma once
// Methods as textbooks describe them, for the absorber's two coordinates x1 and x2 in matrices,
//
//     M x'' + C x' + K x + N(x, x') = F(t)
//
// Newmark's family (Newmark 1959; Hughes, The Finite Element Method, ch. 9) with gamma = 1/2 in acceleration form,
// solved by Newton's method with the full tangent, and the classical Runge-Kutta method. The tests compare the kernel's
// classical schemes with them, and they are a baseline of the report.

#include <Eigen/Dense>

#include "host_ref/reference.hpp"

namespace impact::host {

// The absorber by Newmark's method. The trial penetration is that of a step without contact force at its end. If it is
// positive, the contact force at the end of the step is that of the law at that state, else 0. Clamped, it is at least
// 0. A power of a negative penetration is 0. c1 is constant, and a sample has no energies and no peak force.
class TextbookNewmark {
 public:
  TextbookNewmark(const Case& run, double beta, double step);
  void step();
  const Sample& sample() const { return sample_; }

 private:
  struct Motion {
    Eigen::Vector2d displacement, velocity, acceleration;
  };
  // The state at the end of a step in which the stop of this side is touched, 0 for none, and its force there.
  Motion step_end(double drive, int side, double& force) const;

  Case run_;
  double beta_, step_;
  Eigen::Matrix2d mass_, damping_, stiffness_;
  Motion motion_;
  int side_ = 0;  // of the stop in contact, 0 for none
  long steps_ = 0;
  Sample sample_;
};

// The same by the classical Runge-Kutta method of fourth order. Each stage has the force of its own penetration. A
// sample does not count impacts.
class TextbookRungeKutta {
 public:
  TextbookRungeKutta(const Case& run, double step);
  void step();
  const Sample& sample() const { return sample_; }

 private:
  Case run_;
  double step_;
  long steps_ = 0;
  Sample sample_;
};

}  // namespace impact::host
