// Files of samples, one per line and step: the user's own, and an example of a base that shakes. scene_text.hpp decides
// what the lines mean and whether they are numbers.

const mostInLink = 200000;  // letters

// A name that a shell takes as it is.
export const plainName = (name) => name.replace(/[^A-Za-z0-9._-]+/g, '_').replace(/^[-.]+/, '') || 'samples.txt';

export class SampleFiles {
  constructor(kernel) {
    this.kernel = kernel;
    this.files = new Map();  // { text, lines } by name
  }

  // The name that it has here, which no other text has.
  add(name, text) {
    const lines = text.replace(/\r/g, '').trim(), whole = lines === '' ? '' : `${lines}\n`;
    let own = plainName(name);
    for (let n = 2; (this.text(own) ?? whole) !== whole; ++n) own = plainName(name).replace(/(\.[^.]*)?$/, `_${n}$1`);
    this.#keep(own, whole);
    return own;
  }
  text(name) { return this.files.get(name)?.text; }
  lines(name) { return this.files.get(name)?.lines ?? 0; }

  // The example's file for a step, of at least as many lines.
  example(step, count) {
    const name = `shaken_base_${step}.txt`;
    if (this.lines(name) < count) this.#keep(name, shakenBase(step, Math.max(count, Math.round(2 / step))));
    return name;
  }

  // For a link: a name and a text without line ends; null where the text is too long for an address.
  inLink(name) {
    const text = this.text(name)?.trim().replaceAll('\n', ' ');
    return text !== undefined && text.length <= mostInLink ? text : null;
  }
  fromLink(name, text) { this.#keep(plainName(name), `${text.trim().replaceAll(' ', '\n')}\n`); }

  #keep(name, text) {
    this.files.set(name, { text, lines: text.split('\n').length - 1 });
    this.kernel.writeFile(name, text);
  }
}

// The readings of an accelerometer on a machine that runs up: 5 m/s^2, from 20 to 60 rad/s within two seconds.
function shakenBase(step, count) {
  const lines = [];
  for (let n = 1; n <= count; ++n) {
    const t = n * step, up = Math.min(t, 2);
    lines.push((5 * Math.sin(20 * up + 10 * up * up + 60 * (t - up))).toFixed(5));
  }
  return `${lines.join('\n')}\n`;
}
