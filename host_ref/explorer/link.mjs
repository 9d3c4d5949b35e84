// The page's state in its address: what differs from the defaults, as #a.law=hertz&b.newmark=average, the samples, and
// the instant at which it stands still.

import { plainName } from './samples.mjs';
import { filesOf, valueNamed } from './scene.mjs';

export function hashOf({ a, b, part, time }, initial, files) {
  const words = new URLSearchParams();
  for (const [name, value] of Object.entries(a)) if (value !== initial[name]) words.set(`a.${name}`, value);
  if (b) {
    words.set('b', '');
    for (const [name, value] of Object.entries(b)) words.set(`b.${name}`, value);
  }
  words.set('part', part);
  if (time !== null) words.set('time', Number(time.toPrecision(6)));
  for (const name of new Set([a, { ...a, ...b }].flatMap((scene) => filesOf(Object.entries(scene))))) {
    const text = files.inLink(name);
    if (text !== null) words.set(`file.${name}`, text);
  }
  return `#${words}`;
}

// What is not of this page is passed over.
export function stateFrom(hash, initial, files) {
  const state = { a: { ...initial }, b: null, part: null, time: null };
  for (const [key, text] of new URLSearchParams(hash.replace(/^#/, ''))) {
    const [run, name] = key.split(/\.(.*)/), value = valueNamed(name);
    if (key === 'part') state.part = text;
    if (key === 'time' && Number(text) >= 0) state.time = Number(text);
    if (run === 'file' && name) files.fromLink(name, text);
    if (run === 'b') state.b ??= {};
    if (!value || !(run === 'a' || run === 'b')) continue;
    const stated = value.samples ? plainName(text) : value.choices ? (text in value.choices ? text : null) : text.trim() !== '' && Number.isFinite(Number(text)) ? Number(text) : null;
    if (stated !== null) state[run][name] = stated;
  }
  return state;
}
