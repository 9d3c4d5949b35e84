// The explorer in a headless Chromium, used as a person would: sliders by the keyboard, typed numbers, clicked buttons.
// Its results are compared with impact-sim, run by the command that the page shows: page_test.mjs CHROMIUM
// EXPLORER.html IMPACT_SIM
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Browser } from './browser.mjs';
import { check, finish } from './check.mjs';

const [chromium, file, toolFile] = process.argv.slice(2);
const url = pathToFileURL(file).href, tool = resolve(toolFile);

const runsAreDone = "explorer.due.size === 0 && Object.values(explorer.runs).every((run) => !run.isReady || run.isDone) && explorer.hasSpoken";
const text = (page, id) => page.value(`document.getElementById('${id}').textContent`);
const settled = (page) => page.until(runsAreDone);

// Runs the tool with the command that the page shows, in a folder with the sample files that the command names.
const folder = mkdtempSync(join(tmpdir(), 'page-'));
const toolAt = (command) => spawnSync(tool, command.split(' ').slice(1), { cwd: folder, encoding: 'utf8', maxBuffer: 1 << 28 });
async function keepFiles(page, command) {
  for (const [, name] of command.matchAll(/-file=(\S+)/g))
    writeFileSync(join(folder, name), await page.value(`explorer.kernel.files.text('${name}')`));
}
async function checkAgainstTool(page, letter, what) {
  await settled(page);
  const csv = await page.value(`explorer.kernel.csv(explorer.runs.${letter}.slot)`);
  const command = await text(page, `command-${letter}`);
  await keepFiles(page, command);
  const { status, stdout } = toolAt(command);
  check(status === 0 && csv.length > 1000 && csv === stdout, `${what}: the ${csv.split('\n').length} lines of ${command}`);
}

// The number of pixels of a canvas in each of the page's colours, and the picture itself.
const inkOf = (page, id) => page.value(`(() => {
  const canvas = document.querySelector('#${id} canvas'), { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const pen = document.createElement('canvas').getContext('2d'), style = getComputedStyle(document.documentElement), ink = {};
  const count = (name) => {
    pen.fillStyle = style.getPropertyValue('--' + name);
    pen.fillRect(0, 0, 1, 1);
    const [red, green, blue] = pen.getImageData(0, 0, 1, 1).data, isNear = (value, other) => Math.abs(value - other) < 12;
    let pixels = 0;
    for (let i = 0; i < data.length; i += 4) if (isNear(data[i], red) && isNear(data[i + 1], green) && isNear(data[i + 2], blue)) ++pixels;
    return pixels;
  };
  for (const name of ['a', 'b', 'lost', 'rubbed', 'moving']) ink[name] = count(name);
  return { ink, picture: canvas.toDataURL() };
})()`);
// `wanted` has the least number of pixels of each colour, by plot.
async function checkDrawn(page, wanted, what) {
  for (const [id, colours] of Object.entries(wanted)) {
    const { ink } = await inkOf(page, id);
    for (const [name, least] of Object.entries(colours)) check(ink[name] >= least, `${what}: ${id} has ${ink[name]} pixels of the colour ${name}`);
  }
}

async function typeInto(page, id, value) {
  await page.click(`#${id}`);
  await page.value(`document.getElementById('${id}').select()`);
  await page.call('Input.insertText', { text: value });
  await page.press('Enter', 'Enter', '\r');
  await page.until('explorer.due.size === 0');
}

async function sliders(page) {
  await settled(page);
  await checkAgainstTool(page, 'a', 'as opened');
  await checkDrawn(page, { 'plot-displacement': { a: 300 }, 'plot-loop': { a: 100 }, 'plot-restitution': { a: 100 }, 'plot-energy-a': { lost: 3000, moving: 300 } }, 'as opened');
  for (const [name, key] of [['drive-pulsation', 'ArrowRight'], ['contact-stiffness', 'ArrowLeft'], ['clearance', 'ArrowRight'], ['main-damping', 'ArrowRight'], ['step', 'ArrowRight']]) {
    const before = { number: await page.value(`document.getElementById('value-${name}-number').value`), ...(await inkOf(page, 'plot-displacement')) };
    await page.value(`document.getElementById('value-${name}').closest('details').open = true; document.getElementById('value-${name}').focus()`);
    for (let i = 0; i < 8; ++i) await page.press(key);
    await settled(page);
    const after = { number: await page.value(`document.getElementById('value-${name}-number').value`), ...(await inkOf(page, 'plot-displacement')) };
    check(before.number !== after.number && before.picture !== after.picture, `${key} on ${name}: ${before.number} to ${after.number}, and another picture`);
    await checkAgainstTool(page, 'a', `after ${name}`);
  }
}

