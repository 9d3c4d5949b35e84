// The plots of the runs. Each draws again when its data have changed, and otherwise only moves its cursor.

import { column, lineColumn } from './kernel.mjs';
import { Plot, theme } from './plot.mjs';

const dashes = [[], [6, 4]];  // of run A and run B
export const marks = ['dot', 'cross'];
const bareStyle = () => ({ colour: theme.bare, thickness: 1, dash: [2, 3] });

const versionOf = (runs) => runs.map(({ version }) => version).join();

function extremes({ data, count, width }, columnIndex) {
  let least = 0, most = 0;
  for (let i = columnIndex; i < count * width; i += width) {
    if (data[i] < least) least = data[i];
    if (data[i] > most) most = data[i];
  }
  return [least, most];
}
// With some room, never empty, and round, so that the frame does not change with every picture.
function roomy(least, most) {
  const room = 0.04 * (most - least) || 1e-6, unit = 10 ** Math.floor(Math.log10(most - least + room)) / 5;
  const up = (value) => unit * Math.ceil(value / unit);
  return { bottom: least < 0 ? -up(room - least) : 0, top: up(most + room) };
}

export class DisplacementPlot extends Plot {
  constructor(figure) { super(figure, { x: { label: 't, s' }, y: { label: 'x1, mm', scale: 1e3 } }); }
  draw(runs, window, cursor) {
    const range = { ...window, ...this.#heights(runs) };
    if (this.begin(versionOf(runs), range)) {
      if (runs[0].hasBare) this.line(runs[0].bareRows(), lineColumn.t, lineColumn.x1, bareStyle());
      runs.forEach((run, i) => this.line(run.rows(), column.t, column.x1, { colour: theme[run.letter], dash: dashes[i], thickness: 1.6 }));
      this.end();
    }
    this.mark(cursor);
  }
  #heights(runs) {
    const totals = runs.map((run) => run.totals());
    if (runs[0].hasBare) totals.push(runs[0].bareExtremes());
    return roomy(Math.min(0, ...totals.map(({ leastX1 }) => leastX1)), Math.max(0, ...totals.map(({ mostX1 }) => mostX1)));
  }
}

// The energies lost to contact, dry friction and the main damper, and those in motion and springs, as areas. A line shows
// the energy that the start, the drive, the weight and the base have supplied. If it is not the sum of the areas, the step has
// created or lost energy.
export class EnergyPlot extends Plot {
  constructor(figure) { super(figure, { x: { label: 't, s' }, y: { label: 'energy, J' } }); }
  draw(run, window, cursor) {
    // A stop that is far too stiff for the step exchanges more energy than all else. The picture cuts this off.
    const rows = run.rows(), { mostSupplied, mostFound, leastDissipated } = run.totals();
    const heights = roomy(Math.max(leastDissipated, -mostSupplied), Math.max(mostSupplied, Math.min(mostFound, 2 * mostSupplied)));
    const range = { ...window, ...heights };
    if (this.begin(run.version, range)) {
      this.area(rows, column.t, null, column.dissipated, { colour: theme.lost });
      this.area(rows, column.t, column.dissipated, column.rubbed, { colour: theme.rubbed });
      this.area(rows, column.t, column.rubbed, column.lost, { colour: theme.damped });
      this.area(rows, column.t, column.lost, column.found, { colour: theme.moving });
      this.line(rows, column.t, column.supplied, { colour: theme.ink, dash: [5, 3] });
      this.end();
    }
    this.mark(cursor);
  }
}

