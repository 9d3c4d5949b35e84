// The sentences of the report, computed from its tables, without a document. If a baseline costs less or a claim of the
// paper does not hold, the text says so. **Words** between stars are strong. A cell of a table is a text, or { text, note,
// value, isStrong, isOver } if it is sorted by another value.

import { short } from '../../explorer/numbers.mjs';

export const laws = ['hooke-newton', 'hertz', 'hunt-crossley'], targets = ['cortex-m4f', 'cortex-m3', 'host'];
export const number = (text) => (text === 'inf' ? Infinity : text === '' ? NaN : Number(text));  // Number('') is 0
const largest = (rows, of, least = -Infinity) => Math.max(least, ...rows.map(of));  // NaN where one is
const groupsOf = (rows, ...columns) => {
  const groups = new Map();
  for (const row of rows) {
    const key = columns.map((column) => row[column]).join();
    groups.set(key, [...(groups.get(key) ?? []), row]);
  }
  return [...groups.values()];
};

// Error against run time. A point's cost is in instructions, on the host nanoseconds, per simulated second. `steel` is
// Hunt-Crossley at a stop of 1e10 N/m^(3/2).
export const steel = 'hunt-crossley-1e10';
export const pointsOf = ({ error_vs_time, accuracy, stiff, stiff_time }) => [
  ...error_vs_time.map((row) => ({ ...row, cost: number(row.instructions_per_simulated_second) })),
  ...accuracy.map((row) => ({ ...row, target: 'host', method: row.newmark, cost: row.host_ns_per_step / row.step_s })),
  ...stiff_time.map((row) => ({ ...row, law: steel, cost: number(row.instructions_per_simulated_second) })),
  ...stiff.filter((row) => number(row.contact_stiffness) === 1e10).map((row) => ({ ...row, target: 'host', law: steel, cost: number(row.ns_per_simulated_second) })),
].map((row) => ({ ...row, error: number(row.error_m), step: number(row.step_s) }));

const isBaseline = ({ method }) => /^(textbook|tuned|event)-/.test(method);
// Newmark's schemes, which the kernel has for comparison. The paper's is the average acceleration.
const isClassical = ({ method }) => ['average', 'linear', 'fox-goodwin', 'central'].includes(method);
// The kernel's formats: those of an FPU on Cortex-M4F, fixed point without one, any on the host.
const isKernel = (row) => !isBaseline(row) && (row.target === 'host' || (row.numeric === 'fixed32') === (row.target === 'cortex-m3'));
const at = (points, target, law) => points.filter((row) => row.target === target && row.law === law);
const cheapest = (points) => points.reduce((best, row) => (best && best.cost <= row.cost ? best : row), undefined);

// The cheapest ways of the kernel and of the baselines to an error, or undefined if none reaches it.
export function duel(points, target, law, error) {
  const able = at(points, target, law).filter((row) => row.error <= error);
  const kernel = cheapest(able.filter(isKernel)), baseline = cheapest(able.filter(isBaseline));
  return { kernel, baseline, ratio: kernel ? (baseline ? baseline.cost / kernel.cost : Infinity) : 0 };
}

const stepText = (s) => (s < 0.999e-3 ? `${short(1e6 * s)} µs` : `${short(1e3 * s)} ms`);
const costText = ({ target, cost }) => short(cost / 1e3) + (target === 'host' ? ' µs' : ' thousand instructions');
export const pointText = (row) =>
  `${row.method} in ${row.numeric}${row.contact_steps > 0 ? ` with ${row.contact_steps} steps in a contact` : ''} · step ${stepText(row.step)} · error ${short(row.error, 2)} m · ${costText(row)} per simulated second`;

export function advantage(points) {
  const wayCell = (row) => (row ? { text: costText(row), note: `${row.method}, ${row.numeric}, ${stepText(row.step)}`, value: row.cost }
    : { text: 'not reached', value: '' });
  const rows = [], lost = [];
  for (const target of targets)
    for (const law of [...laws, steel])
      for (let level = -3; level >= -9; --level) {
        const { kernel, baseline, ratio } = duel(points, target, law, Number(`1e${level}`));
        if (!kernel && !baseline) continue;
        const isLost = ratio < 1;
        if (isLost) lost.push(`${target}, ${law} at 1e${level} m`);
        const text = ratio === 0 ? 'kernel does not reach it' : ratio === Infinity ? '∞' : short(ratio);
        rows.push([target, law, `1e${level}`, wayCell(kernel), wayCell(baseline), { text, value: ratio, isStrong: isLost }]);
      }
  return { rows, text: lost.length === 0 ? 'No baseline reaches any error from 1e-3 to 1e-9 m for less.'
    : `**A baseline costs less** on ${lost.join('; ')}.` };
}

