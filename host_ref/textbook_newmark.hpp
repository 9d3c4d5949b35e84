#pragma once
// What a textbook would have one write, for a system of n degrees of freedom in matrices,
//
//     M x'' + C x' + K x + N(x, x') = F(t)
//
// Newmark's family (Newmark 1959; Hughes, The Finite Element Method, ch. 9) with gamma = 1/2 in acceleration form,
// solved by Newton's method with the full tangent, and the classical Runge-Kutta method. The absorber stands on it in
// the two coordinates x1, x2. It is the yardstick of the kernel's classical schemes, and the baseline of its error
// report.

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

// The state a step h after `start`. `external` is F at the end of the step; `start` holds the acceleration found there.
Motion newmark_step(const LinearSystem& system, double beta, double h, const Motion& start,
                    const Eigen::VectorXd& external, const InternalForceLaw& internal);

// The absorber by Newmark's method, contact taken pointwise: the contact force at the end of a step is the law's at the
// state there if the step's trial penetration (that of the step solved without contact force at its end) is positive,
// and nil otherwise; clamped, it is no less than zero. A power of a negative penetration is zero. A per-impact c1 is
// set from the penetration rate at the start of the step in which the contact begins.
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

// The absorber by the classical Runge-Kutta method of fourth order, the force of the present penetration in every
// stage. It has the constant c1 only.
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
