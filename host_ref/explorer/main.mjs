// The page: its state, what happens when it changes, and the frame that computes a slice and draws.

import { Controls, element } from './controls.mjs';
import { costOf } from './cost.mjs';
import { Kernel, column, unpacked } from './kernel.mjs';
import { hashOf, stateFrom } from './link.mjs';
import { Machine } from './machine.mjs';
import { short, tableFrom } from './numbers.mjs';
import { readTheme } from './plot.mjs';
import { DisplacementPlot, EnergyPlot, LoopPlot, RestitutionPlot, SweepPlot } from './plots.mjs';
import { Run } from './run.mjs';
import { argumentsOf, commandOf, filesOf, initialScene, presets, usualDamping, valueNamed } from './scene.mjs';
import { runTrajectories, verdictOf } from './self_test.mjs';
import { Sweep } from './sweep.mjs';
import { findingsOf, numbersRow, sentenceOf } from './words.mjs';

const find = (id) => document.getElementById(id);
const slice = 6, sweepSlice = 4, drawSlice = 8;  // ms of a frame, from its start: what is drawn is painted after that
const calm = 120;  // ms without a change, before words, link and sweep follow

class Page {
  constructor(kernel, costs, parts) {
    this.initial = initialScene(kernel);
    this.kernel = kernel;
    this.costs = costs;
    this.parts = parts;
    this.runs = { a: new Run(kernel, 0), b: new Run(kernel, 1) };
    for (const [letter, run] of Object.entries(this.runs)) run.letter = letter;
    this.sweep = new Sweep(kernel, 2);
    this.machines = { a: new Machine(find('machine-a')), b: new Machine(find('machine-b')) };
    this.plots = {
      displacement: new DisplacementPlot(find('plot-displacement')),
      energyA: new EnergyPlot(find('plot-energy-a')),
      energyB: new EnergyPlot(find('plot-energy-b')),
      loop: new LoopPlot(find('plot-loop')),
      restitution: new RestitutionPlot(find('plot-restitution')),
      sweep: new SweepPlot(find('plot-sweep')),
    };
    this.frames = { count: 0, total: 0, longest: 0 };
    this.edited = 'a';
    this.nextDrawing = 0;
    this.due = new Set();  // runs that must start again
    this.time = 0;
    this.isPlaying = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.controls = new Controls(find('controls'), kernel.files, (name, value) => this.change(name, value));
    for (const { target, name } of parts) find('part').append(new Option(`${name}, ${target}`, target));
    this.#listen();
    this.restore();
    this.play(this.isPlaying);
    requestAnimationFrame((now) => this.#frame(now));
  }

  get compares() { return this.b !== null; }
  sceneOf(letter) { return letter === 'a' ? this.a : { ...this.a, ...this.b }; }
  get ready() { return Object.values(this.runs).filter((run) => run.isReady); }

  // From the address, as a link states it.
  restore() {
    const state = stateFrom(location.hash, this.initial, this.kernel.files);
    Object.assign(this, { a: state.a, b: state.b });
    if (!this.compares) this.edited = 'a';
    find('part').value = this.parts.some(({ target }) => target === state.part) ? state.part : 'cortex-m4f';
    if (state.time !== null) {
      this.play(false);
      this.time = state.time;
    }
    this.start(['a', 'b']);
  }
  preset(name) {
    const { a, b } = presets[name];
    Object.assign(this, { a: { ...this.initial, ...a }, b: b && { ...b }, edited: 'a', time: 0 });
    this.start(['a', 'b']);
  }

  change(name, value) {
    const scene = this.edited === 'a' ? this.a : this.b;
    if (value === null) delete scene[name];
    else scene[name] = value;
    if (name === 'law' && value !== null) scene['contact-damping'] = usualDamping[value];
    // As long as the file lasts, as impact-sim takes it.
    if (valueNamed(name).samples && value !== null) scene.duration = Number((this.kernel.files.lines(value) * this.sceneOf(this.edited).step).toPrecision(12)) || scene.duration;
    this.start(this.edited === 'a' ? ['a', 'b'] : ['b']);
  }
  compare(wanted) {
    this.b = wanted ? {} : null;
    this.edited = wanted ? 'b' : 'a';
    this.start(['b']);
  }

  // Starts with the next frame, even after several changes.
  start(letters) {
    for (const letter of letters) this.due.add(letter);
    this.sweepIsDue = true;
    this.speak();
    this.time = Math.min(this.time, this.a.duration);
  }
  // Texts and link follow a change after a moment without another one.
  speak() {
    this.hasSpoken = false;
    this.changedAt = performance.now();
  }
  #startDue() {
    for (const letter of this.due) {
      if (letter === 'b' && !this.compares) this.runs.b.stop();
      else this.runs[letter].start(this.sceneOf(letter));
    }
    if (this.due.size > 0) this.#showControls();
    this.due.clear();
  }