// The points whose error no other reaches at less cost, cheapest first, by series.
export function frontiers(points, target, law) {
  const here = at(points, target, law), own = here.filter(isKernel);
  const best = (rows) => rows.sort((a, b) => a.cost - b.cost || a.error - b.error)
    .reduce((found, row) => (found.length === 0 || row.error < found.at(-1).error ? [...found, row] : found), []);
  return { kernel: best(own.filter((row) => !isClassical(row))), 'best baseline': best(here.filter(isBaseline)),
    "paper's scheme": best(own.filter(({ method }) => method === 'average')) };
}

// A configuration under a sine without weight, base and friction: (target, law, newmark, numeric) => { free, contact, worst }.
export function configurationsOf(budget) {
  const found = new Map();
  for (const row of budget) {
    const key = [row.target, row.law, row.newmark, row.numeric].join();
    if (row.drive === 'sine' && ['free', 'contact'].includes(row.phase)) found.set(key, { ...found.get(key), [row.phase]: row });
  }
  return (...names) => {
    const { free, contact } = found.get(names.join()) ?? {};
    return free && contact && { free, contact, worst: largest([free, contact], (row) => number(row.instructions_max)) };
  };
}
export const timeOf = ({ worst }, part) => worst * part.cycles / part.clock;  // s

// Largest step on each part: points of the picture, and the rows of those that run at full speed.
export function budgetOf(budget, parts) {
  const configuration = configurationsOf(budget), points = [], rows = [];
  for (const part of parts)
    for (const law of laws)
      for (const numeric of ['fixed32', 'float32', 'float32-plain']) {
        const found = configuration(part.target, law, 'moment', numeric);
        if (!found) continue;
        const time = timeOf(found, part), { free, worst } = found;
        points.push({ part, law, numeric, time,
          text: `${law} in ${numeric} on ${part.target} · ${worst} instructions · ${short(1e6 * time)} µs` });
        if (!part.has_fpu && numeric !== 'fixed32') continue;
        rows.push([{ text: part.target, note: part.name }, law, numeric, short(number(free.instructions_mean)), String(worst),
          ...[1e3, 1e4, 5e4].map((rate) => ({ text: `${short(100 * time * rate, 2)} %`, isOver: time * rate > 1 })),
          free.flash_bytes, free.ram_bytes, free.stack_bytes]);
      }
  return { points, rows };
}

// Free impacts.
export const restitutionError = (row) => largest([row.restitution_min, row.restitution_max],
  (text) => Math.abs(number(text) - number(row.restitution_exact)));
export const gainsEnergy = (row) => !(number(row.energy_gain_max) <= 1e-3);  // more than a thousandth of the impact's energy, or a NaN
const gainText = (gain) => (gain <= 0 ? 'none' : short(gain, 2));
export const stabilityRows = (stability) => groupsOf(stability, 'law', 'newmark', 'numeric').map((rows) => {
  const cells = rows.filter(({ accepted }) => accepted === '1'), [{ law, newmark, numeric }] = rows;
  return [law, newmark, numeric, String(cells.length), short(largest(cells, restitutionError, 0)),
    gainText(largest(cells, (row) => number(row.energy_gain_max), 0))];
});
export const coupledRows = (coupled) => coupled.map(({ law, newmark, numeric, scenes, faults, energy_gain_max }) =>
  [law, newmark, numeric, scenes, faults, gainText(number(energy_gain_max))]);

// With weight, a shaken base and friction. The order is the average over four halvings of the step, in float64, in which
// rounding does not matter.
export const partSteps = ['0.001', '0.0005', '0.00025', '0.000125', '6.25e-05'];
export const partsRows = (accuracy) => groupsOf(accuracy, 'part', 'newmark', 'numeric').map((rows) => {
  const [{ part, newmark, numeric }] = rows, errors = partSteps.map((step) => number(rows.find((row) => row.step_s === step)?.error_m ?? ''));
  const order = numeric === 'float64' ? Math.log2(errors[0] / errors[4]) / 4 : NaN;
  return [part, newmark, numeric, ...[...errors, order].map((value) => (Number.isNaN(value) ? '' : short(value, 2))),
    short(largest(rows, (row) => number(row.ledger_open_J), 0), 2)];
});

