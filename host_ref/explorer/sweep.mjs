// The largest displacement over a range of the drive's pulsations, each point a run of its own from the start, as
// impact-sim --sweep computes it; coarse points first, so that the curve's shape is soon there.

import { stepsBetweenLooksAtTheClock } from './run.mjs';
import { optionsOf } from './scene.mjs';

const pointCount = 65;  // a power of two and one
const mostStepsPerPoint = 60000;

export class Sweep {
  constructor(kernel, firstLine) {
    this.kernel = kernel;
    this.line = firstLine;
    this.bareLine = firstLine + 1;
    this.version = 0;
    this.curves = [];
    this.waiting = [];
    this.least = 10;
    this.most = 80;
  }

  start(scenes, { least, most }) {
    this.least = least;
    this.most = most;
    this.curves = scenes.map(() => ({ own: emptyCurve(), bare: emptyCurve() }));
    this.note = '';
    this.waiting = [];
    this.running = null;
    ++this.version;
    const scene = scenes.find(({ drive, duration, step }) => drive !== 'sine' || duration / step > mostStepsPerPoint);
    if (!scenes.length) return;
    if (scene) {
      this.note = scene.drive !== 'sine' ? 'there is no sine to sweep' : `a point takes more than ${mostStepsPerPoint} steps: use impact-sim --sweep`;
      return;
    }
    for (const order of coarseFirst(pointCount))
      scenes.forEach((each, curve) => this.waiting.push({ curve, scene: each, pulsation: least + (most - least) * order / (pointCount - 1) }));
  }

  get isDone() { return !this.running && this.waiting.length === 0; }
  get progress() {
    const all = pointCount * this.curves.length;
    return all ? (all - this.waiting.length - (this.running ? 1 : 0)) / all : 0;
  }

  work(deadline) {
    while (!this.isDone && performance.now() < deadline) {
      if (!this.running && !this.#begin()) continue;
      const { kernel } = this;
      const more = kernel.advanceLine(this.line, stepsBetweenLooksAtTheClock);
      if (kernel.advanceLine(this.bareLine, stepsBetweenLooksAtTheClock) || more) continue;
      const { curve, pulsation } = this.running;
      insert(this.curves[curve].own, pulsation, kernel.lineExtremes(this.line).largest);
      insert(this.curves[curve].bare, pulsation, kernel.lineExtremes(this.bareLine).largest);
      this.running = null;
      ++this.version;
    }
  }

  #begin() {
    const point = this.waiting.shift(), options = optionsOf({ ...point.scene, 'drive-pulsation': point.pulsation }, this.kernel.files);
    const isPlanned = this.kernel.planLine(this.line, options, true) && this.kernel.planLine(this.bareLine, options, false);
    if (isPlanned) this.running = point;
    return isPlanned;
  }
}

const emptyCurve = () => ({ data: new Float64Array(2 * pointCount), count: 0, width: 2 });

function insert(curve, x, y) {
  let at = curve.count;
  while (at > 0 && curve.data[2 * (at - 1)] > x) --at;
  curve.data.copyWithin(2 * (at + 1), 2 * at, 2 * curve.count);
  curve.data.set([x, y], 2 * at);
  ++curve.count;
}

// 0 to count - 1: both ends, the middle, then the middles between those.
function coarseFirst(count) {
  const order = [0, count - 1];
  for (let spacing = count - 1; spacing > 1; spacing /= 2)
    for (let at = spacing / 2; at < count; at += spacing) order.push(at);
  return order;
}
