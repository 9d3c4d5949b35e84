// The page: its numbers, sentences, tables and pictures, from the tables that stand in it.

import { short, tableFrom } from '../../explorer/numbers.mjs';
import { chart } from './chart.mjs';
import { advantage, atAGlance, budgetOf, choiceRows, chooserOf, coupledRows, findings, frontiers, gainsEnergy, laws, number, paperSentences, partSteps, partsRows, pointText, pointsOf, restitutionError, stabilityRows, stiffText } from './facts.mjs';

const find = (selector) => document.querySelector(selector), json = (id) => JSON.parse(find(`#${id}`).textContent);
const tables = Object.fromEntries([...document.querySelectorAll('script[type="text/csv"]')].map(({ dataset, textContent }) => [dataset.name, tableFrom(textContent)]));
const parts = json('part-list'), { paper_machine: paperMachine, has_explorer: hasExplorer } = json('facts');
const points = pointsOf(tables), budget = budgetOf(tables.step_budget, parts), sentences = paperSentences(tables.figures), ways = advantage(points);
const rich = (text) => text.replace(/\*\*(.*?)\*\*/g, '<strong>$1</strong>');

find('#explorer').hidden = !hasExplorer;
find('#paper-machine').textContent = paperMachine;
for (const [id, text] of Object.entries(findings(tables, ways, budget, sentences))) find(`#${id}`).textContent = text;
find('#glance').innerHTML = atAGlance(points, tables.step_budget, tables.stability, parts).map(([value, claim]) => `<div><strong>${value}</strong><p>${claim}</p></div>`).join('');
find('#advantage').innerHTML = rich(ways.text);
find('#stiff-cost').textContent = stiffText(tables.stiff);

// Tables, folded, with a link to the file that each was made from; sorted by the column whose head is pressed.
const cellOf = (cell) => {
  const { text, note, value, isStrong, isOver } = typeof cell === 'object' ? cell : { text: cell };
  return `<td${value === undefined ? '' : ` data-value="${value}"`}${isOver ? ' class="over"' : ''}>${isStrong ? `<strong>${text}</strong>` : text}${note ? ` <small>${note}</small>` : ''}</td>`;
};
function showTable(id, title, file, columns, rows) {
  find(`#${id}`).innerHTML = `<details><summary>${title} <a href="${file}">${file}</a></summary><div class="wide"><table aria-label="${title}"><thead><tr>${columns.map((column) => `<th scope="col"><button type="button">${column}</button></th>`).join('')}</tr></thead>
<tbody>${rows.map((row) => `<tr>${row.map(cellOf).join('')}</tr>`).join('\n')}</tbody></table></div></details>`;
  const table = find(`#${id} table`), heads = [...table.tHead.rows[0].cells];
  const valueOf = ({ cells }, column) => cells[column].dataset.value ?? cells[column].textContent;
  const compare = (a, b) => {
    const [first, second] = [parseFloat(a), parseFloat(b)], missing = [first, second].map(Number.isNaN);
    return missing[0] && missing[1] ? a.localeCompare(b) : missing[0] || missing[1] ? missing[0] - missing[1] : first === second ? 0 : first - second;
  };
  heads.forEach((head, column) => head.firstChild.addEventListener('click', () => {
    const direction = head.getAttribute('aria-sort') === 'ascending' ? -1 : 1;
    heads.forEach((other) => other.removeAttribute('aria-sort'));
    head.setAttribute('aria-sort', direction > 0 ? 'ascending' : 'descending');
    table.tBodies[0].append(...[...table.tBodies[0].rows].sort((a, b) => direction * compare(valueOf(a, column), valueOf(b, column))));
  }));
}
showTable('advantage-table', 'The cheapest way to an error', 'error_vs_time.csv', ['target', 'law', 'error, m', 'kernel, per simulated second', 'best baseline', 'ratio'], ways.rows);
showTable('coupled-table', 'Coupled scenes in numbers', 'coupled.csv', ['law', 'stepper', 'format', 'scenes', 'faults', 'largest energy gain'], coupledRows(tables.coupled));
showTable('stability-table', 'Free impacts in numbers, over the cells that the plan accepts', 'stability.csv',
  ['law', 'stepper', 'format', 'accepted cells of 247', 'largest restitution error', 'largest energy gain'], stabilityRows(tables.stability));
