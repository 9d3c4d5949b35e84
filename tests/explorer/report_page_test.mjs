// The report's page in a headless Chromium, with tables that this test makes, for what only a browser shows.
// report_page_test.mjs CHROMIUM CMAKE FOLDER_OF_HOST_REF
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Browser } from './browser.mjs';
import { check, finish } from './check.mjs';

const [chromium, cmake, source] = process.argv.slice(2);

const folder = mkdtempSync(join(tmpdir(), 'report-')), tables = [];
function table(name, header, rows) {
  tables.push(join(folder, `${name}.csv`));
  writeFileSync(tables.at(-1), `${header}\n${rows.map((row) => `${row.join()}\n`).join('')}`);
}
const laws = ['hooke-newton', 'hertz', 'hunt-crossley'], steps = [1e-2, 1e-3, 1e-4, 1e-5], formats = ['float64', 'float32', 'float32-plain', 'fixed32'];
const each = (...lists) => lists.reduce((rows, list) => rows.flatMap((row) => list.map((item) => [...row, item])), [[]]);
const methods = ['moment', 'moment-4', 'energy', 'impulsive', 'average', 'linear', 'fox-goodwin', 'central', 'textbook-newmark', 'textbook-rk4', 'tuned-rk4', 'textbook-newmark-sqrt', 'textbook-rk4-sqrt', 'textbook-rk4-lookup'];
const orderOf = (method) => (/^(moment|.*rk4)/.test(method) ? 4 : 2), errorOf = (method, step) => (10 * step) ** orderOf(method);
table('accuracy', 'law,newmark,numeric,step_s,error_m,method_error_m,rounding_error_m,host_ns_per_step,contact_share', each(laws, methods, formats, steps)
  .map(([law, method, numeric, step]) => [law, method, numeric, step, errorOf(method, step), errorOf(method, step), numeric === 'float64' ? 0 : 1e-9, 30 + orderOf(method), 0.2]));
table('error_vs_time', 'target,law,method,numeric,step_s,error_m,instructions_per_simulated_second,frontier', each(['cortex-m3', 'cortex-m4f'], laws, methods, ['float32', 'float32-plain', 'fixed32'], steps)
  .map(([target, law, method, numeric, step]) => [target, law, method, numeric, step, errorOf(method, step), (/rk4|newmark/.test(method) ? 500 : 100) / step, method === 'moment' && numeric === 'fixed32' ? 1 : 0]));
table('step_budget', 'target,law,newmark,numeric,drive,phase,instructions_mean,instructions_max,budget,flash_bytes,ram_bytes,stack_bytes,cycles_max', each(['cortex-m0', 'cortex-m0plus', 'cortex-m3', 'cortex-m4f', 'cortex-m7f', 'rv32imac', 'rp2350-riscv'],
  laws, ['moment', 'impulsive'], formats.slice(1), ['free', 'contact']).map(([target, law, newmark, numeric, phase]) => [target, law, newmark, numeric, 'sine', phase, 50, phase === 'free' ? 50 : numeric === 'fixed32' ? 283 : 500, 500, 3280, 72, 144, '']));
table('stability', 'law,newmark,numeric,step_s,contact_stiffness,restitution_min,restitution_max,restitution_exact,energy_gain_max,accepted,machine_rule',
  each(laws, ['auto', 'moment', 'impulsive', 'average', 'textbook-rk4'], ['float64', 'float32', 'fixed32'], Array.from({ length: 13 }, (_, i) => 10 ** ((i - 20) / 4)), Array.from({ length: 19 }, (_, i) => 10 ** (3 + i / 2))).map(([law, newmark, numeric, step, stiffness]) => {
    const error = newmark === 'impulsive' ? 1e-6 : (step ** 2 * stiffness) / 100, isStiff = step ** 2 * stiffness > 1;
    return [law, newmark, numeric, step, stiffness, 0.68 - error, 0.68, 0.68, newmark === 'average' && isStiff ? 0.1 : 0, newmark === 'moment' && isStiff ? 0 : 1, isStiff ? 'impulsive' : 'moment'];
  }));
