// The explorer's costs agree with tests/target/budgets.csv, which has the largest counts of the report's table:
// cost_test.mjs FOLDER_OF_EXPLORER BUDGETS.csv PARTS.json
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { check, finish } from './check.mjs';

const [folder, budgetsFile, partsFile] = process.argv.slice(2);
const { costOf } = await import(pathToFileURL(`${folder}/cost.mjs`)), { tableFrom } = await import(pathToFileURL(`${folder}/numbers.mjs`));

const budgets = tableFrom(readFileSync(budgetsFile, 'utf8'));
const budgetOf = (target, law, newmark, numeric, drive, quantity) => Number(budgets.find((row) =>
  row.law === law && row.newmark === newmark && row.numeric === numeric && row.drive === drive && row.quantity === quantity)?.[target] || NaN);
const targets = JSON.parse(readFileSync(partsFile, 'utf8')), cores = [...new Set(targets.map(({ target }) => target))];
check(cores.length === 7, `${targets.length} parts of ${cores.length} targets`);
const table = cores.flatMap((target) => budgets.filter((row) => row[target] && ['free', 'contact', 'iterating'].includes(row.quantity)).map((row) => ({
  ...row, target, phase: row.quantity, instructions_mean: row[target], instructions_max: row[target],
  flash_bytes: budgetOf(target, row.law, row.newmark, row.numeric, row.drive, 'flash_bytes') || '', ram_bytes: '', stack_bytes: '',
})));
const still = { law: 'hunt-crossley', 'damping-by': 'c1', numeric: 'fixed32', step: 1e-4, gravity: 0, 'ball-friction': 0, base: 'still' };
const shown = (part, scene, stepper) => Object.fromEntries(costOf(table, part, { ...still, ...scene }, stepper));
const most = (words) => Number(words?.match(/at most (\d+)/)?.[1]);

for (const part of targets) {
  const own = (law, newmark, drive, quantity) => budgetOf(part.target, law, newmark, 'fixed32', drive, quantity);
  for (const [drive, scene] of [['sine', {}], ['sine+gravity', { gravity: -9.81 }], ['sine+base', { base: 'example' }], ['sine+base', { base: 'example', gravity: -9.81 }],
    ['sine+friction', { 'ball-friction': 0.5 }], ['sine+base+friction', { base: 'samples', gravity: 3, 'ball-friction': 0.5 }]]) {
    const lines = shown(part, scene, 'moment'), free = own('hunt-crossley', 'moment', drive, 'free'), contact = own('hunt-crossley', 'moment', drive, 'contact');
    check(free > 0 && most(lines['Free flight']) === free && most(lines['In contact']) === contact, `${part.target}, ${drive}: ${free} and ${contact}`);
    check(lines['Worst step'].startsWith(`about ${Math.round(part.cycles * Math.max(free, contact))} cycles`), lines['Worst step']);
    check(('Parts' in lines) === (drive !== 'sine') && /^\d+ bytes/.test(lines.Flash) && /without/.test(lines.Flash) === (drive !== 'sine'), `${lines.Parts}; ${lines.Flash}`);
  }
  const added = own('hunt-crossley', 'moment', 'sine+gravity', 'contact') - own('hunt-crossley', 'moment', 'sine', 'contact');
  check(most(shown(part, { law: 'hertz', gravity: 1 }, 'moment')['In contact']) === own('hertz', 'moment', 'sine', 'contact') + added, `${part.target}, Hertz: ${added} more with weight`);
  check(most(shown(part, {}, 'energy')['Stiff stops']) === own('hunt-crossley', 'energy', 'sine', 'iterating'), `${part.target}: a stiff stop`);
}
// A configuration without a row is shown as not measured. It does not take the row of another.
for (const [scene, stepper] of [[{ gravity: 1 }, 'impulsive'], [{}, 'moment-8'], [{ 'damping-by': 'exact' }, 'energy']])
  check('Not measured' in shown(targets[0], scene, stepper), `${JSON.stringify(scene)}, ${stepper}: ${shown(targets[0], scene, stepper)['Not measured']}`);
// The page offers every law, damping, stepper and format of the tool, and the report draws every damping.
const { valueNamed } = await import(pathToFileURL(`${folder}/scene.mjs`));
const source = (file) => readFileSync(`${folder}/../${file}`, 'utf8');
const namesIn = (text, list) => [...text.split(list)[1].split(/;|\n#/)[0].matchAll(/"([a-z0-9-]+)"/g)].map(([, name]) => name);
const dampings = namesIn(source('names.hpp'), 'dampings[]').filter((name) => !['constant', 'per-impact'].includes(name));
for (const [value, names] of [['damping-by', dampings], ...[['law', 'LAWS'], ['newmark', 'STEPPERS'], ['numeric', 'FORMATS']].map(
  ([value, list]) => [value, namesIn(source('simulation.hpp'), `IMPACT_${list}(X)`)])])
  for (const name of names.length > 2 ? names : ['?']) check(name in valueNamed(value).choices, `the page's ${value} has ${name}`);
const picture = source('report/page/view.mjs').split('restitution: () =>')[1].split('\n').slice(0, 3).join();
for (const name of dampings) check(picture.includes(name), `the picture of restitutions has ${name}`);

finish();