showTable('parts-table', 'Errors and orders with each part, against the reference', 'parts_accuracy.csv',
  ['part', 'stepper', 'format', ...partSteps.map((step, i) => `${i === 0 ? 'error, m, at ' : ''}${1e3 * step} ms`), 'order', 'error of the energy balance, J'], partsRows(tables.parts_accuracy));
showTable('budget-table', 'Every part, law and format', 'step_budget.csv',
  ['part', 'law', 'format', 'free, mean', 'largest', '1 kHz', '10 kHz', '50 kHz', 'flash', 'RAM', 'stack'], budget.rows);
showTable('choice-table', 'The choice as a table, for Hunt-Crossley', 'stability.csv',
  ['CPU', 'rate', 'stop, N/m<sup>3/2</sup>', 'stepper', 'format', 'longest step, of the period', 'restitution error', 'cheaper y<sup>3/2</sup>'], choiceRows(tables.step_budget, tables.stability, parts));

// Pictures. Black and gray are ink and grid; the others are Okabe and Ito's colours, which colour-blind readers tell apart;
// dash and marker differ as well.
const [blue, sky, vermilion, green, orange, purple, middle, ink] = ['blue', 'sky', 'vermilion', 'green', 'orange', 'purple', 'middle', 'ink'].map((colour) => `var(--${colour})`);
const lawStyles = { 'hooke-newton': { colour: orange, dash: '6 3' }, hertz: { colour: green, dash: '2 3' }, 'hunt-crossley': { colour: blue } };
const methodStyles = {
  moment: { colour: blue, width: 2.4 }, 'moment-4': { colour: sky }, energy: { colour: vermilion }, impulsive: { colour: green }, average: { colour: orange, dash: '6 3' },
  linear: { colour: purple, dash: '2 3' }, 'fox-goodwin': { colour: green, dash: '8 3 2 3' }, central: { colour: sky, dash: '8 3 2 3 2 3' },
  'textbook-newmark': { colour: ink }, 'textbook-newmark-sqrt': { colour: ink, dash: '6 3' }, 'textbook-rk4': { colour: middle }, 'textbook-rk4-sqrt': { colour: middle, dash: '6 3' },
  'textbook-rk4-lookup': { colour: middle, dash: '2 3' }, 'tuned-rk4': { colour: vermilion, dash: '6 3' },
};
const formats = { fixed32: { marker: 'square', isFilled: true }, float32: { marker: 'circle' }, 'float32-plain': { marker: 'triangle' }, float64: { marker: 'cross' } };
const costAxis = (target) => ({ label: `${target === 'host' ? 'nanoseconds' : 'instructions'} per simulated second`, isLog: true });
const errorAxis = { label: 'largest error of x1, m', isLog: true };
const withCost = (row) => ({ x: row.cost, y: row.error, text: pointText(row) });
const key = (names) => Object.entries(names).map(([name, style]) => ({ name, points: [], ...style }));
const traces = (axis, lines, own = {}) => ({ x: { label: 'time, s' }, y: { label: axis, ...own }, series: lines.map(([column, name, style]) =>
  ({ name, ...style, points: tables.paper_traces.map((row) => ({ x: number(row.t), y: number(row[column]) })) })) });
const besideReference = (what, axis, own) => traces(axis, laws.flatMap((law) =>
  [[`${law} ${what}`, law, lawStyles[law]], [`${law} ${what} reference`, `${law}, reference`, { colour: lawStyles[law].colour, width: 0.9 }]]), own);
