// Numbers for people, and the tables that they stand in.

export function tableFrom(csv) {
  const [header, ...lines] = csv.trim().split('\n').map((line) => line.split(','));
  return lines.map((cells) => Object.fromEntries(header.map((name, i) => [name, cells[i]])));
}

// To three significant digits, or as many as required, without trailing zeros.
export function short(value, digits = 3) {
  if (value === 0) return '0';
  if (!Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e6) return value.toExponential(digits - 1).replace(/\.?0+e/, 'e').replace('e+', 'e');
  const text = value.toPrecision(digits);
  return text.includes('e') ? String(Math.round(value)) : text.includes('.') ? text.replace(/\.?0+$/, '') : text;
}

// The nearest number of three digits that is not beyond either end.
export function inside(value, least, most) {
  const nearest = value < least ? least : value > most ? most : value;
  const rounded = Number(nearest.toPrecision(3));
  if (rounded >= least && rounded <= most) return rounded;
  const place = 10 ** (Math.floor(Math.log10(Math.abs(nearest))) - 2);
  const inner = Number((rounded + (rounded < least ? place : -place)).toPrecision(3));
  return inner >= least && inner <= most ? inner : nearest;
}

// About `count` round numbers between two ends.
export function ticksBetween(least, most, count) {
  const rough = (most - least) / count, power = 10 ** Math.floor(Math.log10(rough));
  const spacing = power * ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10);
  const ticks = [];
  for (let n = Math.ceil(least / spacing - 1e-9); n * spacing <= most + 1e-9 * spacing; ++n) ticks.push(n * spacing);
  return ticks;
}
