// What a step costs on a part, from step_budget.csv of the report, which counts instructions under an emulator.

import { short } from './numbers.mjs';

// As sold. `cycles`: what an instruction takes on average from memory without wait states, an assumption of the report.
export const parts = [
  { target: 'cortex-m0', name: 'STM32F030, Cortex-M0, 48 MHz', clock: 48e6, cycles: 1.5 },
  { target: 'cortex-m0plus', name: 'STM32G0, Cortex-M0+, 64 MHz', clock: 64e6, cycles: 1.4 },
  { target: 'cortex-m3', name: 'STM32F103, Cortex-M3, 72 MHz', clock: 72e6, cycles: 1.4 },
  { target: 'cortex-m4f', name: 'STM32F405, Cortex-M4F, 168 MHz', clock: 168e6, cycles: 1.4 },
  { target: 'cortex-m7f', name: 'STM32H743, Cortex-M7F, 480 MHz', clock: 480e6, cycles: 1.0 },
  { target: 'rv32imac', name: 'GD32VF103, RV32IMAC, 108 MHz', clock: 108e6, cycles: 1.4 },
];

export function tableFrom(csv) {
  const [header, ...lines] = csv.trim().split('\n').map((line) => line.split(','));
  return lines.map((cells) => Object.fromEntries(header.map((name, i) => [name, cells[i]])));
}

// Lines of [what, value], or one that says what is missing.
export function costOf(table, target, scene, stepper) {
  if (table.length === 0) return [['Not measured', 'build/report/step_budget.csv was not there when this page was made; sh toolchains/bootstrap.sh report makes it']];
  if (scene.numeric === 'float64') return [['Not measured', 'Float64 is for hosts']];
  const part = parts.find((each) => each.target === target);
  const rows = table.filter((row) => row.target === target && row.law === scene.law && row.newmark === stepper && row.numeric === scene.numeric);
  const [free, contact, iterating] = ['free', 'contact', 'iterating'].map((name) => rows.find(({ phase }) => phase === name));
  if (!free || !contact) return [['Not measured', `${scene.law}, ${stepper}, ${scene.numeric} on ${target}`]];
  const cycles = part.cycles * Math.max(...[free, contact, iterating].map((row) => row?.instructions_max ?? 0));
  const memory = ['flash', 'ram', 'stack'].filter((kind) => contact[`${kind}_bytes`]);
  return [
    ['Free flight', `${short(Number(free.instructions_mean), 4)} instructions, at most ${free.instructions_max}`],
    ['In contact', `${short(Number(contact.instructions_mean), 4)} instructions, at most ${contact.instructions_max}`],
    ...(iterating ? [['Iterating', `at most ${iterating.instructions_max} instructions, at a stop 10^4 times as stiff`]] : []),
    ['Worst step', `about ${Math.round(cycles)} cycles (${part.cycles} an instruction, assumed), ${short(1e6 * cycles / part.clock)} us, ${short(100 * cycles / part.clock / scene.step)} % of the period`],
    ...memory.map((kind) => [{ flash: 'Flash', ram: 'RAM', stack: 'Stack' }[kind], `${contact[`${kind}_bytes`]} bytes`]),
  ];
}