const displacement = (law) => traces('displacement of the main mass, mm', [['without-absorber x1', 'without absorber', { colour: middle, width: 0.8 }],
  [`${law} x1`, `${law}, kernel`, { colour: blue, width: 1.8 }], [`${law} x1 reference`, `${law}, reference`, { colour: vermilion, width: 1, dash: '6 3' }]]);
const paperPictures = {
  2: () => displacement('hooke-newton'), 4: () => displacement('hertz'), 6: () => displacement('hunt-crossley'),
  7: () => traces('displacement of the main mass, mm', ['hertz', 'hooke-newton', 'hunt-crossley'].map((law) => [`${law} x1`, law, lawStyles[law]])),
  8: () => ({ x: { label: 'coefficient of restitution' }, y: { label: 'largest displacement in 5 s, mm' }, series: laws.flatMap((law) => [['', { ...lawStyles[law], marker: 'circle' }], [' reference', { colour: lawStyles[law].colour, width: 0.9 }]]
    .map(([of, style]) => ({ name: law + of, ...style, points: tables.paper_restitutions.map((row) => ({ x: number(row.restitution), y: number(row[law + of]) })) }))) }),
  9: () => traces('attenuation of the peak so far, %', laws.map((law) => [`${law} attenuation`, law, lawStyles[law]])),
  10: () => besideReference('dissipated', 'energy dissipated by contact, J'),
};
const classes = [[1e-4, '#deebf7'], [1e-3, '#9ecae1'], [1e-2, '#4292c6'], [1e-1, '#fdae61'], [Infinity, '#b2182b']];
const steppers = ['auto', 'moment', 'moment-4', 'moment-8', 'energy', 'impulsive', 'average'], numerics = ['float64', 'float32', 'float32-plain', 'fixed32'];
const clamped = (value, least, most) => (Number.isNaN(value) ? most : Math.min(Math.max(value, least), most));  // what is beyond stands at the edge