// What to choose. The candidates are the configurations that the plan accepts for a stop and whose worst step fits into
// half of the period. The choice has the smallest restitution error, at most 2e-3. Of those within 1e-5 it is the cheapest.
// The energy-consistent step is no candidate, since its motion is of second order. Impulsive is one only if the kernel's
// rule takes it for the paper's main mass, because the restitution of free masses does not show how long a contact lasts.
// Stability is known on a grid of quarters of a decade of step and halves of a decade of stiffness.
const types = { 'hooke-newton': 'HookeNewton', hertz: 'Hertz', 'hunt-crossley': 'HuntCrossley', moment: 'Moment',
  'moment-4': 'SubsteppedMoment<4>', 'moment-n': 'SubsteppedMoment<>', impulsive: 'Impulsive', average: 'AverageAcceleration', linear: 'LinearAcceleration',
  'fox-goodwin': 'FoxGoodwin', central: 'CentralDifference', fixed32: 'Fixed32', float32: 'Float32' };
export function chooserOf(budget, stability) {
  const configuration = configurationsOf(budget), candidates = new Map();
  const placeOf = (law, step, stiffness) => [law, Math.round(4 * Math.log10(step)), Math.round(2 * Math.log10(stiffness))].join();
  for (const row of stability) {
    const error = Math.max(1e-5, restitutionError(row)), place = placeOf(row.law, row.step_s, row.contact_stiffness);
    if (row.accepted !== '1' || row.newmark === 'energy' || !(error <= 2e-3)) continue;
    if (row.newmark === 'impulsive' && row.machine_rule !== 'impulsive') continue;
    candidates.set(place, [...(candidates.get(place) ?? []), { newmark: row.newmark, numeric: row.numeric, error }]);
  }
  return (part, law, rate, stiffness) => {
    const all = (candidates.get(placeOf(law, 1 / rate, stiffness)) ?? []).flatMap((candidate) => {
      const cost = configuration(part.target, law, candidate.newmark, candidate.numeric);
      return cost ? [{ ...candidate, cost, share: timeOf(cost, part) * rate }] : [];
    });
    const [best] = all.filter(({ share }) => share <= 0.5).sort((a, b) => a.error - b.error || a.share - b.share);
    if (!best) return { none: `none: ${all.length > 0 ? 'the worst step takes more than half of the period' : 'the contact is shorter than these steps resolve'}` };
    const { newmark, numeric, error, cost: { worst, free }, share } = best;
    return { newmark, numeric, worst, share, time: share / rate, error: error <= 1e-5 ? '1e-5' : short(error, 2),
      types: [law, newmark, numeric].map((name) => types[name]),
      memory: free.flash_bytes && `${free.flash_bytes} bytes of flash, ${free.ram_bytes} of RAM, ${free.stack_bytes} of stack` };
  };
}
export function choiceRows(budget, stability, parts) {
  const choose = chooserOf(budget, stability), configuration = configurationsOf(budget);
  return parts.flatMap((part) => [1e3, 1e4, 5e4].flatMap((rate) => [3.2e4, 1e7, 1e10].map((stiffness) => {
    const [root, lookup] = ['sqrt', 'lookup'].map((power) =>
      number(configuration(part.target, 'hunt-crossley', `textbook-rk4-${power}`, 'float32-plain')?.contact.instructions_mean ?? ''));
    const { none, newmark, numeric, share, error } = choose(part, 'hunt-crossley', rate, stiffness);
    return [part.target, `${rate / 1e3} kHz`, stiffness.toExponential().replace('e+', 'e'), ...(none ? [none, '', '', '', '']
      : [newmark, numeric, `${short(100 * share, 2)} %`, error === '1e-5' ? 'below 1e-5' : error, numeric !== 'fixed32' && root < lookup ? 'square root' : 'table'])];
  })));
}

const gainsOf = (stability, method) => {
  const cells = stability.filter((row) => row.newmark === method && row.numeric === 'float64' && row.accepted === '1');
  return `${cells.filter(gainsEnergy).length} of ${cells.length}`;
};

// The lowest cost of an error at stops of any stiffness, in ns for a simulated second on the host, or Infinity if it is not
// reached. It is that of the kernel with its best stepper, of the kernel with the rule's stepper, and of event-rk4.
export function stiffDuels(stiff, error) {
  return groupsOf(stiff, 'contact_stiffness').map((rows) => {
    const best = (is) => Math.min(...rows.filter((row) => is(row.method) && row.numeric === 'float64' && number(row.error_m) <= error).map((row) => number(row.ns_per_simulated_second)));
    const isPeer = (method) => method === 'event-rk4';
    return { stiffness: number(rows[0].contact_stiffness), kernel: best((method) => !isPeer(method)), auto: best((method) => method === 'auto'), peer: best(isPeer) };
  });
}
export function stiffText(stiff) {
  return [1e-6, 1e-8].map((error) => {
    const all = stiffDuels(stiff, error), ratios = all.filter(({ kernel, peer }) => kernel < Infinity && peer < Infinity).map(({ kernel, peer }) => peer / kernel);
    const wins = (side) => all.filter((both) => both[side] < both.peer).length;
    return `For ${error.toExponential()} m the kernel takes less time than event-rk4 at ${wins('kernel')} of ${all.length} stiffnesses, each with its best settings. With the rule's stepper that is so at ${wins('auto')}.`
      + (ratios.length > 0 ? ` With the best settings event-rk4 takes ${short(Math.min(...ratios), 2)} to ${short(Math.max(...ratios), 2)} times as long.` : '');
  }).join(' ');
}

