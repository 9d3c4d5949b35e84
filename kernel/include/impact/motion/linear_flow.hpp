// SPDX-License-Identifier: MIT
#pragma once
// How the sprung, damped, driven main mass moves over one step while nothing touches it: the exact flow of
// M x'' + c x' + k x = F(t), and Newmark's (gamma = 1/2). Derivation: kernel/docs/flight.md. Two maps of one shape,
//
//     x'   = x + e11 x + e12 u + b0 F + b1 F'          u = h v, so that every term is a displacement in metres
//     u'   = u + e21 x + e22 u + c0 F + c1 F'          F, F': the drive at the two ends of the step, N
//
// step as x' = x + w, w' = w - damping w - stiffness x' + s. Also the types that all drives share.

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/in.hpp>
#include <impact/numeric/oscillator.hpp>
#include <impact/scene.hpp>

namespace impact {

// The drive's share in the lag of the coming step under two plans: motion/plan_change.hpp.
template <class Value> struct DriveShares { Increment<Value> old_share, new_share; };

// How a drive's force changes within a step, as changes of the displacement per step. In this order: the share by the
// force at the step's end less the true share; half of the change by the slope at the end; half of the change; the
// half of the second difference.
template <class Value> struct DriveChange { Increment<Value> to_end, half, half_chord, bend; };

// The matrix of the map less the identity (so that nothing cancels at small steps), and the response to the drive.
struct LinearFlow {
  double e11 = 0, e12 = 0, e21 = 0, e22 = 0;
  double b0 = 0, b1 = 0, c0 = 0, c1 = 0;  // m/N: a force linear over the step
  Sinusoid displacement, velocity;        // m/N: a force sin(w t), at the start of the step

  constexpr double stiffness() const { return e11 * e22 - e12 * e21; }
  constexpr double damping() const { return -(e11 + e22) - stiffness(); }
  // The share of a constant force in dx at the start, and its change of dx in a step, m/N.
  constexpr double constant_start() const { return b0 + b1; }
  constexpr double constant_increment() const { return e12 * (c0 + c1) - e22 * (b0 + b1); }
};

// The response to a force that is linear between samples, m/N: of the displacement to the sample at the step's end, and
// of dx to the samples at both ends.
struct SampledForce {
  double at_once, before, now;
};
constexpr SampledForce sampled_force(const LinearFlow& flow) {
  return {flow.b1, flow.e12 * flow.c0 - (1 + flow.e22) * flow.b0,
          flow.e12 * flow.c1 - (flow.e22 + flow.damping()) * flow.b1 + flow.b0};
}

// exp(A) - 1 of the oscillator augmented by its drive: x, u, F, F' - F, sin, cos. Relative precision near 1e-15.
constexpr LinearFlow exact_flow(const Scene& scene, double h) {
  constexpr int size = 6;
  struct Matrix {
    double at[size][size] = {};
  };
  struct Entry {
    int row, column;
    double value;
  };
  const double turn = scene.drive_pulsation * h, compliance = h * h / scene.main_mass;
  Entry generator[] = {{0, 1, 1},
                       {1, 0, -scene.main_stiffness * compliance},
                       {1, 1, -scene.main_damping * h / scene.main_mass},
                       {1, 2, compliance},
                       {1, 4, compliance},
                       {2, 3, 1},
                       {4, 5, turn},
                       {5, 4, -turn}};

  double norm = 1, row_sums[size] = {};
  for (const Entry& entry : generator) row_sums[entry.row] += constant::magnitude(entry.value);
  for (double row_sum : row_sums) norm = constant::larger(norm, row_sum);
  const int doublings = constant::exponent_above(norm) + 1;
  const double scale = constant::power_of_two(-doublings);
  Matrix term{};
  for (Entry& entry : generator) term.at[entry.row][entry.column] = entry.value *= scale;
  Matrix sum = term;
  for (int order = 2; order <= 16; ++order)
    for (int i = 0; i < size; ++i) {
      double next[size] = {};
      for (const Entry& entry : generator) next[entry.column] += term.at[i][entry.row] * entry.value;
      for (int j = 0; j < size; ++j) sum.at[i][j] += term.at[i][j] = next[j] / order;
    }
  for (int doubling = 0; doubling < doublings; ++doubling) {
    Matrix square{};
    for (int i = 0; i < size; ++i)
      for (int k = 0; k < size; ++k)
        for (int j = 0; j < size; ++j) square.at[i][j] += sum.at[i][k] * sum.at[k][j];
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j) sum.at[i][j] = 2 * sum.at[i][j] + square.at[i][j];
  }
  const auto& e = sum.at;
  return {e[0][0],           e[0][1],           e[1][0],
          e[1][1],           e[0][2] - e[0][3], e[0][3],
          e[1][2] - e[1][3], e[1][3],           {e[0][4], e[0][5]},
          {e[1][4], e[1][5]}};
}

// Newmark's map (Newmark 1959) with gamma = 1/2: x' = x + h v + h^2 [(1/2 - beta) a + beta a'], v' = v + h (a + a')/2,
// and equilibrium at both ends: M a + c v + k x = F.
constexpr LinearFlow newmark_flow(const Scene& scene, double h, double beta) {
  const double mass = scene.main_mass, ch = scene.main_damping * h, khh = scene.main_stiffness * h * h;
  const double effective = mass + ch / 2 + beta * khh;
  struct Ends {
    double x, u;
  };
  // The response of (x', u') less (x, u) to the start's x, u and h^2 a, and to the force at the end, all in metres.
  const auto respond = [&](double x, double u, double a, double force) {
    const double x_known = u + (0.5 - beta) * a, u_known = a / 2;
    const double a_end = (force - ch * (u + u_known) - khh * (x + x_known)) / effective;
    return Ends{x_known + beta * a_end, u_known + a_end / 2};
  };
  const Ends x = respond(1, 0, -khh / mass, 0), u = respond(0, 1, -ch / mass, 0);
  const Ends start = respond(0, 0, h * h / mass, 0), end = respond(0, 0, 0, h * h);
  const double cosine = constant::cosine(scene.drive_pulsation * h), sine = constant::sine(scene.drive_pulsation * h);
  return {x.x,
          u.x,
          x.u,
          u.u,
          start.x,
          end.x,
          start.u,
          end.u,
          {start.x + end.x * cosine, end.x * sine},
          {start.u + end.u * cosine, end.u * sine}};
}

}  // namespace impact