// The name and arguments that a figure's data-chart says.
const pictures = {
  frontier: (law, target) => ({ x: costAxis(target), y: errorAxis, series: Object.entries(frontiers(points, target, law)).map(([name, rows], i) =>
    ({ name, points: rows.map(withCost), ...[{ colour: blue, width: 3, marker: 'square', isFilled: true }, { colour: vermilion, width: 2, dash: '6 3', marker: 'circle', isFilled: true }, { colour: orange, width: 2, dash: '8 3 2 3', marker: 'triangle' }][i] })) }),
  every: (law, target) => {
    const here = points.filter((row) => row.law === law && row.target === target), has = (column) => ([name]) => here.some((row) => row[column] === name);
    const methods = Object.entries(methodStyles).filter(has('method')), markers = Object.entries(formats).filter(has('numeric'));
    return { height: 460, x: costAxis(target), y: errorAxis, series: [
      { name: target === 'host' ? '' : 'frontier', colour: 'var(--grid)', width: 9, points: here.filter((row) => row.frontier === '1').sort((a, b) => a.cost - b.cost).map(({ cost, error }) => ({ x: cost, y: error })) },
      ...methods.flatMap(([method, style]) => markers.map(([numeric, marker]) => ({ ...style, ...marker, points: here.filter((row) => row.method === method && row.numeric === numeric).map(withCost) }))),
      ...key(Object.fromEntries(methods)), ...key(Object.fromEntries(markers.map(([numeric, marker]) => [numeric, { ...marker, width: 0 }])))] };
  },
  errors: (law) => ({ x: { label: 'step, s', isLog: true }, y: errorAxis, series: ['moment', 'average'].flatMap((method) => Object.keys(formats).reverse().map((numeric) => ({
    name: numeric === 'float64' ? `${method}: method` : `${method}: rounding, ${numeric}`, colour: methodStyles[method].colour, ...(numeric === 'float64' ? { width: 2.4 } : { width: 1, dash: '6 3', ...formats[numeric] }),
    points: tables.accuracy.filter((row) => row.law === law && row.newmark === method && row.numeric === numeric)
      .map((row) => ({ x: number(row.step_s), y: number(numeric === 'float64' ? row.method_error_m : row.rounding_error_m) })) }))) }),
  stability: (law, stepper, numeric) => ({ width: 400, height: 300, x: { label: 'step, s', isLog: true, range: [7.5e-6, 1.33e-2] }, y: { label: 'contact stiffness', isLog: true, range: [5.6e2, 1.78e12] }, cell: [0.25, 0.5],
    cells: tables.stability.filter((row) => row.law === law && row.newmark === stepper && row.numeric === numeric).map((row) => ({
      x: number(row.step_s), y: number(row.contact_stiffness), colour: (classes.find(([most]) => restitutionError(row) <= most) ?? classes.at(-1))[1], isFaded: row.accepted === '0', isCrossed: gainsEnergy(row),
      text: `step ${short(row.step_s)} s · stiffness ${short(number(row.contact_stiffness), 2)} · restitution ${row.restitution_min} to ${row.restitution_max}, exact ${row.restitution_exact} · energy gain ${row.energy_gain_max}` })) }),
  stiff: () => ({ x: { label: 'stiffness of the stops, N/m^(3/2)', isLog: true }, y: { label: 'largest error of x1 over 0.4 s, m', isLog: true },
    series: [['auto', 'float64', 'kernel', { colour: blue }], ['auto', 'fixed32', 'kernel, fixed32', { colour: sky }], ['event-rk4', 'float64', 'event-rk4', { colour: ink }]].flatMap(([method, numeric, name, style]) =>
      [[1e-3, {}], [1e-4, { dash: '6 3' }], [1e-5, { dash: '2 3' }]].map(([step, dash]) => ({ name: `${name}, ${1e3 * step} ms`, width: 2, ...style, ...dash,
        points: Object.values(tables.stiff.filter((row) => row.method === method && row.numeric === numeric && number(row.step_s) === step).reduce((best, row) => {
          const at = row.contact_stiffness;
          return !best[at] || number(row.error_m) < number(best[at].error_m) ? { ...best, [at]: row } : best;
        }, {})).map((row) => ({ x: number(row.contact_stiffness), y: number(row.error_m),
          text: `${name}, ${1e3 * step} ms · stiffness ${short(number(row.contact_stiffness), 2)} · error ${short(number(row.error_m), 2)} m · ${short(1e-3 * row.ns_per_simulated_second, 2)} µs a simulated second` })) }))) }),
  coupled: () => ({ width: 720, left: 70, x: { range: [0.5, 7.5], ticks: steppers.map((stepper, i) => [i + 1, stepper]) }, y: { label: 'largest relative energy gain', isLog: true, range: [1e-16, 1e3] },
    rules: [{ y: 1e-2 }], series: laws.map((law, i) => ({ name: law, width: 0, colour: lawStyles[law].colour, marker: ['triangle', 'square', 'circle'][i],
      points: tables.coupled.filter((row) => row.law === law).map((row) => ({ x: steppers.indexOf(row.newmark) + 1 + 0.2 * (numerics.indexOf(row.numeric) - 1.5) + 0.05 * (i - 1), y: clamped(number(row.energy_gain_max), 1e-16, 1e3),
        text: `${law}, ${row.newmark} in ${row.numeric} · ${row.scenes} scenes, ${row.faults} faults · energy gain ${row.energy_gain_max}` })) })) }),
  restitution: () => ({ height: 460, x: { label: 'stated restitution', range: [0, 1] }, y: { label: 'restitution that comes out', range: [0, 1] },
    series: Object.entries({ exact: { colour: ink }, 'hu-guo': { colour: blue, dash: '6 3' }, flores: { colour: sky, dash: '8 3 2 3' }, 'hunt-crossley': { colour: vermilion }, 'herbert-mcwhannell': { colour: orange, dash: '6 3' }, 'lankarani-nikravesh': { colour: green, dash: '8 3 2 3' }, 'lee-wang': { colour: purple } })
      .map(([name, style]) => ({ name, width: 2, ...style, points: tables.restitution.filter((row) => row.damping === name).map((row) => ({ x: number(row.stated), y: (number(row.restitution_min) + number(row.restitution_max)) / 2 })) })) }),
  attenuation: () => ({ x: { label: 'angular frequency of the drive, rad/s' }, y: { label: 'attenuation, %', range: [-100, 100] }, rules: [{ y: 0 }],
    series: [['level', false, { colour: blue }], ['level', true, { colour: sky, dash: '6 3' }], ['upright', false, { colour: vermilion }], ['upright', true, { colour: orange, dash: '6 3' }]].map(([rig, rubs, style]) => ({ name: rubs ? `${rig}, friction` : rig, width: 2.4, ...style,
      points: tables.attenuation.filter((row) => row.rig === rig && number(row.ball_friction_N) > 0 === rubs).map((row) => ({ x: number(row.pulsation), y: clamped(100 * number(row.attenuation), -100, 100),
        text: `${rig}, friction ${row.ball_friction_N} N · ${row.pulsation} rad/s · swing ${short(1e3 * row.swing_m)} mm, ${short(1e3 * row.swing_without_m)} without the ball · attenuation ${short(100 * row.attenuation, 2)} %` })) })) }),
  budget: () => ({ width: 560, left: 190, x: { label: 'worst step, µs', isLog: true }, y: { range: [0.5, parts.length + 0.5], ticks: parts.map(({ target, name }, i) => [parts.length - i, `${target}, ${name.split(',')[0]}`]) },
    rules: [{ x: 1000 }, { x: 100 }, { x: 20 }], series: [...laws.flatMap((law, i) => Object.keys(formats).map((numeric) => ({ width: 0, colour: lawStyles[law].colour, ...formats[numeric],
      points: budget.points.filter((point) => point.law === law && point.numeric === numeric).map(({ part, time, text }) => ({ x: 1e6 * time, y: parts.length - parts.indexOf(part) + 0.2 * (1 - i), text })) }))),
      ...key(Object.fromEntries(laws.map((law) => [law, { width: 2, colour: lawStyles[law].colour }]))), ...key({ fixed32: { width: 0, ...formats.fixed32 }, float32: { width: 0, ...formats.float32 }, 'float32-plain': { width: 0, ...formats['float32-plain'] } })] }),
  paper: (figure) => paperPictures[figure](),
};
const names = { frontier: 'Error against run time, the best of each kind', every: 'Error against run time, every method', errors: 'Errors of method and rounding', stability: 'Restitution error over step and stiffness', stiff: 'Error against stiffness' };