table('stiff', 'contact_stiffness,step_s,method,numeric,contact_steps,error_m,ns_per_simulated_second', each([3e4, 1e10, 1e12], [1e-3, 1e-4, 1e-5], [['auto', 'float64', ''], ['auto', 'fixed32', ''], ['event-rk4', 'float64', 8], ['event-rk4', 'float64', 32]])
  .map(([stiffness, step, method]) => [stiffness, step, ...method, 1e-6 / (method[2] || 4), (method[2] || 4) * 10 / step]));
table('stiff_time', 'target,method,numeric,step_s,contact_steps,error_m,instructions_per_simulated_second', each(['cortex-m3', 'cortex-m4f'], [['impulsive', 'fixed32', 0], ['moment-n', 'float32', 0], ['event-rk4', 'float32-plain', 8]], steps)
  .map(([target, method, step]) => [target, ...method.slice(0, 2), step, method[2], errorOf('moment', step), (method[2] ? 500 : 100) / step]));
table('coupled', 'law,newmark,numeric,scenes,faults,energy_gain_max', each(laws, ['auto', 'moment', 'moment-4', 'moment-8', 'energy', 'impulsive', 'average'], formats).map(([law, newmark, numeric]) => [law, newmark, numeric, 150, 0, newmark === 'average' ? 'inf' : 1e-5]));
table('restitution', 'damping,stated,restitution_min,restitution_max,restitution_exact', each(['exact', 'hu-guo', 'flores', 'hunt-crossley', 'herbert-mcwhannell', 'lankarani-nikravesh', 'lee-wang'], [0.1, 0.5, 1]).map(([damping, stated]) => [damping, stated, stated, stated, stated]));
table('attenuation', 'rig,ball_friction_N,pulsation,swing_without_m,swing_m,attenuation', each(['level', 'upright'], [0, 0.5], [20, 40, 60]).map((row) => [...row, 0.02, 0.01, 0.5]));
table('parts_accuracy', 'part,newmark,numeric,contact_stiffness,horizon_s,step_s,error_m,order,ledger_open_J', each(['weight', 'all'], ['moment'], formats, [1e-3, 5e-4, 2.5e-4, 1.25e-4, 6.25e-5]).map(([part, newmark, numeric, step]) => [part, newmark, numeric, 32600, 1, step, step ** 4, '', 1e-9]));
table('figures', 'figure,law,quantity,value', [...laws.flatMap((law, i) => [['peak_m', 0.017], ['peak_reference_m', 0.02], ['peak_without_absorber_m', 0.0376], ['difference_from_reference_in_1_s_m', 1e-9]].map((row) => [[2, 4, 6][i], law, ...row])),
  ...laws.flatMap((law) => [[7, law, 'peak_m', 0.017], [9, law, 'attenuation', 0.5], [10, law, 'dissipated_J', 0.5], [8, law, 'peak_reference_at_restitution_0.4_m', 0.01], [8, law, 'peak_reference_at_restitution_1_m', 0.02]])]);
const curves = ['without-absorber', ...laws].flatMap((run) => ['x1', 'x1 reference', 'attenuation', 'dissipated', 'dissipated reference'].map((what) => `${run} ${what}`));
table('paper_traces', `t,${curves}`, [0, 1, 2, 3, 4, 5].map((t) => [t, ...curves.map((_, i) => i * Math.sin(t))]));
table('paper_restitutions', `restitution,${laws.flatMap((law) => [law, `${law} reference`])}`, [0.4, 0.7, 1].map((e) => [e, 10, 11, 12, 13, 14, 15]));

