// A run in words and numbers.

import { element } from './controls.mjs';
import { short } from './numbers.mjs';

export function sentenceOf(run, isCompared) {
  const { largest, impacts, dissipated } = run.totals(), bare = run.bareLargest(), share = 100 * run.attenuation(), fault = run.fault();
  const who = isCompared ? `${run.letter.toUpperCase()}, ${run.plan.stepper}: the` : 'The';
  const beside = Number.isFinite(share) ? `, ${short(1e3 * bare)} mm without absorber: ${short(Math.abs(share))} % ${share >= 0 ? 'less' : 'more'} with it` : '';
  return `${who} main mass reaches ${short(1e3 * largest)} mm${beside}. ${impacts} impacts${dissipated < 0 ? `, which create ${short(-dissipated)} J` : ''}.${fault && ` Stopped by a fault: ${fault}.`}`;
}

export function numbersRow(run) {
  const { largest, impacts, peakForce, dissipated, rubbed, energyError } = run.totals();
  const numbers = [1e3 * largest, 1e3 * run.bareLargest(), 100 * run.attenuation(), impacts, peakForce, dissipated, rubbed, energyError];
  const row = element('tr', {});
  row.append(element('th', { scope: 'row', textContent: run.letter.toUpperCase() }), element('td', { textContent: run.plan.stepper }),
    ...numbers.map((number) => element('td', { textContent: Number.isFinite(number) ? short(number, 4) : '-' })));
  return row;
}
