// A run in words and numbers.

import { element } from './controls.mjs';
import { short } from './numbers.mjs';

export function sentenceOf(run, isCompared) {
  const { largest, impacts, dissipated } = run.totals(), bare = run.bareLargest(), share = 100 * run.attenuation(), fault = run.fault();
  const who = isCompared ? `${run.letter.toUpperCase()}, ${run.plan.stepper}: the` : 'The';
  const beside = Number.isFinite(share) ? `, ${short(1e3 * bare)} mm without absorber: ${short(Math.abs(share))} % ${share >= 0 ? 'less' : 'more'} with it` : '';
  return `${who} main mass reaches ${short(1e3 * largest)} mm${beside}. ${impacts} impacts${dissipated < 0 ? `, which create ${short(-dissipated)} J` : ''}.${fault && ` Stopped by a fault: ${fault}.`}`;
}

// What a plot shows of the runs, as its heading, by the plot's name.
export function findingsOf(runs, isCompared) {
  const ofEach = (text) => runs.map((run) => `${isCompared ? `${run.letter.toUpperCase()}: ` : ''}${text(run, run.totals())}`).join('; ');
  const energies = ({ dissipated, rubbed, energyError }) =>
    `Contact ${dissipated < 0 ? 'creates' : 'dissipates'} ${short(Math.abs(dissipated))} J${rubbed > 0 ? `, friction ${short(rubbed)} J` : ''}; the energy balance has an error of ${short(Math.abs(energyError), 2)} J`;
  const energyOf = (letter) => runs.filter((run) => run.letter === letter).map((run) => energies(run.totals())).join('');
  return {
    displacement: ofEach((run, { largest }) => `${short(1e3 * largest)} mm at most${run.hasBare ? `, ${short(1e3 * run.bareLargest())} mm without absorber` : ''}`),
    loop: ofEach((run, { peakForce }) => `${short(peakForce)} N at most`),
    restitution: ofEach((run) => restitutionsOf(run.restitutions())),
    'energy-a': energyOf('a'), 'energy-b': energyOf('b'),
  };
}

function restitutionsOf(found) {
  if (!found) return '0 complete impacts';
  const { count, fromLaw, above } = found;
  return `50 % within ${short(fromLaw, 2)} of the line${above > 0 ? `, ${above} of ${count} above 1` : ''}`;
}

export function numbersRow(run) {
  const { largest, impacts, peakForce, dissipated, rubbed, energyError } = run.totals();
  const numbers = [1e3 * largest, 1e3 * run.bareLargest(), 100 * run.attenuation(), impacts, peakForce, dissipated, rubbed, energyError];
  const row = element('tr', {});
  row.append(element('th', { scope: 'row', textContent: run.letter.toUpperCase() }), element('td', { textContent: run.plan.stepper }),
    ...numbers.map((number) => element('td', { textContent: Number.isFinite(number) ? short(number, 4) : '-' })));
  return row;
}