const facts = join(folder, 'facts.json'), file = join(folder, 'index.html'), page = `${source}/report/page`;
writeFileSync(facts, '{"paper_machine": "on a made-up machine", "has_explorer": true}');
const modules = [`${source}/explorer/numbers.mjs`, ...['facts', 'chart', 'view'].map((name) => `${page}/${name}.mjs`)];
const made = spawnSync(cmake, ['-D', `FOLDER=${page}`, '-D', `MODULES=${modules.join(';')}`, '-D', `TABLES=${tables.join(';')}`, '-D', `FILES=parts=${page}/parts.json;facts=${facts}`, '-D', `OUTPUT=${file}`, '-P', `${source}/page.cmake`], { encoding: 'utf8' });
check(made.status === 0, `the page is put together ${made.stderr}`);

// Pairs of texts that overlap and so are unreadable: [text, text]..., among the parts of an element.
const overlaps = (selector, parts) => `[...document.querySelectorAll('${selector}')].flatMap((whole) => {
  const boxes = [...whole.querySelectorAll('${parts}')].map((part) => ({ text: part.textContent, box: part.getBoundingClientRect() })).filter(({ box }) => box.width > 0);
  return boxes.flatMap((a, i) => boxes.slice(i + 1).filter((b) => a.box.left < b.box.right - 1 && b.box.left < a.box.right - 1 && a.box.top < b.box.bottom - 1 && b.box.top < a.box.bottom - 1).map((b) => [a.text, b.text]));
})`;

async function shown(browser, width) {
  check((await browser.value('document.documentElement.scrollWidth - document.documentElement.clientWidth')) <= 0, `${width} pixels: nothing is wider than the page`);
  const charts = await browser.value("[...document.querySelectorAll('[data-chart]')].map((figure) => [figure.dataset.chart, figure.querySelectorAll('svg.chart .line, svg.chart .cells, svg.chart [transform^=translate]').length])");
  const bare = charts.filter(([, drawn]) => drawn === 0).map(([name]) => name);
  check(charts.length === 66 && bare.length === 0, `${charts.length} pictures, without a drawing: ${bare}`);
  check(!/NaN|undefined/.test(await browser.value("[...document.querySelectorAll('svg')].map((svg) => svg.outerHTML).join()")), 'no picture has a number that is none');
  await browser.value("document.querySelectorAll('details').forEach((details) => { details.open = true; }); undefined");
  for (const every of [false, true]) {
    await browser.value(`document.getElementById('all-series').checked = ${every}; undefined`);
    for (const [selector, parts] of [['svg.chart', 'text'], ['.legend', 'span']]) {
      const found = await browser.value(overlaps(selector, parts));
      check(found.length === 0, `${width} pixels: texts of ${selector} that lie on each other: ${JSON.stringify(found)}`);
    }
    const beyond = await browser.value("[...document.querySelectorAll('svg.chart')].flatMap((svg) => { const whole = svg.getBoundingClientRect(); return [...svg.querySelectorAll('text')].filter((text) => { const box = text.getBoundingClientRect(); return box.width > 0 && (box.left < whole.left - 1 || box.right > whole.right + 1); }).map((text) => text.textContent); })");
    check(beyond.length === 0, `${width} pixels: texts beyond their picture: ${beyond}`);
  }
  await browser.value("document.querySelectorAll('details').forEach((details) => { details.open = false; }); document.getElementById('all-series').checked = false; undefined");
}

async function said(browser) {
  const text = await browser.value('document.body.innerText');
  check(/5× *\n?fewer instructions than the cheapest baseline \(textbook-rk4\)/.test(text.replace(/\s+/g, ' ')), 'the first number');
  check(text.includes('on a made-up machine') && !/@\w+@|NaN|undefined|\*\*/.test(text), 'no place is left empty');
  check((await browser.value("document.querySelectorAll('figcaption strong').length")) >= 1 && text.includes('It does not hold here: largest 17 mm against 37.6 mm'), 'a claim that does not hold is said');
  const lost = await browser.value("[...document.querySelectorAll('#advantage-table td strong')].length"), sentence = await browser.value("document.getElementById('advantage').innerHTML");
  check(lost === (sentence.match(/ at 1e-/g) ?? []).length && /^(No baseline reaches|<strong>A baseline costs less)/.test(sentence), `${lost} times a baseline costs less: ${sentence}`);
  const rows = await browser.value("Object.fromEntries([...document.querySelectorAll('table')].map((table) => [table.parentElement.parentElement.parentElement.id, table.tBodies[0].rows.length]))");
  check(JSON.stringify(rows) === JSON.stringify({ 'advantage-table': 82, 'coupled-table': 84, 'stability-table': 45, 'parts-table': 8, 'budget-table': 36, 'choice-table': 72 }), `rows of tables: ${JSON.stringify(rows)}`);
}