// The figures that a list names.
for (const law of laws) {
  const maps = [...new Set(tables.stability.filter((row) => row.law === law).map(({ newmark, numeric }) => `${newmark} ${numeric}`))].filter((map) => !/float32/.test(map));
  find(`#maps-${law}`).innerHTML = maps.filter((map) => !find(`[data-chart="stability ${law} ${map}"]`)).map((map) => `<figure data-chart="stability ${law} ${map}"><figcaption>${map.replace(' ', ', ')}</figcaption></figure>`).join('');
}
find('#other-laws').innerHTML = ['hertz', 'hooke-newton'].flatMap((law) => ['cortex-m4f', 'cortex-m3', 'host'].flatMap((target) => ['frontier', 'every'].map((chart) =>
  `<figure class="${chart}" data-chart="${chart} ${law} ${target}"><figcaption>${law}, ${target}</figcaption></figure>`))).join('');
for (const caption of document.querySelectorAll('[data-paper]')) caption.innerHTML += ` ${rich(sentences[caption.dataset.paper])}`;

// Draws a figure. A point says what it is: the nearest to the pointer or the finger.
const tip = document.body.appendChild(document.createElement('div')), reach = 28;  // CSS pixels
tip.id = 'tip';
tip.hidden = true;
for (const figure of document.querySelectorAll('[data-chart]')) {
  const [name, ...of] = figure.dataset.chart.split(' '), drawn = chart({ name: `${names[name] ?? name}${of.length > 0 ? ': ' : ''}${of.join(' ')}`, ...pictures[name](...of) });
  figure.insertAdjacentHTML('afterbegin', drawn.html);
  if (drawn.points.length === 0) continue;
  const svg = figure.firstChild, mark = svg.querySelector('.mark');
  const show = (nearest, { clientX, clientY }) => {
    tip.hidden = !nearest;
    mark.setAttribute('visibility', nearest ? 'visible' : 'hidden');
    if (!nearest) return;
    mark.setAttribute('transform', `translate(${nearest.at.join(' ')})`);
    tip.textContent = nearest.text;
    tip.style.left = `${Math.max(8, Math.min(clientX + 14, document.documentElement.clientWidth - tip.offsetWidth - 8)) + scrollX}px`;
    tip.style.top = `${clientY + 18 + scrollY}px`;
  };
  const look = (event) => {
    const box = svg.getBoundingClientRect(), scale = box.width / drawn.width;
    const away = ({ at: [x, y] }) => Math.hypot(box.x + scale * x - event.clientX, box.y + scale * y - event.clientY);
    const nearest = drawn.points.reduce((best, point) => (away(point) < away(best) ? point : best));
    show(away(nearest) < reach && nearest, event);
  };
  svg.addEventListener('pointermove', look);
  svg.addEventListener('pointerdown', look);
  svg.addEventListener('pointerleave', (event) => event.pointerType === 'mouse' && show(null, event));
}

