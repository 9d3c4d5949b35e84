// What a step costs on a part, from step_budget.csv of the report, which counts instructions under an emulator.

import { short } from './numbers.mjs';
import { baseOf } from './scene.mjs';

// Lines of [what, value], or one that says what is missing. What the parts of a scene add is counted with Hunt-Crossley,
// and so are stiff stops.
export function costOf(table, part, scene, stepper) {
  if (table.length === 0) return [['Not measured', 'This page was made without build/report/step_budget.csv. Run sh toolchains/bootstrap.sh report to make it.']];
  const numeric = scene.numeric === 'float64' ? 'fixed32' : scene.numeric, law = lawOf(scene), names = namesOf(scene);
  const counted = (ofLaw, parts) => countedIn(table.filter((row) => row.target === part.target && row.law === ofLaw && row.newmark === stepper && row.numeric === numeric && row.drive === ['sine', ...parts].join('+')));
  const own = counted(law, []), curved = counted('hunt-crossley', []);
  if (own && scene.law !== 'hooke-newton') own.iterating ??= curved?.iterating;
  const cost = names.length === 0 ? own : sumOf(own, curved, counted('hunt-crossley', names));
  if (!cost) return [['Not measured', `${[law, stepper, numeric, ...names].join(', ')} on ${part.target}`]];
  const { free, contact, iterating } = cost, most = Math.max(free.most, contact.most, iterating?.most ?? 0), cycles = part.cycles * most;
  const memory = ['flash', 'ram', 'stack'].filter((kind) => own.bytes[kind]);
  const words = names.flatMap((name) => ({ gravity: ['weight'], base: scene.gravity !== 0 ? ['weight', 'base'] : ['base'], friction: ['friction'] }[name])).join(', ').replace(/, (?=\w+$)/, ' and ');
  return [
    ...(numeric !== scene.numeric ? [['Format', 'Fixed32, since Float64 is for hosts']] : []),
    ['Free flight', `${short(free.mean, 4)} instructions, at most ${free.most}`],
    ['In contact', `${short(contact.mean, 4)} instructions, at most ${contact.most}`],
    ...(iterating ? [['Stiff stops', `at most ${iterating.most} instructions, at stops that are 10^4 times as stiff`]] : []),
    ...(names.length > 0 ? [['Parts', `${words}, ${law === 'hunt-crossley' ? 'counted in the same runs' : 'counted with Hunt-Crossley and added'}`]] : []),
    ['Worst step', `about ${Math.round(cycles)} cycles (${part.cycles} an instruction, assumed), ${short(1e6 * cycles / part.clock)} \u00b5s, ${short(100 * cycles / part.clock / scene.step)} % of the period`],
    ...memory.map((kind) => [{ flash: 'Flash', ram: 'RAM', stack: 'Stack' }[kind], `${own.bytes[kind]} bytes${names.length > 0 ? `, without ${words}` : ''}`]),
  ];
}

// As the table names it: every damping that is set at each impact steps as the exact one.
function lawOf(scene) {
  const isConstant = ['c1', 'restitution', 'paper'].includes(scene['damping-by']) || scene.law !== 'hunt-crossley';
  return isConstant ? scene.law : 'exact';
}
// Of the parts; a base that accelerates takes weight with it.
function namesOf(scene) {
  const field = baseOf(scene) !== 'still' ? ['base'] : scene.gravity !== 0 ? ['gravity'] : [];
  return [...field, ...(scene['ball-friction'] > 0 ? ['friction'] : [])];
}

// { mean, most } by phase, and bytes; null without both phases that each configuration has.
function countedIn(rows) {
  const of = (phase) => {
    const row = rows.find((each) => each.phase === phase);
    return row && { mean: Number(row.instructions_mean), most: Number(row.instructions_max) };
  };
  const [free, contact, iterating] = ['free', 'contact', 'iterating'].map(of);
  if (!free || !contact) return null;
  const { flash_bytes: flash, ram_bytes: ram, stack_bytes: stack } = rows[0];
  return { free, contact, iterating, bytes: { flash, ram, stack } };
}
// `own`, and what `wide` takes more than `plain`; null where one is missing.
function sumOf(own, plain, wide) {
  if (!own || !plain || !wide) return null;
  const sum = (phase, more) => own[phase] && {
    mean: own[phase].mean + wide[more].mean - plain[more].mean, most: own[phase].most + wide[more].most - plain[more].most,
  };
  return { free: sum('free', 'free'), contact: sum('contact', 'contact'), iterating: sum('iterating', 'contact') };
}