async function choices(page) {
  for (const preset of ['paper', 'stiff', 'coarse', 'laws', 'fixed']) {
    await page.click(`[data-preset="${preset}"]`);
    await checkAgainstTool(page, 'a', `preset ${preset}`);
    if (await page.value('explorer.compares')) {
      await checkAgainstTool(page, 'b', `preset ${preset}, B`);
      await checkDrawn(page, { 'plot-displacement': { b: 50 }, 'plot-energy-b': { moving: 300 } }, `preset ${preset}, B`);
    }
  }
  await page.click('[data-preset="paper"]');
  for (const [name, choice] of [['numeric', 'fixed32'], ['numeric', 'float32'], ['law', 'hooke-newton'], ['newmark', 'fox-goodwin'], ['law', 'hertz'], ['drive', 'none'], ['newmark', 'energy']]) {
    await page.value(`(() => { const it = document.getElementById('value-${name}'); it.value = '${choice}'; it.dispatchEvent(new Event('change')); })()`);
    if (choice === 'none') await typeInto(page, 'value-v2-number', '0.8');
    await checkAgainstTool(page, 'a', `${name} ${choice}`);
  }
}

// The heading of the restitutions, from the impacts that the plot shows.
async function restitutions(page) {
  const heading = () => text(page, 'found-restitution');
  const own = (letter) => page.value(`(() => {
    const { kernel, slot } = explorer.runs.${letter}, { data, count } = kernel.impacts(slot);
    return Array.from({ length: count }, (_, i) => [data[3 * i + 2], kernel.lawRestitution(slot, data[3 * i + 1])]);
  })()`);
  const one = String.raw`50 % within (\d[\d.e-]*) of the line(?:, (\d+) of (\d+) above 1)?`;
  const checkOne = (words, impacts, what) => {
    const [distance, above = 0, count = impacts.length] = (words ?? []).slice(1).map((number) => number && Number(number));
    // The distance has two digits. At least half of the impacts are within it, and at most half are within less.
    const within = (limit) => impacts.filter(([restitution, law]) => Math.abs(restitution - law) <= limit).length;
    check(words !== null && 2 * within(1.051 * distance) >= impacts.length && 2 * within(0.949 * distance) <= impacts.length + 1 &&
      count === impacts.length && above === impacts.filter(([restitution]) => restitution > 1.001).length, `${what}: ${words?.[0]}`);
  };
  await page.click('[data-preset="paper"]');
  await settled(page);
  checkOne((await heading()).match(new RegExp(`^${one}$`)), await own('a'), 'restitutions of the paper');
  // With a stiff stop the kernel keeps the law's restitution, and the paper's scheme creates energy.
  await page.click('[data-preset="stiff"]');
  await settled(page);
  const [a, b] = (await heading()).split('; ');
  const kernels = a.match(new RegExp(`^A: ${one}$`)), papers = b.match(new RegExp(`^B: ${one}$`));
  checkOne(kernels, await own('a'), 'restitutions of a stiff stop');
  checkOne(papers, await own('b'), "restitutions by the paper's scheme");
  check(Number(kernels[1]) < 2e-3 && kernels[2] === undefined && Number(papers[2]) > 100, 'only the scheme creates energy');
  await page.click('[data-preset="paper"]');
  await page.value("explorer.change('drive', 'none')");
  await settled(page);
  check((await heading()) === '0 complete impacts', `without a drive: ${await heading()}`);
  await page.click('[data-preset="paper"]');
}

