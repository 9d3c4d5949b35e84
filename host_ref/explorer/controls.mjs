// The controls: a slider and a number, or a list, for each value of the scene; beside each the kernel's refusal, when
// it names that value, with a button that sets what is allowed.

import { inside, short } from './numbers.mjs';
import { groups, isShown, values } from './scene.mjs';

const positions = 1000;  // of a slider

export class Controls {
  // `onChange(name, value)`; value null takes back a difference of run B. `files`: where samples are kept.
  constructor(form, files, onChange) {
    this.rows = new Map();
    this.files = files;
    form.append(...groups.map((group, index) => this.#group(group, index, onChange)));
  }

  // `own`: the names in which the edited run differs from run A.
  show(scene, own, refusals) {
    for (const value of values) {
      const row = this.rows.get(value.name), mine = refusals.filter(({ refusal }) => controlOf(refusal.option) === value.name);
      const key = [scene[value.name], scene.step, scene.law, isShown(value, scene), own.has(value.name), JSON.stringify(mine)].join();
      if (row.key === key) continue;
      row.key = key;
      row.hidden = !isShown(value, scene);
      row.classList.toggle('own', own.has(value.name));
      row.back.hidden = !own.has(value.name);
      if (value.choices) {
        row.choice.value = scene[value.name];
      } else if (value.samples) {
        const file = scene[value.name], lines = this.files.lines(file);
        row.note.textContent = file && `${file}: ${lines} lines in ${value.samples}, ${short(lines * scene.step)} s`;
      } else {
        const unit = value.unit(scene), text = `${short(scene[value.name], 6)} ${unit}`.trim();
        row.slider.value = positionOf(value, scene[value.name]);
        row.slider.setAttribute('aria-valuetext', text);
        row.text = short(scene[value.name], 6);
        if (document.activeElement !== row.number) row.number.value = row.text;
        row.unit.textContent = unit;
      }
      this.#showRefusal(value, row, scene, mine);
    }
  }

  #group({ title, values: members }, index, onChange) {
    const group = element('details', { className: 'group' });
    group.open = index === 0 || title === 'Computation' || innerWidth > 900;
    group.append(element('summary', { textContent: title }), ...members.map((value) => this.#row(value, onChange)));
    return group;
  }

  #row(value, onChange) {
    const id = `value-${value.name}`, row = element('div', { className: 'value' });
    const label = element('label', { textContent: value.label, htmlFor: id });
    row.back = element('button', { type: 'button', className: 'back', textContent: 'as A', title: 'As in run A' });
    row.back.addEventListener('click', () => onChange(value.name, null));
    row.refusal = element('p', { className: 'refusal', id: `${id}-refusal` });
    row.refusal.setAttribute('role', 'alert');
    row.onChange = onChange;
    if (value.choices) {
      row.choice = element('select', { id });
      for (const [name, text] of Object.entries(value.choices)) row.choice.append(new Option(text, name));
      row.choice.addEventListener('change', () => onChange(value.name, row.choice.value));
      row.append(label, row.back, row.choice, row.refusal);
    } else if (value.samples) {
      row.file = element('input', { type: 'file', id, accept: '.txt,.csv,text/plain' });
      row.pasted = element('textarea', { id: `${id}-pasted`, rows: 2, placeholder: 'or a column of numbers, pasted here', spellcheck: false, autocomplete: 'off' });
      row.pasted.setAttribute('aria-label', `${value.label}: a column of numbers`);
      row.note = element('small', { className: 'note' });
      const take = (name, text) => onChange(value.name, this.files.add(name, text));
      row.file.addEventListener('change', async () => {
        const [file] = row.file.files;
        if (!file) return;
        take(file.name, await file.text());
        row.file.value = '';  // the same file may be chosen again, changed
      });
      row.pasted.addEventListener('change', () => { if (row.pasted.value.trim() !== '') take('pasted.txt', row.pasted.value); });
      row.append(label, row.back, row.file, row.pasted, row.note, row.refusal);
    } else {
      row.slider = element('input', { type: 'range', id, min: 0, max: positions, step: 1 });
      row.slider.addEventListener('input', () => onChange(value.name, valueAt(value, Number(row.slider.value))));
      row.number = element('input', { type: 'text', inputMode: 'decimal', id: `${id}-number`, autocomplete: 'off' });
      row.number.setAttribute('aria-label', `${value.label}, as a number`);
      row.number.addEventListener('change', () => {
        const number = Number(row.number.value.replace(',', '.'));
        if (row.number.value.trim() !== '' && Number.isFinite(number)) onChange(value.name, number);
        else row.number.value = row.text;
      });
      row.unit = element('span', { className: 'unit' });
      row.append(label, row.back, row.slider, row.number, row.unit, row.refusal);
    }
    row.inputs = [row.choice, row.slider, row.number, row.file, row.pasted].filter((input) => input);
    for (const input of row.inputs) input.setAttribute('aria-describedby', row.refusal.id);
    this.rows.set(value.name, row);
    return row;
  }

  #showRefusal(value, row, scene, refusals) {
    const text = refusals.map(({ letter, refusal }) => `${letter}${refusal.value} is refused. Allowed: ${refusal.allowed}`).join('. ');
    if (row.refusal.dataset.text === text) return;
    row.refusal.dataset.text = text;
    row.refusal.replaceChildren(text);
    for (const input of row.inputs) input.setAttribute('aria-invalid', text !== '');
    if (refusals.length === 0) return;
    // A file that is too short is a run that is too long.
    const lines = value.samples && this.files.lines(scene[value.name]);
    const [name, allowed] = value.samples ? ['duration', / lines$/.test(refusals[0].refusal.value) ? Number((lines * scene.step).toPrecision(12)) : null]
      : [value.name, allowedValue(value, refusals[0].refusal, Number(scene[value.name]))];
    if (allowed === null) return;
    const button = element('button', { type: 'button', textContent: `Set ${value.samples ? `the time to ${short(allowed, 6)} s` : value.choices?.[allowed] ?? short(allowed, 6)}` });
    button.addEventListener('click', () => row.onChange(name, allowed));
    row.refusal.append(' ', button);
  }
}

// Where the kernel's name of a value is not the control's.
function controlOf(option) { return option === 'damping' || option === 'paper-damping' ? 'damping-by' : option; }

// The value nearest to what was asked that the words of a refusal allow; null where they name none.
function allowedValue(value, { allowed }, asked) {
  if (value.choices) {
    const words = allowed.split(/[^a-z0-9-]+/);
    return words.find((word) => word in value.choices) ?? null;
  }
  const ranges = [...allowed.matchAll(/(\S+) to ([^\s,;]+)/g)].map(([, least, most]) => [Number(least), Number(most)]);
  const [least, most] = ranges.at(-1) ?? [NaN, NaN];
  return Number.isNaN(least + most) ? null : inside(asked, least, most);
}

function positionOf({ least, most, log, zero }, value) {
  if (zero && value === 0) return 0;
  const share = log ? Math.log(value / least) / Math.log(most / least) : (value - least) / (most - least);
  return Math.round(positions * Math.min(1, Math.max(0, Number.isNaN(share) ? 0 : share)));
}
function valueAt({ least, most, log, zero }, position) {
  if (zero && position === 0) return 0;
  const share = position / positions;
  const value = log ? least * (most / least) ** share : least + (most - least) * share;
  return Number(value.toPrecision(3));
}

export function element(tag, properties) { return Object.assign(document.createElement(tag), properties); }
