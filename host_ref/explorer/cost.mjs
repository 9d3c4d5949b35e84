// What a step costs on a part, from step_budget.csv of the report, which counts instructions under an emulator.

import { short } from './numbers.mjs';

// The rows of the report's list, as the page holds them.
export const partsFrom = (json) => JSON.parse(json).map(([target, name, clock, cycles]) => ({ target, name, clock, cycles }));

export function tableFrom(csv) {
  const [header, ...lines] = csv.trim().split('\n').map((line) => line.split(','));
  return lines.map((cells) => Object.fromEntries(header.map((name, i) => [name, cells[i]])));
}

// Lines of [what, value], or one that says what is missing.
export function costOf(table, part, scene, stepper) {
  if (table.length === 0) return [['Not measured', 'build/report/step_budget.csv was not there when this page was made; sh toolchains/bootstrap.sh report makes it']];
  const numeric = scene.numeric === 'float64' ? 'fixed32' : scene.numeric;
  const rows = table.filter((row) => row.target === part.target && row.law === scene.law && row.newmark === stepper && row.numeric === numeric);
  const [free, contact, iterating] = ['free', 'contact', 'iterating'].map((name) => rows.find(({ phase }) => phase === name));
  if (!free || !contact) return [['Not measured', `${scene.law}, ${stepper}, ${numeric} on ${part.target}`]];
  const cycles = part.cycles * Math.max(...[free, contact, iterating].map((row) => row?.instructions_max ?? 0));
  const memory = ['flash', 'ram', 'stack'].filter((kind) => contact[`${kind}_bytes`]);
  return [
    ...(numeric !== scene.numeric ? [['Format', 'Fixed32, Float64 being for hosts']] : []),
    ['Free flight', `${short(Number(free.instructions_mean), 4)} instructions, at most ${free.instructions_max}`],
    ['In contact', `${short(Number(contact.instructions_mean), 4)} instructions, at most ${contact.instructions_max}`],
    ...(iterating ? [['Stiff stops', `at most ${iterating.instructions_max} instructions, at a stop 10^4 times as stiff`]] : []),
    ['Worst step', `about ${Math.round(cycles)} cycles (${part.cycles} an instruction, assumed), ${short(1e6 * cycles / part.clock)} us, ${short(100 * cycles / part.clock / scene.step)} % of the period`],
    ...(scene.gravity !== 0 || scene['ball-friction'] > 0 || scene.base !== 'still' ? [['Parts', 'weight, base and friction add to this: tests/README.md, What a step costs']] : []),
    ...memory.map((kind) => [{ flash: 'Flash', ram: 'RAM', stack: 'Stack' }[kind], `${contact[`${kind}_bytes`]} bytes`]),
  ];
}