async function form(browser) {
  const answer = () => browser.value("[document.querySelector('form dl').textContent, document.querySelector('form code').textContent]");
  const choose = (field, index) => browser.value(`(() => { const field = document.querySelector('form.choose').elements['${field}']; field.value = '${index}'; field.dispatchEvent(new Event('change', { bubbles: true })); })()`);
  const first = await answer();
  // 10 kHz on the RP2040 at the paper's stop: 283 instructions of 1.4 cycles at 125 MHz.
  check(first[1] === 'impact::Absorber<Rig, impact::HuntCrossley, impact::Moment, impact::Sine, impact::Fixed32>' && first[0].includes('283 instructions, about 3.17 µs: 3.2 % of the period') && first[0].includes('3280 bytes of flash'), `what to choose: ${first}`);
  await choose('stiffness', 14);
  check((await answer())[1].includes('impact::Impulsive'), 'a stop like steel');
  await choose('stop', 1);
  check((await answer())[1].includes('impact::HookeNewton'), 'a linear stop');
  await choose('stop', 0);
  await choose('part', 0);
  await choose('rate', 5);
  check(/283 instructions, about 8.84 µs: 44 %/.test((await answer())[0]), 'a slower part at 50 kHz');
}

async function sorting(browser) {
  await browser.value("document.querySelector('#advantage-table details').open = true; undefined");
  const column = () => browser.value("[...document.querySelectorAll('#advantage-table tbody tr')].map((row) => Number(row.cells[2].textContent))");
  for (const direction of [1, -1]) {
    await browser.click('#advantage-table th:nth-child(3) button');
    const errors = await column();
    check(errors.length === 82 && errors.every((error, i) => i === 0 || direction * (error - errors[i - 1]) >= 0), `a table is sorted ${direction > 0 ? 'up' : 'down'}`);
  }
}

async function tip(browser) {
  const { x, y } = await browser.value(`(() => { const marks = document.querySelectorAll('.top svg.chart path[transform^=translate]'); marks[0].scrollIntoView({ block: 'center' });
    const box = marks[0].getBoundingClientRect(); return { x: box.x + box.width / 2, y: box.y + box.height / 2 }; })()`);
  await browser.call('Input.dispatchMouseEvent', { type: 'mouseMoved', x: x + 2, y: y + 2 });
  const text = await browser.value("document.getElementById('tip').hidden ? '' : document.getElementById('tip').textContent");
  check(/^[\w-]+ in [\w-]+ · step 10 ms · error .* m · .* thousand instructions per simulated second$/.test(text), `a point says what it is: ${text}`);
  await browser.call('Input.dispatchMouseEvent', { type: 'mouseMoved', x: 1, y: 1 });
  check(await browser.value("document.getElementById('tip').hidden"), 'and no longer');
}

try {
  for (const [width, dark] of [[1280, false], [390, true]]) {
    const browser = await Browser.open(chromium, pathToFileURL(file).href, { width, dark, mobile: width < 500 });
    await browser.until("!!document.querySelector('form code')?.textContent", 30).catch((failure) => check(false, failure.message));
    await shown(browser, width);
    if (!dark) for (const part of [said, form, sorting, tip]) await part(browser);
    check(browser.complaints.length === 0, `no complaint ${browser.complaints}`);
    await browser.close();
  }
} finally {
  rmSync(folder, { recursive: true });
}
finish();
