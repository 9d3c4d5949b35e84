// The kernel in WebAssembly (binding.cpp): scenes go in as text, numbers come out where they lie in its memory. All
// physics is on that side.

import { SampleFiles } from './samples.mjs';

export const rowWidth = 13;
export const column = {
  t: 0, x1: 1, v1: 2, x2: 3, v2: 4, penetration: 5, force: 6,
  dissipated: 7, rubbed: 8, lost: 9, found: 10, supplied: 11, side: 12,
};
export const contactWidth = 3;  // t, penetration, force
export const impactWidth = 3;   // t, speed, restitution
export const lineColumn = { t: 0, x1: 1 };
const lineWidth = 2;
const extremeNames = ['largest', 'leastX1', 'mostX1'];
const totalNames = [...extremeNames, 'dissipated', 'impacts', 'peakForce', 'rubbed', 'energyError',
  'mostSupplied', 'mostFound', 'leastDissipated'];

// What a page holds as base64 of a gzip file.
export async function unpacked(base64) {
  const packed = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}

export class Kernel {
  static async load(bytes) {
    // The C library's standard output, which nothing writes to.
    const silent = { fd_write: () => 0, fd_close: () => 0, fd_seek: () => 0 };
    const { instance } = await WebAssembly.instantiate(bytes, { wasi_snapshot_preview1: silent });
    instance.exports._initialize();
    return new Kernel(instance.exports);
  }

  constructor(calls) {
    this.calls = calls;
    this.files = new SampleFiles(this);
  }

  defaultScene() {
    this.calls.default_scene();
    return Object.fromEntries(this.#textAt(this.calls.text()).trim().split('\n').map((line) => line.split(' ')));
  }

  // What a scene's file options name.
  writeFile(name, text) {
    this.#put((size) => this.calls.room(size), text);
    this.#put(() => this.calls.text(), `${name}\0`);
    this.calls.write_file();
  }

  // { stepper, why, contactDamping }, or { refusal: { option, value, allowed } }.
  plan(slot, options) {
    this.#say(options);
    const isPlanned = this.calls.plan(slot);
    const [, ...lines] = this.#textAt(this.calls.text()).split('\n');
    if (!isPlanned) return { refusal: { option: lines[0], value: lines[1], allowed: lines[2] } };
    return { stepper: lines[0], why: lines[1], contactDamping: Number(lines[2]) };
  }
  discard(slot) { this.calls.discard(slot); }

  // Returns true if there is more to do.
  advance(slot, steps) { return this.calls.advance(slot, steps) !== 0; }
  // A line is a faster run that records only the displacement. Returns true if it was planned.
  planLine(slot, options, withAbsorber) {
    this.#say(options);
    return this.calls.plan_line(slot, withAbsorber) !== 0;
  }
  advanceLine(slot, steps) { return this.calls.advance_line(slot, steps) !== 0; }
  line(slot) { return this.#table(this.calls.line_rows(slot), this.calls.line_row_count(slot), lineWidth); }
  lineExtremes(slot) { return this.#named(extremeNames, this.calls.line_extremes(slot)); }
  fault(slot) { return this.calls.fault(slot) ? this.#textAt(this.calls.text()) : ''; }

  // Views, which are invalid after the next call that records.
  rows(slot) { return this.#table(this.calls.rows(slot), this.calls.row_count(slot), rowWidth); }
  contacts(slot) { return this.#table(this.calls.contacts(slot), this.calls.contact_count(slot), contactWidth); }
  impacts(slot) { return this.#table(this.calls.impacts(slot), this.calls.impact_count(slot), impactWidth); }
  rowEvery(slot) { return this.calls.row_every(slot); }
  totals(slot) { return this.#named(totalNames, this.calls.totals(slot)); }
  lawRestitution(slot, speed) { return this.calls.law_restitution(slot, speed); }
  rig(slot, options) {
    this.#say(options);
    return this.#textAt(this.calls.rig(slot));
  }
  csv(slot) { return this.#textAt(this.calls.csv(slot)); }

  #say(options) {
    this.#put(() => this.calls.text(), options.map(([name, value]) => `${name} ${value}\n`).join('') + '\0');
  }
  #put(address, text) {
    const bytes = new TextEncoder().encode(text), at = address(bytes.length);
    new Uint8Array(this.calls.memory.buffer, at, bytes.length).set(bytes);
  }
  #named(names, address) {
    const numbers = new Float64Array(this.calls.memory.buffer, address, names.length);
    return Object.fromEntries(names.map((name, i) => [name, numbers[i]]));
  }
  #table(address, count, width) {
    return { data: new Float64Array(this.calls.memory.buffer, address, count * width), count, width };
  }
  #textAt(address) {
    const bytes = new Uint8Array(this.calls.memory.buffer, address);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }
}
