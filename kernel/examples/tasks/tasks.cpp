// SPDX-License-Identifier: MIT
// An interrupt and tasks share the absorber, by FreeRTOS's rules. The only function of FreeRTOS that this file needs is
// vTaskDelay, which it declares as task.h does. TIM2_IRQHandler is the name in the vector table of an STM32: yours may
// differ.
//
//     the interrupt   steps, writes the converter, changes the plan. It calls no function of FreeRTOS, so it may have
//                     any priority, even above configMAX_SYSCALL_INTERRUPT_PRIORITY. Then no critical section of a
//                     task delays it.
//     one task        sets request words that the interrupt reads. Each word has one writer, so no mutex and no
//                     critical section is needed.
//     any task        reads snapshot() and fault().

#include <stdint.h>

#include <impact/absorber.hpp>
#include <impact/self_test.hpp>

extern "C" void vTaskDelay(uint32_t ticks);
extern "C" void start_timer();  // a function of yours: TIM2 interrupts from then on

namespace {

constexpr impact::Scene driven_at(double pulsation) {
  impact::Scene scene;
  scene.drive_pulsation = pulsation;
  return scene;
}
template <class... Features>
using AbsorberWith = impact::Absorber<impact::AtRunTime, impact::HuntCrossley, impact::Moment, impact::Sine,
                                      impact::Fixed32, Features...>;
using Absorber = AbsorberWith<impact::Snapshots>;
constexpr Absorber::PlanType plans[] = {Absorber::PlanType::make(driven_at(40), impact::Bounds{}, 1e-4),
                                        Absorber::PlanType::make(driven_at(45), impact::Bounds{}, 1e-4)};
static_assert(plans[0].status == impact::PlanStatus::ok && plans[1].status == impact::PlanStatus::ok);
static_assert(AbsorberWith<>(plans[0]).retune(plans[1]));  // without Snapshots, which does not compile here

Absorber absorber(plans[0]);  // only the interrupt steps and changes it

constexpr impact::Converter dac{2048, 2047 / 0.05, 0, 4095};
constexpr impact::ToCounts<Absorber, impact::Quantity::displacement> to_dac(dac, plans[0]);
volatile int32_t dac_register;  // stands for the converter's

volatile uint8_t wanted_plan, resets_wanted;  // only the task supervise() writes them
volatile uint8_t resets_made;                 // only the interrupt writes this one
uint8_t plan_in_use;                          // and this one

}  // namespace

extern "C" void TIM2_IRQHandler() {
  absorber.step();
  dac_register = to_dac(absorber);
  if (wanted_plan != plan_in_use && absorber.retune(plans[wanted_plan])) plan_in_use = wanted_plan;
  if (resets_made != resets_wanted) {
    absorber.reset();
    resets_made = resets_wanted;
  }
}

// Create this task once, with xTaskCreate(supervise, ...), because each request word has one writer.
extern "C" void supervise(void*) {
  while (!impact::self_test<Absorber::Format>()) vTaskDelay(1000);  // a task must not return
  start_timer();
  for (;;) {
    const auto now = absorber.snapshot();  // all values are of one step, even if the interrupt steps now
    // One request for each fault: none while the interrupt has not fulfilled the last one.
    if (resets_made == resets_wanted && absorber.fault() != impact::Fault::none)
      resets_wanted = static_cast<uint8_t>(resets_wanted + 1);
    if (now.is_whole) wanted_plan = now.displacement.raw > INT32_MAX / 8 ? 1 : 0;  // beyond an eighth of the unit
    vTaskDelay(10);
  }
}