async function refusals(page) {
  await page.click('[data-preset="paper"]');
  for (const [name, value] of [['step', '0.05'], ['main-mass', '0'], ['main-mass', '1e300'], ['restitution', '2'], ['clearance', '-1'], ['drive-pulsation', '1e9']]) {
    if (name === 'restitution') await page.value(`(() => { const it = document.getElementById('value-damping-by'); it.value = 'restitution'; it.dispatchEvent(new Event('change')); })()`);
    await page.until('explorer.due.size === 0');
    await typeInto(page, `value-${name}-number`, value);
    // On a busy machine the message appears some frames later.
    await page.until(`document.querySelector('#value-${name}-refusal button') !== null`, 20);
    const words = await text(page, `value-${name}-refusal`);
    check(/is refused\. Allowed: \S+/.test(words), `${name} ${value}: ${words}`);
    await page.click(`#value-${name}-refusal button`);
    await page.until('explorer.due.size === 0');
    check((await text(page, `value-${name}-refusal`)) === '', `${name}: the button sets ${await page.value(`document.getElementById('value-${name}-number').value`)}`);
    // A value within its own range may still require a change of another value.
    for (let i = 0; i < 4 && !(await page.value('explorer.runs.a.isReady')); ++i) {
      await page.click('.refusal button');
      await page.until('explorer.due.size === 0');
    }
    check(await page.value('explorer.runs.a.isReady'), `${name}: buttons lead to a run`);
    await page.click('[data-preset="paper"]');
  }
  // If the kernel rejects a step, the page shows the tool's message.
  await typeInto(page, 'value-step-number', '0.05');
  const { status, stderr } = toolAt('impact-sim --step=0.05 --duration=2');
  const allowed = stderr.match(/allowed: (.*)/)?.[1];
  const words = await text(page, 'value-step-refusal');
  check(status === 2 && allowed !== undefined && words.includes(allowed), `the tool says the same: ${stderr.trim()}`);
}

// Weight, friction, and samples of a force, of a base's displacement and of its acceleration.
async function parts(page) {
  await page.click('[data-preset="upright"]');
  await checkAgainstTool(page, 'a', 'upright');
  await checkAgainstTool(page, 'b', 'upright, friction');
  await checkDrawn(page, { 'plot-displacement': { a: 300, b: 300 }, 'plot-energy-b': { rubbed: 1000, lost: 1000 } }, 'upright');
  await page.click('[data-preset="paper"]');
  for (const [name, key] of [['gravity', 'ArrowLeft'], ['ball-friction', 'ArrowRight']]) {
    await page.value(`document.getElementById('value-${name}').closest('details').open = true; document.getElementById('value-${name}').focus()`);
    for (let i = 0; i < 10; ++i) await page.press(key);
    await settled(page);
    check((await text(page, 'command-a')).includes(`--${name}=`), `${key} on ${name}`);
    await checkAgainstTool(page, 'a', `after ${name}`);
  }
  await typeInto(page, 'value-ball-friction-number', '0.5');
  await settled(page);
  // The ledger balances to a thousandth of the dissipated energy.
  const { energyError, dissipated, rubbed } = await page.value('explorer.runs.a.totals()');
  check(rubbed > 0 && energyError < 1e-3 * (dissipated + rubbed), `the ledger is open by ${energyError} J, ${rubbed} J lost to friction`);
  await checkDrawn(page, { 'plot-energy-a': { rubbed: 1000 } }, 'friction');

  const choose = (name, choice) => page.value(`(() => { const it = document.getElementById('value-${name}'); it.value = '${choice}'; it.dispatchEvent(new Event('change')); })()`);
  const paste = async (name, column) => {
    await page.value(`(() => { const it = document.getElementById('value-${name}-pasted'); it.value = ${JSON.stringify(column)}; it.dispatchEvent(new Event('change')); })()`);
    await page.until('explorer.due.size === 0');
  };
  const column = (scale, count = 3000) => Array.from({ length: count }, (_, n) => (scale * Math.sin(0.004 * n)).toFixed(8)).join('\n');
  for (const numeric of ['float64', 'fixed32']) {
    await page.click('[data-preset="paper"]');
    await choose('numeric', numeric);
    await choose('drive', 'base-file');
    await page.until("document.getElementById('value-base-file-refusal').textContent.includes('no file')");
    await paste('base-file', column(0.01));
    await checkAgainstTool(page, 'a', 'a base that is displaced');
    await choose('drive', 'drive-file');
    const file = join(folder, 'my force.txt');
    writeFileSync(file, column(8).replaceAll('\n', '\r\n'));
    const { root } = await page.call('DOM.getDocument'), { nodeId } = await page.call('DOM.querySelector', { nodeId: root.nodeId, selector: '#value-drive-file' });
    await page.call('DOM.setFileInputFiles', { nodeId, files: [file] });
    await page.until("explorer.a['drive-file'] === 'my_force.txt'");
    await checkAgainstTool(page, 'a', 'a file of a force');
    await choose('base', 'samples');
    await paste('base-acceleration-file', column(6));
    await checkAgainstTool(page, 'a', 'and a base that accelerates');
    check((await text(page, 'files-a')).includes('my_force.txt'), 'the page saves what its command names');
  }
  await settled(page);
  const second = await Browser.open(chromium, await text(page, 'link'));
  await second.until('!!window.explorer');
  await checkAgainstTool(second, 'a', 'the link with its samples');
  await second.close();

  const refused = async (name, words) => {
    await page.until(`document.querySelector('#value-${name}-refusal').textContent.includes(${JSON.stringify(words)})`, 20);
    check(true, `${name}: ${await text(page, `value-${name}-refusal`)}`);
  };
  await paste('base-acceleration-file', '1\n2\nthree\n4');
  await refused('base-acceleration-file', "line 3: 'three'");
  await choose('drive', 'none');
  await paste('base-acceleration-file', column(6, 500));
  await page.value("explorer.change('duration', 1)");
  await refused('base-acceleration-file', 'a line for each of the 10000 steps');
  await page.click('#value-base-acceleration-file-refusal button');
  await page.until('explorer.due.size === 0 && explorer.runs.a.isReady');
  await checkAgainstTool(page, 'a', 'as long as the file');
  await page.click('[data-preset="upright"]');
  await typeInto(page, 'value-ball-friction-number', '1e9');
  await refused('ball-friction', 'Allowed: 0 to');
  await page.click('#value-ball-friction-refusal button');
  await choose('newmark', 'average');
  await refused('newmark', 'the classical schemes do not support --base-acceleration-file');
  await page.click('#value-newmark-refusal button');
  await page.until('explorer.due.size === 0 && explorer.runs.a.isReady');
}