// The headings of the sections, which state their findings, by id. `ways` is from advantage(), `budget` from budgetOf().
export function findings({ stability, stiff, coupled, restitution, attenuation }, ways, budget, sentences) {
  const missed = (rows) => largest(rows, (row) => largest([row.restitution_min, row.restitution_max], (text) => Math.abs(number(text) - number(row.stated))), 0);
  const [exact, formulas] = [true, false].map((isExact) =>
    Math.min(...groupsOf(restitution, 'damping').filter(([{ damping }]) => (damping === 'exact') === isExact).map(missed)));
  const taken = (rig) => `${short(100 * largest(attenuation.filter((row) => row.rig === rig && !(number(row.ball_friction_N) > 0)), (row) => number(row.attenuation)), 2)} %`;
  const stiffSteps = [1e-3, 1e-4, 1e-5], worstError = (numeric) => stiffSteps.map((step) =>
    short(largest(stiff.filter((row) => row.method === 'auto' && row.numeric === numeric && number(row.step_s) === step), (row) => number(row.error_m), 0), 2)).join(', ');
  const won = ways.rows.filter((row) => !row.at(-1).isStrong).length, inTime = budget.rows.filter((row) => !row[6].isOver).length;
  const claims = Object.values(sentences), shown = claims.filter((text) => !text.includes('**')).length;
  return {
    time: `The kernel costs less than every baseline in ${won} of ${ways.rows.length} comparisons`,
    stiff: `At any stiffness the kernel's error is at most ${worstError('float64')} m in double, ${worstError('fixed32')} m in Fixed32 (at ${stiffSteps.map((step) => short(1e3 * step)).join(', ')} ms)`,
    stability: `Contact gains energy in ${gainsOf(stability, 'auto')} cells with the kernel's choice, in ${gainsOf(stability, 'average')} with the paper's scheme`,
    coupled: `In coupled scenes the kernel's choice gains at most ${short(largest(coupled.filter(({ newmark }) => newmark === 'auto'), (row) => number(row.energy_gain_max), 0), 2)} of the energy`,
    restitution: `The restitution that comes out is within ${short(exact, 2)} of the stated one with exact, within ${short(formulas, 2)} with the best formula`,
    parts: `The ball reduces the swing by up to ${taken('level')} on a level rig and ${taken('upright')} on an upright one`,
    budget: `${inTime} of ${budget.rows.length} worst steps fit into a period at 10 kHz`,
    paper: `The paper's claims hold here in ${shown} of ${claims.length} figures`,
  };
}

// The top of the page: numbers, each with its claim.
export function atAGlance(points, budget, stability, parts) {
  const times = ({ kernel, ratio }) => (!kernel ? 'not reached' : ratio === Infinity ? '∞' : `${short(ratio, 2)}×`);
  const [fpu, integer] = targets.map((target) => duel(points, target, 'hunt-crossley', 1e-6));
  const [m3, m0] = ['cortex-m3', 'cortex-m0'].map((target) => {
    const part = parts.find((each) => each.target === target), found = configurationsOf(budget)(target, 'hunt-crossley', 'moment', 'fixed32');
    return found && { worst: found.worst, share: `about ${short(1e6 * timeOf(found, part), 2)} % of a 10 kHz period` };
  });
  const precise = at(points, 'host', 'hunt-crossley').find((row) => row.method === 'moment' && row.numeric === 'fixed32' && row.step === 1e-4);
  const [own, paper, rk4] = ['auto', 'average', 'textbook-rk4'].map((method) => gainsOf(stability, method));
  return [
    [times(fpu), `fewer instructions than the cheapest baseline (${fpu.baseline?.method ?? 'none'}) for an error of 1 µm over a second of the paper's scene on a Cortex-M4F. On a Cortex-M3, which has no FPU, it is ${times(integer)}.`],
    [m3 ? String(m3.worst) : 'not measured', (m3 ? `instructions is the longest step in the paper's scene on a Cortex-M3, ${m3.share} at 72 MHz` : 'The longest step on a Cortex-M3')
      + (m0 ? `; on a Cortex-M0, the smallest core, ${m0.worst}, ${m0.share}.` : '.')],
    [precise ? `${short(1e9 * precise.error, 2)} nm` : 'not measured', "is the largest error of the main mass's position over a second of the paper's scene at 10 kHz, in 32-bit fixed point."],
    [own, `combinations of step, stop and law create more than a thousandth of the energy of a free impact with the kernel's choice. With the paper's scheme it is ${paper}, with the classical Runge-Kutta method ${rk4}. They span 3 decades of step and 9 of stiffness.`],
  ];
}

