// SPDX-License-Identifier: MIT
// The paper's scene at 1 kHz from loop(), on any core whose compiler is GCC 9 or later. If C++17 is not the core's
// default, write this line into a platform.local.txt beside its platform.txt:
//
//     compiler.cpp.extra_flags=-std=gnu++17 -ffp-contract=off

#pragma GCC optimize("O2")  // most cores compile at -Os, where a step costs far more
#include <impact.h>

struct Rig {
  static constexpr impact::Scene scene{};    // SI units; the defaults are the paper's scene
  static constexpr impact::Bounds bounds{};  // the largest values that it may reach
  static constexpr double step = 1e-3;       // s
};
using Absorber = impact::Absorber<Rig, impact::HuntCrossley, impact::Moment, impact::Sine, impact::Fixed32>;

constexpr impact::Converter pwm{128, 127 / 0.05, 0, 255};  // the middle is 0 m, full scale 0.05 m
constexpr impact::ToCounts<Absorber, impact::Quantity::displacement> to_pwm(pwm);

Absorber absorber;
unsigned long due;

void setup() { Serial.begin(115200); }

void loop() {
  if (micros() - due < 1000) return;
  due += 1000;
  absorber.step();
  analogWrite(A0, to_pwm(absorber));
  if (absorber.fault() != impact::Fault::none) {
    Serial.println(F("out of range"));
    absorber.reset();
  }
}