// Except for the command in its comment, this is the header that the tool writes.
async function rigs(page) {
  const file = join(folder, 'rig.hpp'), code = (rig) => rig.replace(/^\/\/ {5}impact-sim.*$/m, '');
  for (const preset of ['paper', 'stiff', 'laws', 'upright', 'fixed']) {
    await page.click(`[data-preset="${preset}"]`);
    await settled(page);
    for (const letter of await page.value("explorer.compares ? ['a', 'b'] : ['a']")) {
      await keepFiles(page, await text(page, `command-${letter}`));
      const { status, stderr } = toolAt(`${await text(page, `command-${letter}`)} --rig ${file}`), shown = await text(page, `rig-${letter}`);
      check(status === 0 && shown.includes('using Absorber') && code(shown) === code(readFileSync(file, 'utf8')), `preset ${preset}: the rig of ${letter} ${status === 0 ? '' : stderr}`);
    }
  }
}

async function sweep(page) {
  await page.click('[data-preset="paper"]');
  await typeInto(page, 'value-duration-number', '0.5');
  await page.until('!explorer.sweepIsDue && explorer.sweep.isDone', 120);
  await checkDrawn(page, { 'plot-sweep': { a: 100 } }, 'sweep');
  const points = await page.value(`(() => { const { own } = explorer.sweep.curves[0]; return Array.from({ length: own.count }, (_, i) => [own.data[2 * i], own.data[2 * i + 1]]); })()`);
  const scenes = join(folder, 'scenes.csv');
  writeFileSync(scenes, `duration,step,drive-pulsation\n${points.map(([pulsation]) => `0.5,1e-4,${pulsation}`).join('\n')}\n`);
  const rows = toolAt(`impact-sim --sweep ${scenes}`).stdout.trim().split('\n').map((line) => line.split(','));
  const at = rows[0].indexOf('max_x1'), byScene = rows.slice(1).sort((a, b) => a[0] - b[0]);
  check(points.length === 65 && byScene.length === 65 && byScene.every((row, i) => Number(row[at]) === points[i][1]), `sweep: ${points.length} points are those of impact-sim --sweep`);
}

