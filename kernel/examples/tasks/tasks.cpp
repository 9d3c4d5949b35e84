// SPDX-License-Identifier: MIT
// The absorber between an interrupt and tasks, by FreeRTOS's rules; of FreeRTOS itself it needs vTaskDelay alone, which
// is declared here as task.h does. TIM2_IRQHandler is the name in the vector table of an STM32: yours may differ.
//
//     the interrupt   steps, writes the converter, takes a new plan over. It calls nothing of FreeRTOS, so that it may
//                     have any priority, above configMAX_SYSCALL_INTERRUPT_PRIORITY as well, and no critical section
//                     of a task delays it.
//     tasks           read snapshot() and fault(), and leave wishes in words that the interrupt reads. No mutex, no
//                     critical section.

#include <stdint.h>

#include <impact/absorber.hpp>
#include <impact/self_test.hpp>

extern "C" void vTaskDelay(uint32_t ticks);

namespace {

constexpr impact::Scene driven_at(double pulsation) {
  impact::Scene scene;
  scene.drive_pulsation = pulsation;
  return scene;
}
using Absorber = impact::Absorber<impact::AtRunTime, impact::HuntCrossley, impact::Moment, impact::Sine,
                                  impact::Fixed32, impact::Snapshots>;
constexpr Absorber::PlanType plans[] = {Absorber::PlanType::make(driven_at(40), impact::Bounds{}, 1e-4),
                                        Absorber::PlanType::make(driven_at(45), impact::Bounds{}, 1e-4)};
static_assert(plans[0].status == impact::PlanStatus::ok && plans[1].status == impact::PlanStatus::ok);

Absorber absorber(plans[0]);  // the interrupt's own

constexpr impact::Converter dac{2048, 2047 / 0.05, 0, 4095};
constexpr impact::ToCounts<Absorber, impact::Quantity::displacement> to_dac(dac, plans[0]);
volatile int32_t dac_register;  // stands for the converter's

// Wishes: one word each, written by tasks and fulfilled by the interrupt.
volatile uint8_t wanted_plan, has_to_begin_anew;
uint8_t plan_in_use;

}  // namespace

extern "C" void TIM2_IRQHandler() {
  absorber.step();
  dac_register = to_dac(absorber);
  if (wanted_plan != plan_in_use && absorber.retune(plans[wanted_plan])) plan_in_use = wanted_plan;
  if (has_to_begin_anew) {
    absorber.reset();
    has_to_begin_anew = 0;
  }
}

// xTaskCreate(supervise, ...): any number of tasks may read.
extern "C" void supervise(void*) {
  if (!impact::self_test<Absorber::Format>()) return;  // before the timer starts
  for (;;) {
    const auto now = absorber.snapshot();  // of one step, whatever the interrupt does meanwhile
    if (absorber.fault() != impact::Fault::none) has_to_begin_anew = 1;
    if (now.is_whole) wanted_plan = now.displacement.raw > INT32_MAX / 8 ? 1 : 0;  // beyond an eighth of the unit
    vTaskDelay(10);
  }
}
