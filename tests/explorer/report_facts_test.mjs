// The report's sentences, for tables that this test makes: report_facts_test.mjs FOLDER_OF_PAGE
import { pathToFileURL } from 'node:url';
import { check, finish } from './check.mjs';

const { advantage, atAGlance, budgetOf, chooserOf, coupledRows, duel, findings, frontiers, paperSentences, partsRows, pointText, pointsOf, restitutionError, stabilityRows, stiffText } =
  await import(pathToFileURL(`${process.argv[2]}/facts.mjs`));
function equal(found, expected, what) {
  const holds = JSON.stringify(found) === JSON.stringify(expected);
  check(holds, holds ? what : `${what}: ${JSON.stringify(found)}, not ${JSON.stringify(expected)}`);
}

// Error against run time.
const point = (target, method, numeric, error_m, cost) => ({ target, law: 'hertz', method, numeric, error_m, step_s: '0.001', instructions_per_simulated_second: cost });
const pointsFrom = (...rows) => pointsOf({ error_vs_time: rows, accuracy: [], stiff: [], stiff_time: [] });
const duels = pointsFrom(point('cortex-m3', 'moment', 'fixed32', '2e-6', '10'), point('cortex-m3', 'moment', 'fixed32', '9e-7', '30'), point('cortex-m3', 'energy', 'fixed32', '9e-7', '40'),
  point('cortex-m3', 'moment', 'float32', '9e-7', '5'),  // not native without FPU
  point('cortex-m4f', 'moment', 'float32', '9e-7', '1'), point('cortex-m3', 'textbook-rk4', 'float32-plain', '1e-7', '300'), point('cortex-m3', 'tuned-rk4', 'float32-plain', '1e-6', '60'));
const found = duel(duels, 'cortex-m3', 'hertz', 1e-6);
equal([found.kernel.cost, found.baseline.method, found.ratio], [30, 'tuned-rk4', 2], 'a duel is between the cheapest that reach the error');
equal(duel(duels, 'cortex-m3', 'hertz', 1e-8), { ratio: 0 }, 'or there is none');
equal(duel(pointsFrom(point('cortex-m3', 'moment', 'fixed32', 'nan', '1')), 'cortex-m3', 'hertz', 1), { ratio: 0 }, 'an error that is NaN reaches nothing');
equal(advantage(duels).text, '**A baseline costs less** on cortex-m3, hertz at 1e-7 m.', 'where a baseline costs less the page says so');
equal(advantage(duels).rows.map(([target, , error, , , ratio]) => [target, error, ratio.text, ratio.isStrong]), [['cortex-m4f', '1e-3', '∞', false], ['cortex-m4f', '1e-4', '∞', false], ['cortex-m4f', '1e-5', '∞', false],
  ['cortex-m4f', '1e-6', '∞', false], ['cortex-m3', '1e-3', '6', false], ['cortex-m3', '1e-4', '6', false], ['cortex-m3', '1e-5', '6', false], ['cortex-m3', '1e-6', '2', false], ['cortex-m3', '1e-7', 'kernel does not reach it', true]], 'and in the table');
equal(advantage(pointsFrom(point('cortex-m3', 'moment', 'fixed32', '1e-9', '9'), point('cortex-m3', 'event-rk4', 'float32-plain', '1e-9', '8'))).rows[0][5], { text: '0.889', value: 8 / 9, isStrong: true }, 'a ratio below 1');
equal(advantage(duels.slice(0, 3)).text, 'No baseline reaches any error from 1e-3 to 1e-9 m for less.', 'or that none does');
const ways = frontiers(pointsFrom(point('cortex-m3', 'energy', 'fixed32', '2e-6', '20'), point('cortex-m3', 'moment', 'fixed32', '1e-6', '10'), point('cortex-m3', 'impulsive', 'fixed32', '1e-7', '20'),
  point('cortex-m3', 'average', 'fixed32', '1e-9', '1'), point('cortex-m3', 'textbook-rk4', 'float32-plain', '1e-4', '1')), 'cortex-m3', 'hertz');