async function playing(page) {
  await page.click('[data-preset="stiff"]');
  await settled(page);
  await page.until('!explorer.sweepIsDue && explorer.sweep.isDone', 240);
  await page.value("document.activeElement.blur(); explorer.play(false); explorer.time = 0; undefined");
  const position = () => page.value("document.querySelector('#machine-a [data-part=moving]').getAttribute('transform')");
  const before = await position();
  await page.press(' ', 'Space', ' ');
  await new Promise((done) => setTimeout(done, 700));
  await page.press(' ', 'Space', ' ');
  check(before !== (await position()), `space plays, the mass moves: ${before} to ${await position()}`);
  const time = await page.value('explorer.time');
  await page.press('.', 'Period', '.');
  check(Math.abs((await page.value('explorer.time')) - time) <= 1.6e-4, 'a full stop goes one step on');
  await frameTimes(page);
}

// Frame times are printed, not checked: playing, and a moving slider while all plots update. They are by the clock,
// which other programs slow down, and by the processor time of the page's thread.
async function frameTimes(page) {
  await page.call('Performance.enable', { timeDomain: 'threadTicks' });
  const used = async () => 1000 * (await page.call('Performance.getMetrics')).metrics.find(({ name }) => name === 'TaskDuration').value;
  for (const [what, change] of [['playing', ''], ['a slider in motion', "explorer.change('drive-pulsation', 40 + i / 10);"]]) {
    const before = await used();
    const { count, total, longest } = await page.value(`(async () => {
      explorer.play(true);
      explorer.frames = { count: 0, total: 0, longest: 0 };
      for (let i = 0; i < 120; ++i) { ${change} await new Promise(requestAnimationFrame); }
      return explorer.frames;
    })()`);
    console.log(`       ${count} frames, ${what}: mean ${(total / count).toFixed(2)} ms, longest ${longest.toFixed(2)} ms; ` +
      `${((await used() - before) / count).toFixed(2)} ms of processor time each`);
  }
}

async function link(page) {
  await page.click('[data-preset="fixed"]');
  await typeInto(page, 'value-ball-mass-number', '0.21');
  await page.value("explorer.play(false); explorer.goTo(0.4321); undefined");
  await settled(page);
  const [address, command, other] = [await text(page, 'link'), await text(page, 'command-a'), await text(page, 'command-b')];
  const second = await Browser.open(chromium, address);
  await second.until('!!window.explorer');
  await settled(second);
  check((await text(second, 'command-a')) === command && (await text(second, 'command-b')) === other && command.includes('0.21'), `the link brings back ${other}`);
  check(await second.value('explorer.time === 0.4321 && !explorer.isPlaying'), 'and the instant at which the page stood still');
  await second.close();
}

// For a reader who prefers reduced motion the page starts without motion, but may be played.
async function stillness() {
  const page = await Browser.open(chromium, url, { still: true });
  await page.until('!!window.explorer');
  await settled(page);
  check((await text(page, 'play')) === 'Play' && (await page.value('explorer.time')) === 0, 'with reduced motion the page stands still');
  await page.click('#play');
  await page.until('explorer.time > 0');
  check((await text(page, 'play')) === 'Pause', 'and plays when asked');
  await page.close();
}

async function selfTest() {
  const page = await Browser.open(chromium, `${url}#selftest`);
  await page.until("/selftest: \\d+ of \\d+/.test(document.body?.innerText)");
  const words = await page.value("document.body.innerText.split('\\n')[0]");
  check(words === 'selftest: 42 of 42', words);  // part 3 in configurations.hpp, of three formats
  await page.close();
}

const page = await Browser.open(chromium, url, { height: 1600 });
try {
  await page.until('!!window.explorer');
  for (const part of [sliders, choices, restitutions, refusals, parts, rigs, sweep, playing, link]) await part(page);
  check(page.complaints.length === 0, `the page has no complaint ${page.complaints}`);
  await stillness();
  await selfTest();
} finally {
  await page.close();
  rmSync(folder, { recursive: true });
}
finish();
