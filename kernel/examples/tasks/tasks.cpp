// SPDX-License-Identifier: MIT
// The absorber between an interrupt and tasks, by FreeRTOS's rules; of FreeRTOS itself it needs vTaskDelay alone, which
// is declared here as task.h does. TIM2_IRQHandler is the name in the vector table of an STM32: yours may differ.
//
//     the interrupt   steps, writes the converter, takes a new plan over. It calls nothing of FreeRTOS, so that it may
//                     have any priority, above configMAX_SYSCALL_INTERRUPT_PRIORITY as well, and no critical section
//                     of a task delays it.
//     one task        sets request words that the interrupt reads. Each word has one writer. No mutex, no critical section.
//     any task        reads snapshot() and fault().

#include <stdint.h>

#include <impact/absorber.hpp>
#include <impact/self_test.hpp>

extern "C" void vTaskDelay(uint32_t ticks);
extern "C" void start_timer();  // yours: TIM2 interrupts from here on

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

volatile uint8_t wanted_plan, resets_wanted;  // written by the task supervise() alone
volatile uint8_t resets_made;                 // written by the interrupt alone, as the next
uint8_t plan_in_use;

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

// xTaskCreate(supervise, ...), once: the requests have one writer.
extern "C" void supervise(void*) {
  while (!impact::self_test<Absorber::Format>()) vTaskDelay(1000);  // a task never returns
  start_timer();
  for (;;) {
    const auto now = absorber.snapshot();  // of one step, whatever the interrupt does meanwhile
    // Once for each fault: a request that the interrupt has not seen yet still stands.
    if (resets_made == resets_wanted && absorber.fault() != impact::Fault::none)
      resets_wanted = static_cast<uint8_t>(resets_wanted + 1);
    if (now.is_whole) wanted_plan = now.displacement.raw > INT32_MAX / 8 ? 1 : 0;  // beyond an eighth of the unit
    vTaskDelay(10);
  }
}