equal(Object.entries(ways).map(([name, rows]) => [name, ...rows.map(({ cost }) => cost)]), [['kernel', 10, 20], ['best baseline', 1], ["paper's scheme", 1]], 'a frontier has what no other reaches for less');
const host = pointsOf({ error_vs_time: [], accuracy: [{ law: 'hertz', newmark: 'moment', numeric: 'float64', step_s: '0.001', error_m: '1e-9', host_ns_per_step: '40' }], stiff: [], stiff_time: [] });
equal([host[0].target, host[0].method, host[0].cost], ['host', 'moment', 40000], "the host's cost is in nanoseconds per simulated second");
const steel = pointsOf({ error_vs_time: [], accuracy: [], stiff_time: [{ target: 'cortex-m4f', method: 'event-rk4', numeric: 'float32-plain', step_s: '0.001', contact_steps: '8', error_m: '1e-6', instructions_per_simulated_second: '90' }],
  stiff: ['1e+09', '1e+10'].map((contact_stiffness) => ({ contact_stiffness, step_s: '0.001', method: 'auto', numeric: 'float64', contact_steps: '', error_m: '1e-9', ns_per_simulated_second: '70' })) });
equal(steel.map(({ target, law, method, cost }) => [target, law, method, cost]), [['cortex-m4f', 'hunt-crossley-1e10', 'event-rk4', 90], ['host', 'hunt-crossley-1e10', 'auto', 70]], 'a stop like steel has points of its own');
equal([advantage(steel).rows.length, advantage(steel).text], [11, '**A baseline costs less** on cortex-m4f, hunt-crossley-1e10 at 1e-3 m; cortex-m4f, hunt-crossley-1e10 at 1e-4 m; cortex-m4f, hunt-crossley-1e10 at 1e-5 m; cortex-m4f, hunt-crossley-1e10 at 1e-6 m.'], 'and rows where a baseline wins');
equal(steel.map((row) => / 8 steps in a contact /.test(pointText(row))), [true, false], 'event-rk4 says how many steps a contact has');

// What to choose.
const impact = (newmark, numeric, energy_gain_max, accepted, machine_rule = 'moment') => ({ law: 'hunt-crossley', newmark, numeric, step_s: '0.0001', contact_stiffness: '10000', restitution_min: '0.679', restitution_max: '0.68',
  restitution_exact: '0.68', energy_gain_max, accepted, machine_rule });
const step = (newmark, phase, most, drive = 'sine') => ({ target: 'cortex-m3', law: 'hunt-crossley', newmark, numeric: 'fixed32', drive, phase, instructions_mean: most, instructions_max: most, flash_bytes: '3200', ram_bytes: '72', stack_bytes: '152' });
const both = (newmark, free, contact, drive) => [step(newmark, 'free', free, drive), step(newmark, 'contact', contact, drive)];
const part = { target: 'cortex-m3', name: 'STM32F103, 72 MHz', clock: 72e6, cycles: 1.4, has_fpu: false };
const choice = (budget, stability) => chooserOf(budget, stability)(part, 'hunt-crossley', 1e4, 1e4);
// Half of 0.1 ms at 72 MHz and 1.4 cycles per instruction are 2571.4 instructions.
const costs = (contact) => [...both('moment', '10', contact), ...both('impulsive', '1', '1'), ...both('average', '100', '2572'), ...both('moment', '9999', '9999', 'sine+gravity')];
const accepted = [impact('moment', 'fixed32', '0', '1'), impact('impulsive', 'fixed32', '0', '0', 'impulsive'), impact('average', 'fixed32', '0', '1')];
const chosen = choice(costs('2571'), accepted);
equal([chosen.types, chosen.worst, chosen.error, chosen.memory], [['HuntCrossley', 'Moment', 'Fixed32'], 2571, '0.001', '3200 bytes of flash, 72 of RAM, 152 of stack'], 'what to choose fits into half of the period and is accepted');
equal([Math.abs(chosen.share - 0.49992) < 1e-5, Math.abs(chosen.time - 49.992e-6) < 1e-9], [true, true], 'its share and time');
equal(choice(costs('2600'), accepted), { none: 'none: the worst step takes more than half of the period' }, 'or is too slow');
equal(choice([], accepted), { none: 'none: the contact is shorter than these steps resolve' }, 'or resolves nothing');
const cheap = [...both('moment', '10', '20'), ...both('impulsive', '1', '1')];
equal(choice(cheap, [accepted[0], impact('impulsive', 'fixed32', '0', '1')]).newmark, 'moment', "impulsive is not chosen where the machine's rule does not take it");
equal(choice(cheap, [accepted[0], impact('impulsive', 'fixed32', '0', '1', 'impulsive')]).newmark, 'impulsive', 'and is where it does');
equal('none' in choice(both('energy', '1', '1'), [impact('energy', 'fixed32', '0', '1')]), true, 'energy is never chosen');
for (const broken of ['nan', 'inf', '']) {
  const stability = [{ ...accepted[0], restitution_min: broken }];
  equal([Number.isFinite(restitutionError(stability[0])), 'none' in choice(cheap, stability)], [false, true], `an error that is ${broken || 'missing'} is never chosen`);
  equal(stabilityRows(stability)[0][4], broken === 'inf' ? 'Infinity' : 'NaN', 'and is shown');
}
equal(stabilityRows([...accepted, impact('moment', 'fixed32', '0.02', '1'), impact('moment', 'fixed32', '9', '0')]), [['hunt-crossley', 'moment', 'fixed32', '2', '0.001', '0.02'],
  ['hunt-crossley', 'impulsive', 'fixed32', '0', '0', 'none'], ['hunt-crossley', 'average', 'fixed32', '1', '0.001', 'none']], 'the largest error and gain are of accepted cells');
