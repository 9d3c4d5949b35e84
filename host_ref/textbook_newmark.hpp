#pragma once
// Methods as textbooks describe them, for a system of n degrees of freedom in matrices,
//
//     M x'' + C x' + K x + N(x, x') = F(t)
//
// Newmark's family (Newmark 1959; Hughes, The Finite Element Method, ch. 9) with gamma = 1/2 in acceleration form,
// solved by Newton's method with the full tangent, and the classical Runge-Kutta method. The absorber uses them with
// the two coordinates x1 and x2. The tests compare the kernel's classical schemes with them, and they are a baseline of
// the report.

#include <Eigen/Dense>
#include <functional>

#include "host_ref/reference.hpp"

namespace impact::host {

struct LinearSystem {
  Eigen::MatrixXd mass, damping, stiffness;
};

struct Motion {
  Eigen::VectorXd displacement, velocity, acceleration;
};

// N and its tangents dN/dx and dN/dx'.
struct InternalForce {
  Eigen::VectorXd force;
  Eigen::MatrixXd stiffness, damping;
};
using InternalForceLaw =
    std::function<InternalForce(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity)>;

// The state a step h after `start`. `external` is F at the end of the step. `start` contains the acceleration at its
// instant.
Motion newmark_step(const LinearSystem& system, double beta, double h, const Motion& start,
                    const Eigen::VectorXd& external, const InternalForceLaw& internal);

// The absorber by Newmark's method. The trial penetration is that of a step without contact force at its end. If it is
// positive, the contact force at the end of the step is that of the law at that state, else 0. Clamped, it is at least
// 0. A power of a negative penetration is 0. A damping per impact is set from the rate of penetration at the start of
// the step in which the contact begins.
class TextbookNewmark {
 public:
  TextbookNewmark(const Case& run, double beta, double step);
  void step();
  const Sample& sample() const { return sample_; }

 private:
  Case run_;
  double beta_, step_;
  LinearSystem system_;
  Motion motion_;
  int side_ = 0;  // of the stop in contact, 0 for none
  long steps_ = 0;
  double work_on_contact_ = 0;
  Sample sample_;
};

// The absorber by the classical Runge-Kutta method of fourth order. Each stage has the force of its own penetration. c1
// is constant.
class TextbookRungeKutta {
 public:
  TextbookRungeKutta(const Case& run, double step);
  void step();
  const Sample& sample() const { return sample_; }

 private:
  Case run_;
  double step_;
  long steps_ = 0;
  double work_on_contact_ = 0;
  Sample sample_;
};

}  // namespace impact::host