// The paper's claims about its figures, and whether they hold here. The texts are by figure.
export function paperSentences(figures) {
  const values = new Map(figures.map((row) => [[row.figure, row.law, row.quantity].join(), number(row.value)]));
  const value = (figure, law, quantity) => values.get([figure, law, quantity].join());
  const verdict = (shows) => (shows ? 'It holds here' : '**It does not hold here**'), mm = (metres) => `${short(1e3 * metres, 4)} mm`;
  const ofLaws = (figure, quantity) => laws.map((law) => value(figure, law, quantity));
  const isCloser = ([hn, hz, hc]) => Math.abs(hn - hc) < Math.abs(hz - hc);
  const texts = {};
  for (const [figure, law, claim, attenuates] of [[2, 'hooke-newton', "the main mass's amplitude decreases", true],
    [4, 'hertz', 'amplitudes increase instead of decreasing', false], [6, 'hunt-crossley', 'amplitudes decrease', true]]) {
    const [peak, exact, bare, early] = ['peak_m', 'peak_reference_m', 'peak_without_absorber_m', 'difference_from_reference_in_1_s_m'].map((quantity) => value(figure, law, quantity));
    texts[figure] = `Claim: ${claim}. ${verdict(attenuates ? peak < bare : peak > bare)}: largest ${mm(peak)} against ${mm(bare)} without absorber (reference: ${mm(exact)}). Over the first second kernel and reference are within ${short(early, 2)} m.`
      + (Math.abs(peak - exact) > 0.01 * exact ? ' Later they differ, as any two computations do, because the motion is chaotic. The largest value in 5 s is that of one start, not of the law.' : '');
  }
  const [hn, hz, hc] = ofLaws(7, 'peak_m');
  texts[7] = `Claim: the amplitude is lowest with Hunt-Crossley, and Hooke-Newton is closer to it than Hertz is. ${verdict(hc <= hn && isCloser([hn, hz, hc]))}: ${mm(hc)}, ${mm(hn)} and ${mm(hz)}.`;
  const peakAt = (law, e) => value(8, law, `peak_reference_at_restitution_${e}_m`), spread = (law) => peakAt(law, 1) - peakAt(law, 0.4);
  const [hnAt1, hcAt1, hnSpread, hcSpread] = [peakAt('hooke-newton', 1), peakAt('hunt-crossley', 1), spread('hooke-newton'), spread('hunt-crossley')];
  texts[8] = `Claims: Hunt-Crossley is more sensitive to restitution than Hooke-Newton. At a restitution of 1 Hooke-Newton is lowest and the other two are alike. ${verdict(hcSpread > hnSpread && hnAt1 < hcAt1)} in the reference. From 0.4 to 1 the peak grows by ${mm(hcSpread)} and ${mm(hnSpread)}. At 1 it is ${mm(hnAt1)} against ${mm(hcAt1)}. Where a curve jumps between neighbours the motion is chaotic.`;
  const taken = ofLaws(9, 'attenuation'), [hnTaken, hzTaken, hcTaken] = taken.map((share) => `${short(100 * share)} %`);
  texts[9] = `Claim: Hooke-Newton's attenuation is closer to Hunt-Crossley's than Hertz's is. ${verdict(isCloser(taken))}: ${hnTaken}, ${hcTaken} and ${hzTaken} after 5 s. The paper leaves the measure open; here it is 1 less the ratio of the peaks so far.`;
  const [hnLost, hzLost, hcLost] = ofLaws(10, 'dissipated_J');
  texts[10] = `Claim: Hooke-Newton and Hertz dissipate less than Hunt-Crossley, Hooke-Newton more than Hertz. ${verdict(hzLost < hnLost && hnLost < hcLost)}: ${short(hcLost)} J, ${short(hnLost)} J and ${short(Math.abs(Math.round(1e3 * hzLost) / 1e3))} J.`;
  return texts;
}