// What to choose.
const form = find('form.choose'), choose = chooserOf(tables.step_budget, tables.stability);
const rates = [1e3, 2e3, 5e3, 1e4, 2e4, 5e4], stiffnesses = Array.from({ length: 19 }, (_, i) => Number((10 ** (3 + i / 2)).toPrecision(2)));
const notes = { 32000: " (the paper's)", 1e10: ' (like steel)' };
function fill(field, texts, selected) {
  texts.forEach((text, i) => form.elements[field].add(new Option(text, i, i === selected, i === selected)));
}
fill('part', parts.map(({ target, name }) => `${name} (${target})`), 2);
fill('rate', rates.map((rate) => `${rate / 1e3} kHz`), 3);
fill('stiffness', stiffnesses.map((k) => k.toExponential().replace('e+', 'e') + (notes[k] ?? '')), 3);
function answer() {
  const [part, rate, law, stiffness] = [['part', parts], ['rate', rates], ['stop', ['hunt-crossley', 'hooke-newton']], ['stiffness', stiffnesses]].map(([field, values]) => values[form.elements[field].value]);
  const { none, types, worst, time, share, error, memory } = choose(part, law, rate, stiffness);
  const rows = none ? [['Answer', none]] : [...types.map((type, i) => [['Law', 'Stepper', 'Format'][i], type]),
    ['Largest step seen', `${worst} instructions, about ${short(1e6 * time)} µs: ${short(100 * share, 2)} % of the period`], ['Restitution', `right within ${error}`], ...(memory ? [['Memory', memory]] : [])];
  form.querySelector('dl').innerHTML = rows.map(([term, text]) => `<dt>${term}</dt><dd>${text.replace(/</g, '&lt;')}</dd>`).join('');
  form.querySelector('code').textContent = none ? '' : `impact::Absorber<Rig, impact::${types[0]}, impact::${types[1]}, impact::Sine, impact::${types[2]}>`;
}
form.addEventListener('change', answer);
form.addEventListener('submit', (event) => event.preventDefault());
answer();
