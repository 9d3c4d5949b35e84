// A run of the machine and the same main mass without absorber, computed a slice at a time so that the page stays awake.

import { missingFile, optionsOf } from './scene.mjs';

// The limit of the page. For longer runs use impact-sim.
const mostSteps = 2e6;
export const stepsBetweenLooksAtTheClock = 500;
// Rounding may raise the restitution of an elastic impact above 1 by as much.
const roundingOfRestitution = 1e-3;

export class Run {
  constructor(kernel, slot) {
    this.kernel = kernel;
    this.slot = slot;
    this.version = 0;  // counts what there is to draw
  }

  start(scene) {
    this.scene = scene;
    this.isReady = this.isDone = false;
    ++this.version;
    this.kernel.discard(this.slot);
    this.refusal = this.#pageRefusal(scene);
    if (this.refusal) return;
    const options = optionsOf(scene, this.kernel.files);
    this.plan = this.kernel.plan(this.slot, options);
    this.refusal = this.plan.refusal;
    if (this.refusal) return;
    this.hasBare = this.kernel.planLine(this.slot, options, false);
    this.isReady = true;
  }
  stop() {
    this.kernel.discard(this.slot);
    this.isReady = false;
    ++this.version;
  }

  // Computes until `deadline` of performance.now(). Returns true if it has done anything.
  work(deadline) {
    if (!this.isReady || this.isDone) return false;
    let more = true;
    while (more && performance.now() < deadline) {
      more = this.kernel.advance(this.slot, stepsBetweenLooksAtTheClock);
      if (this.hasBare) more = this.kernel.advanceLine(this.slot, stepsBetweenLooksAtTheClock) || more;
    }
    this.isDone = !more;
    ++this.version;
    return true;
  }

  rows() { return this.kernel.rows(this.slot); }
  bareRows() { return this.kernel.line(this.slot); }
  // Steps from a row to the next.
  get every() { return this.kernel.rowEvery(this.slot); }
  totals() { return this.kernel.totals(this.slot); }
  bareExtremes() { return this.kernel.lineExtremes(this.slot); }
  bareLargest() { return this.hasBare ? this.bareExtremes().largest : NaN; }
  attenuation() { return 1 - this.totals().largest / this.bareLargest(); }
  // Of all complete impacts: the median distance of the restitution from the law's, and how many restitutions exceed 1.
  restitutions() {
    const { data, count, width } = this.kernel.impacts(this.slot);
    if (count === 0) return null;
    const impacts = Array.from({ length: count }, (_, i) => ({ speed: data[i * width + 1], restitution: data[i * width + 2] }));
    const distances = impacts.map(({ speed, restitution }) => Math.abs(restitution - this.kernel.lawRestitution(this.slot, speed))).sort((a, b) => a - b);
    const above = impacts.filter(({ restitution }) => restitution > 1 + roundingOfRestitution).length;
    return { count, fromLaw: distances[Math.ceil(count / 2) - 1], above };
  }
  fault() { return this.kernel.fault(this.slot); }

  #pageRefusal(scene) {
    const { step, duration } = scene, missing = missingFile(scene);
    if (missing) return { option: missing.name, value: 'no file', allowed: 'a file, or a column of numbers' };
    if (duration / step <= mostSteps) return null;
    return { option: 'duration', value: String(duration), allowed: `${step} to ${mostSteps * step}` };
  }
}
