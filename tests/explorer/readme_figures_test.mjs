// README.md's figures of the report, against the tables of the report in a build folder, if it has been made:
// readme_figures_test.mjs PROJECT BUILD
import { existsSync, readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { check, finish } from './check.mjs';

const [project, build] = process.argv.slice(2);
const { configurationsOf, duel, number, pointsOf, steel } = await import(pathToFileURL(`${project}/host_ref/report/page/facts.mjs`));
const names = ['error_vs_time', 'accuracy', 'stiff', 'stiff_time', 'step_budget', 'stability'], folder = `${build}/report`;
if (!names.every((name) => existsSync(`${folder}/${name}.csv`))) {
  console.log('skipped: there is no report in the build folder');
  process.exit(77);
}
const { tableFrom } = await import(pathToFileURL(`${project}/host_ref/explorer/numbers.mjs`));
const tables = Object.fromEntries(names.map((name) => [name, tableFrom(readFileSync(`${folder}/${name}.csv`, 'utf8'))]));

const points = pointsOf(tables), configuration = configurationsOf(tables.step_budget);
const times = (target, law, baselines) => {
  const { kernel } = duel(points, target, law, 1e-6), baseline = duel(points.filter(({ method }) => baselines.test(method)), target, law, 1e-6).baseline;
  return baseline.cost / kernel.cost;
};
const worst = (target, method, numeric) => configuration(target, 'hunt-crossley', method, numeric).worst;
const gain = (method, isSeen) => Math.max(...tables.stability.filter((row) => row.law === 'hunt-crossley' && row.newmark === method && row.accepted === '1' && isSeen(row)).map((row) => number(row.energy_gain_max)));
const readme = readFileSync(`${project}/README.md`, 'utf8').replace(/\s+/g, ' ');
// README rounds.
function figure(text, ...measured) {
  const stated = readme.match(new RegExp(text))?.slice(1).map(Number) ?? [];
  measured.forEach((value, i) => check(Math.abs(value / stated[i] - 1) < 0.15, `${text}: README says ${stated[i]}, the report ${value}`));
}
figure('RK4 with `powf` executes over (\\d+) times as many instructions as this kernel on a Cortex-M4F', times('cortex-m4f', 'hunt-crossley', /^textbook-rk4$/));
figure('tuned RK4 executes (\\d+) times as many there, and (\\d+) times as many on a Cortex-M3', times('cortex-m4f', 'hunt-crossley', /^tuned-rk4/), times('cortex-m3', 'hunt-crossley', /^tuned-rk4/));
figure('RK4 that finds each instant of touch executes (\\d+) times as many', times('cortex-m4f', steel, /^event-rk4/));
figure('`powf` takes up to (\\d+) instructions on a Cortex-M3\\. This kernel\'s takes (\\d+)', worst('cortex-m3', 'textbook-newmark', 'float32-plain'), worst('cortex-m3', 'moment', 'fixed32'));
figure('multiplies the energy of an impact by up to ([\\de]+) \\(Hunt-Crossley', 1 + gain('textbook-rk4', ({ contact_stiffness, step_s }) => number(contact_stiffness) === 1e12 && number(step_s) === 1e-3));
figure('average acceleration multiplies it by up to (\\d+)', 1 + gain('average', () => true));
finish();