equal(coupledRows([{ law: 'hertz', newmark: 'auto', numeric: 'fixed32', scenes: '150', faults: '0', energy_gain_max: 'nan' }]), [['hertz', 'auto', 'fixed32', '150', '0', 'NaN']], 'a gain that is no number is no gain of none');
const { rows, points } = budgetOf(costs('2600'), [part, { ...part, target: 'cortex-m0' }]);
equal([rows.length, rows[0].slice(3, 8), points.length], [1, ['10', '2600', { text: '5.1 %', isOver: false }, { text: '51 %', isOver: false }, { text: '253 %', isOver: true }], 1], "the worst step's share of three periods");

// The top of the page.
const glance = (stability, budget = [], points = []) => atAGlance(points, budget, stability, [part]);
const safe = [impact('auto', 'float64', '0', '1'), impact('auto', 'float64', '0.0009', '1'), impact('auto', 'float64', '9', '0')];
equal(glance(safe)[3][0], '0 of 2', 'no accepted cell gains');
for (const gain of ['0.0011', 'nan', 'inf', '']) equal(glance([...safe, impact('auto', 'float64', gain, '1')])[3][0], '1 of 3', `a gain of ${gain || 'nothing'} is one`);
equal(glance([]).map(([value]) => value), ['not reached', 'not measured', 'not measured', '0 of 0'], 'a value that was not measured is shown as such');
const m4f = (method, cost) => ({ ...point('cortex-m4f', method, 'float32', '9e-7', cost), law: 'hunt-crossley' });
const top = glance([], costs('2571'), pointsFrom(m4f('moment', '10'), m4f('tuned-rk4', '25')));
equal([top[0][0], /baseline \(tuned-rk4\)/.test(top[0][1]), top[1][0], /about 50 % of a 10 kHz period at 72 MHz\.$/.test(top[1][1])], ['2.5×', true, '2571', true], 'cost and budget');

// Headings.
const rebound = (damping, restitution_max) => ({ damping, stated: '0.5', restitution_min: '0.5', restitution_max });
const swing = (rig, ball_friction_N, attenuation) => ({ rig, ball_friction_N, attenuation });
const stop = (contact_stiffness, method, error_m, ns_per_simulated_second) => ({ contact_stiffness, step_s: '0.001', method, numeric: 'float64', error_m, ns_per_simulated_second });
const stops = [stop('1e5', 'auto', '1e-9', '10'), stop('1e5', 'event-rk4', '1e-7', '5'), stop('1e5', 'event-rk4', '9e-9', '30'), stop('1e9', 'auto', '2e-8', '10'), stop('1e9', 'moment-4', '5e-7', '5'), stop('1e9', 'event-rk4', '2e-7', '20')];
equal(stiffText(stops).match(/at [0-9]+( of [0-9]+|\.)|[0-9.∞]+ to [0-9.∞]+/g), ['at 1 of 2', 'at 1.', '0.5 to 4', 'at 1 of 2', 'at 1.', '3 to 3'], 'where a method that locates the touch is cheaper, it is said');
const fixed = { ...stop('1e9', 'auto', '5e-6', '10'), numeric: 'fixed32' };
const headings = findings({ stiff: [...stops, fixed], stability: [...safe, impact('average', 'float64', '1', '1')], coupled: [{ newmark: 'auto', energy_gain_max: '1e-4' }, { newmark: 'auto', energy_gain_max: '2e-3' }, { newmark: 'average', energy_gain_max: '9' }],
  restitution: [rebound('flores', '0.6'), rebound('exact', '0.5001'), rebound('exact', '0.502'), rebound('hu-guo', '0.53')],
  attenuation: [swing('level', '0', '0.5'), swing('level', '0.5', '0.9'), swing('upright', '0', '0.25'), swing('upright', '0', '0.2')] },
  { rows: [[{ isStrong: true }], [{ isStrong: false }], [{ isStrong: false }]] }, { rows: [[0, 0, 0, 0, 0, 0, { isOver: true }], [0, 0, 0, 0, 0, 0, { isOver: false }]] }, { 2: 'It holds here', 4: '**It does not hold here**' });