// Each contact is a loop. The loop of the present instant, or the last one before it, is highlighted. An impulsive step has
// no force over penetration, because its impact is at an instant.
export class LoopPlot extends Plot {
  constructor(figure) {
    super(figure, { x: { label: 'penetration, mm', scale: 1e3 }, y: { label: 'contact force, N' } });
  }
  draw(runs, time) {
    const tables = runs.map((run) => run.kernel.contacts(run.slot));
    const { range, loops } = this.remember(versionOf(runs), () => {
      const deepest = Math.max(1e-9, ...tables.map((table) => extremes(table, 1)[1]));
      const forces = tables.map((table) => extremes(table, 2));
      const heights = roomy(Math.min(...forces.map(([least]) => least)), Math.max(1e-9, ...forces.map(([, most]) => most)));
      const right = roomy(0, deepest).top;
      return { range: { left: -0.08 * right, right, ...heights }, loops: tables.map((table, i) => runs[i].plan.stepper === 'impulsive' ? [] : loopsOf(table)) };
    });
    const shown = loops.map((list, i) => lastBefore(list, tables[i], time));
    if (this.begin(`${versionOf(runs)} ${shown}`, range)) {
      runs.forEach((run, i) => {
        const style = { colour: theme[run.letter], dash: dashes[i] };
        this.pen.globalAlpha = 0.25;
        for (const [from, to] of loops[i]) this.path(tables[i], from, to, 1, 2, { ...style, thickness: 1, dash: [] });
        this.pen.globalAlpha = 1;
        const [from, to] = loops[i][shown[i]] ?? [0, 0];
        this.path(tables[i], from, to, 1, 2, { ...style, thickness: 2.2 });
        if (to - from < 60) this.points({ ...tables[i], count: to }, 1, 2, { ...style, shape: marks[i] }, from);
      });
      const isImpulsive = runs.some((run) => run.plan.stepper === 'impulsive');
      if (loops.every((list) => list.length === 0)) this.note(isImpulsive ? 'an impulsive step has no loop' : 'no impact yet');
      this.end();
    }
  }
}
// A contact begins where its table has a point outside after another point.
function loopsOf({ data, count, width }) {
  const loops = [];
  let from = 0;
  for (let i = 1; i <= count; ++i) {
    const begins = i < count && data[i * width + 2] === 0 && data[(i - 1) * width + 2] === 0;
    if (i < count && !begins) continue;
    if (i - from > 1) loops.push([from, i]);
    from = i;
  }
  return loops;
}
function lastBefore(loops, { data, width }, time) {
  let found = loops.length > 0 ? 0 : -1;
  for (let i = 0; i < loops.length && data[loops[i][0] * width] <= time; ++i) found = i;
  return found;
}

// Each impact of the runs over its speed, and the law's own restitution as a line.
export class RestitutionPlot extends Plot {
  constructor(figure) { super(figure, { x: { label: 'speed of the impact, m/s' }, y: { label: 'restitution' } }); }
  draw(runs) {
    const tables = runs.map((run) => run.kernel.impacts(run.slot));
    const fastest = Math.max(0.1, ...tables.map((table) => extremes(table, 1)[1]));
    const highest = Math.max(1, ...tables.map((table) => extremes(table, 2)[1]));
    const range = { left: 0, right: roomy(0, fastest).top, bottom: 0, top: Math.min(3, roomy(0, highest).top) };
    if (this.begin(versionOf(runs), range)) {
      runs.forEach((run, i) => this.line(this.#lawOf(run, range.right), 0, 1, { colour: theme[run.letter], dash: dashes[i], thickness: 1 }));
      runs.forEach((run, i) => this.points(tables[i], 1, 2, { colour: theme[run.letter], shape: marks[i] }));
      this.end();
    }
  }
  #lawOf(run, fastest) {
    const count = 30, data = new Float64Array(2 * count);
    for (let i = 0; i < count; ++i) {
      const speed = fastest * (i + 0.5) / count;
      data[2 * i] = speed;
      data[2 * i + 1] = run.kernel.lawRestitution(run.slot, speed);
    }
    return { data, count, width: 2 };
  }
}

export class SweepPlot extends Plot {
  constructor(figure) {
    super(figure, { x: { label: 'angular frequency of the drive, rad/s' }, y: { label: 'largest |x1|, mm', scale: 1e3 } });
  }
  // `curves`: one per run, with bare and own points.
  draw(sweep, runs) {
    const { least, most } = sweep;
    const highest = Math.max(1e-6, ...sweep.curves.flatMap(({ own, bare }) => [extremes(own, 1)[1], extremes(bare, 1)[1]]));
    // Near resonance the bare mass exceeds the picture, because the runs determine its range.
    const own = Math.max(1e-6, ...sweep.curves.map((curve) => extremes(curve.own, 1)[1]));
    const range = { left: least, right: most, bottom: 0, top: roomy(0, Math.min(highest, 3 * own)).top };
    if (this.begin(sweep.version, range)) {
      sweep.curves.forEach(({ own, bare }, i) => {
        if (i === 0) this.line(bare, 0, 1, bareStyle());
        this.line(own, 0, 1, { colour: theme['ab'[i]], dash: dashes[i] });
        this.points(own, 0, 1, { colour: theme['ab'[i]], shape: marks[i] });
      });
      if (sweep.note) this.note(sweep.note);
      this.end();
    }
    this.mark(runs[0]?.scene.drive === 'sine' ? runs[0].scene['drive-pulsation'] : null);
  }
}