  #listen() {
    addEventListener('hashchange', () => this.restore());
    for (const button of document.querySelectorAll('[data-preset]'))
      button.addEventListener('click', () => this.preset(button.dataset.preset));
    find('compare').addEventListener('change', ({ target }) => this.compare(target.checked));
    for (const letter of ['a', 'b']) {
      find(`edit-${letter}`).addEventListener('change', () => { this.edited = letter; this.#showControls(); });
      find(`csv-${letter}`).addEventListener('click', () => this.#save(letter));
    }
    find('part').addEventListener('change', () => this.speak());
    find('play').addEventListener('click', () => this.play(!this.isPlaying));
    find('again').addEventListener('click', () => this.goTo(0));
    find('back').addEventListener('click', () => this.stepBy(-1));
    find('forward').addEventListener('click', () => this.stepBy(1));
    find('time').addEventListener('input', ({ target }) => this.goTo(target.value / target.max * this.a.duration));
    for (const id of ['sweep-least', 'sweep-most']) find(id).addEventListener('change', () => { this.sweepIsDue = true; });
    const { displacement } = this.plots;
    displacement.canvas.addEventListener('pointerdown', (event) => this.goTo(displacement.xAt(event.clientX)));
    document.addEventListener('keydown', (event) => this.#key(event));
    const redraw = () => { readTheme(); this.#showWords(); };
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
    // On paper the colours are the light ones: once they apply, draw at once.
    addEventListener('beforeprint', () => { document.documentElement.classList.add('printing'); redraw(); this.#draw(Infinity); });
    addEventListener('afterprint', () => { document.documentElement.classList.remove('printing'); redraw(); });
    for (const button of document.querySelectorAll('[data-copy]'))
      button.addEventListener('click', async () => {
        await navigator.clipboard.writeText(find(button.dataset.copy).textContent);
        button.textContent = 'Copied';
        setTimeout(() => { button.textContent = 'Copy'; }, 1500);
      });
  }
  #key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest('input, select, button, summary, a, textarea')) return;
    const action = { ' ': () => this.play(!this.isPlaying), '.': () => this.stepBy(1), ',': () => this.stepBy(-1), 'Home': () => this.goTo(0) }[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  play(wanted) {
    this.isPlaying = wanted;
    if (wanted && this.time >= this.a.duration) this.time = 0;
    find('play').textContent = wanted ? 'Pause' : 'Play';
    this.speak();
  }
  goTo(time) {
    this.time = Math.min(this.a.duration, Math.max(0, time));
    if (!this.isPlaying) this.speak();
  }
  stepBy(count) {
    this.play(false);
    const run = this.runs.a.isReady ? this.runs.a : this.runs.b, row = run.scene.step * run.every;
    this.goTo((Math.round(this.time / row) + count) * row);
  }

  #frame(now) {
    const begin = performance.now();
    const passed = Math.min(0.1, (now - (this.before ?? now)) / 1000);
    this.before = now;
    if (this.isPlaying) {
      this.time += passed * Number(find('speed').value);
      if (this.time >= this.a.duration) this.time = 0;
    }
    this.#startDue();
    let works = false;
    for (const run of Object.values(this.runs)) works = run.work(begin + slice) || works;
    if (!works) this.#afterRuns(begin);
    this.#draw(begin + drawSlice);
    const spent = performance.now() - begin, { frames } = this;
    ++frames.count;
    frames.total += spent;
    frames.longest = Math.max(frames.longest, spent);
    requestAnimationFrame((next) => this.#frame(next));
  }
  #afterRuns(begin) {
    if (begin < this.changedAt + calm) return;
    if (!this.hasSpoken) {
      history.replaceState(null, '', hashOf({ a: this.a, b: this.b, part: find('part').value, time: this.isPlaying ? null : this.time }, this.initial, this.kernel.files));
      this.#showWords();
      this.hasSpoken = true;
      return;
    }
    if (this.sweepIsDue) {
      this.sweepIsDue = false;
      this.sweep.start(this.ready.map(({ scene }) => scene), { least: Number(find('sweep-least').value) || 10, most: Number(find('sweep-most').value) || 80 });
    }
    if (!this.sweep.isDone) this.sweep.work(begin + sweepSlice);
    find('sweep-progress').value = this.sweep.progress;
  }

  // Work that does not fit before `deadline` comes first in the next frame.
  #draw(deadline) {
    const { ready, plots, time } = this;
    find('time').value = time / this.a.duration * find('time').max;
    find('clock').textContent = `${time.toFixed(4)} s`;
    if (document.activeElement === find('time')) find('time').setAttribute('aria-valuetext', `${time.toFixed(4)} s`);
    for (const letter of ['a', 'b']) {
      const run = this.runs[letter];
      if (!run.isReady) continue;
      const rows = run.rows(), totals = run.totals();
      const row = Math.min(rows.count - 1, Math.max(0, Math.round(time / (run.scene.step * run.every))));
      const largest = Math.max(...this.ready.map((each) => each.totals().largest));
      this.machines[letter].fit(run.scene, largest, totals.peakForce);
      this.machines[letter].draw(rows, row);
      find(`now-${letter}`).textContent = ['x1', 'x2'].map((name) => `${name} ${short(1e3 * rows.data[row * rows.width + column[name]])} mm`).join(', ') + `, force ${short(rows.data[row * rows.width + column.force])} N`;
    }
    if (ready.length === 0) return;
    const window = this.#window();
    const drawings = [
      () => plots.displacement.draw(ready, window, time),
      () => plots.loop.draw(ready, time),
      () => this.runs.a.isReady && plots.energyA.draw(this.runs.a, window, time),
      () => this.runs.b.isReady && plots.energyB.draw(this.runs.b, window, time),
      () => plots.restitution.draw(ready),
      () => plots.sweep.draw(this.sweep, ready),
    ];
    for (let drawn = 0; drawn === 0 || (drawn < drawings.length && performance.now() < deadline); ++drawn) {
      drawings[this.nextDrawing]();
      this.nextDrawing = (this.nextDrawing + 1) % drawings.length;
    }
  }
  // The visible part of the run: all of it, or the part around the present instant.
  #window() {
    const length = Math.min(Number(find('window').value) || Infinity, this.a.duration);
    const left = Math.min(Math.max(0, this.time - length / 2), this.a.duration - length);
    return { left, right: left + length };
  }

  #showControls() {
    const own = new Set(this.edited === 'b' ? Object.keys(this.b) : []);
    const refusals = ['a', 'b'].filter((letter) => letter === 'a' || this.compares).flatMap((letter) =>
      this.runs[letter].refusal ? [{ letter: this.compares ? `${letter.toUpperCase()}: ` : '', refusal: this.runs[letter].refusal }] : []);
    this.controls.show(this.sceneOf(this.edited), own, refusals);
    document.body.classList.toggle('compares', this.compares);
    document.body.classList.toggle('refused', this.ready.length === 0);
    find('compare').checked = this.compares;
    find('edit').hidden = !this.compares;
    find(`edit-${this.edited}`).checked = true;
    for (const letter of ['a', 'b']) {
      const run = this.runs[letter];
      find(`why-${letter}`).textContent = run.refusal ? `Refused: ${run.refusal.option} ${run.refusal.value}. Allowed: ${run.refusal.allowed}`
        : run.isReady ? (run.plan.why || `${run.plan.stepper}, as named`) + this.#dampingOf(run) : '';
    }
  }
  #dampingOf({ scene, plan }) {
    return scene.law !== 'hertz' && ['restitution', 'paper'].includes(scene['damping-by']) ? `; c1 = ${short(plan.contactDamping, 4)}` : '';
  }

  // Texts and tables, which may follow later than within a frame.
  #showWords() {
    find('numbers').tBodies[0].replaceChildren(...this.ready.map((run) => numbersRow(run)));
    const summary = this.ready.map((run) => sentenceOf(run, this.compares)).join(' ') || `No run: ${this.runs.a.refusal.option} ${this.runs.a.refusal.value} is refused.`;
    if (find('summary').textContent !== summary) find('summary').textContent = summary;  // else it would be read out again
    for (const [plot, text] of Object.entries(findingsOf(this.ready, this.compares))) find(`found-${plot}`).textContent = text;
    find('link').textContent = location.href;
    const tooLong = ['a', 'b'].flatMap((letter) => filesOf(Object.entries(this.sceneOf(letter)))).filter((name) => name && this.kernel.files.inLink(name) === null);
    find('link-note').textContent = tooLong.length ? `Too long for a link: ${[...new Set(tooLong)].join(', ')}. Save the file, and choose it again where you open the link.` : '';
    for (const [letter, run] of Object.entries(this.runs)) {
      const options = run.isReady ? argumentsOf(run.scene, this.initial, run.every, this.kernel.files) : [];
      find(`files-${letter}`).replaceChildren(...filesOf(options).map((name) => this.#fileButton(name)));
      find(`command-${letter}`).replaceChildren(...(run.isReady ? wordsOf(commandOf(options)) : []));
      find(`rig-${letter}`).textContent = run.isReady ? this.kernel.rig(run.slot, options) : '';
      const costs = run.isReady ? costOf(this.costs, this.parts.find(({ target }) => target === find('part').value), run.scene, run.plan.stepper) : [];
      find(`cost-${letter}`).replaceChildren(...costs.flatMap(([what, value]) => [element('dt', { textContent: what }), element('dd', { textContent: value })]));
    }
  }

  #save(letter) {
    if (this.runs[letter].isReady) saveFile(`impact_${letter}.csv`, this.kernel.csv(this.runs[letter].slot));
  }
  #fileButton(name) {
    const button = element('button', { type: 'button', textContent: `Save ${name}` });
    button.addEventListener('click', () => saveFile(name, this.kernel.files.text(name)));
    return button;
  }
}

// A command breaks between its options only.
const wordsOf = (command) => command.split(/(?<= )/).map((word) => element('span', { textContent: word }));
function saveFile(name, text) {
  const file = URL.createObjectURL(new Blob([text], { type: 'text/plain' }));
  element('a', { href: file, download: name }).click();
  URL.revokeObjectURL(file);
}

async function selfTest() {
  const module = find('trajectories-module').textContent;
  document.body.replaceChildren(element('p', { textContent: 'selftest: running' }));
  const { text } = await runTrajectories(await unpacked(module));
  const { passed, count } = verdictOf(text);
  document.body.replaceChildren(element('p', { textContent: `selftest: ${passed} of ${count}` }), element('pre', { textContent: text }));
}

async function open() {
  try {
    const kernel = await Kernel.load(await unpacked(find('kernel-module').textContent));
    readTheme();
    window.explorer = new Page(kernel, tableFrom(find('step-budget').textContent), JSON.parse(find('parts').textContent));
    find('loading').remove();
  } catch (failure) {
    find('loading').textContent = `This page needs a browser with WebAssembly and DecompressionStream, of 2023 or later: ${failure.message}`;
    throw failure;
  }
}
await (location.hash === '#selftest' ? selfTest() : open());