equal(Object.values(headings).map((text) => text.match(/[0-9.]+%? of [0-9]+|[0-9.]+(?= of the energy)|[0-9.]+ %|within [0-9.]+|[0-9.e-]+(?=, 0, 0 m)/g)), [['2 of 3'], ['2e-8', '5e-6'], ['0 of 2', '1 of 1'], ['0.002'], ['within 0.002', 'within 0.03'], ['50 %', '25 %'], ['1 of 2'], ['1 of 2']], 'a heading says what its section found');

// Orders.
const errors = ['0.001', '0.0005', '0.00025', '0.000125', '6.25e-05'].map((step_s, i) => ({ part: 'weight', newmark: 'energy', numeric: 'float64', step_s, error_m: String(0.25 ** i), order: '', ledger_open_J: '0.125' }));
equal(partsRows(errors)[0].slice(7), ['0.0039', '2', '0.13'], 'an order is the average over four halvings');
equal(partsRows(errors.slice(0, 4))[0].slice(6), ['0.016', '', '', '0.13'], 'and needs them all');
equal(partsRows(errors.map((row) => ({ ...row, numeric: 'fixed32' })))[0][8], '', 'and double');

// The paper's claims.
const figures = (peaks) => [...[2, 4, 6].map((figure, i) => [figure, 'peak_m', peaks[i]]), ...[2, 4, 6].map((figure) => [figure, 'peak_without_absorber_m', 0.0376]),
  ...[2, 4, 6].map((figure, i) => [figure, 'peak_reference_m', peaks[i]]), ...[2, 4, 6].map((figure) => [figure, 'difference_from_reference_in_1_s_m', 1e-9]), ...[2, 4, 6].map((law, i) => [7, 'peak_m', peaks[i], law]),
  ...[2, 4, 6].map((law, i) => [9, 'attenuation', 1 - peaks[i] / 0.0376, law]), ...[2, 4, 6].map((law, i) => [10, 'dissipated_J', [0.5, 0, 0.6][i], law]), ...[2, 6].flatMap((law) => [[8, 'peak_reference_at_restitution_0.4_m', 0.016, law], [8, 'peak_reference_at_restitution_1_m', law === 2 ? 0.02 : 0.03, law]])]
  .map(([figure, quantity, value, law = figure]) => ({ figure: String(figure), law: { 2: 'hooke-newton', 4: 'hertz', 6: 'hunt-crossley' }[law], quantity, value: String(value) }));
const shows = (texts) => Object.fromEntries(Object.entries(texts).map(([figure, text]) => [figure, !text.includes('**It does not hold here**')]));
const all = (holds) => ({ 2: true, 4: true, 6: true, 7: true, 8: true, 9: true, 10: true, ...holds });
equal(shows(paperSentences(figures([0.0178, 0.0381, 0.0176]))), all({}), 'each claim shows');
equal(shows(paperSentences(figures([0.0175, 0.0176, 0.0381]))), all({ 4: false, 6: false, 7: false, 9: false }), 'or does not');
equal(/largest 17\.8 mm against 37\.6 mm without/.test(paperSentences(figures([0.0178, 0.0381, 0.0176]))[2]), true, 'with the numbers');
equal(shows(paperSentences(figures([NaN, NaN, NaN]))), all({ 2: false, 4: false, 6: false, 7: false, 9: false }), 'a NaN shows nothing');
finish();
