// A picture: lines, points, cells and rules in a frame, as SVG; its legend as text below, which flows; and where its
// points are and what they say.

import { short, ticksBetween } from '../../explorer/numbers.mjs';

const shapes = { square: 'M-3-3h6v6h-6z', circle: 'M-3 0a3 3 0 1 0 6 0a3 3 0 1 0-6 0z', triangle: 'M0-4l4 7h-8z', cross: 'M-3-3l6 6m0-6l-6 6' };
const clean = (text) => String(text).replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/"/g, '&quot;');

// From values to places between `from` and `to`: { label, isLog, range, ticks: [[value, text]...] }, the last two of
// which follow from the values where they are not stated.
function axisOf({ label, isLog, range, ticks }, values, from, to) {
  const scale = isLog ? Math.log10 : (value) => value, known = values.filter((value) => Number.isFinite(scale(value)));
  const ends = range ?? [Math.min(...known), Math.max(...known)], room = range ? 0 : 0.03;
  const [low, high] = ends.map(scale), span = high - low || 1, [least, most] = [low - room * span, low + (1 + room) * span];
  const at = (value) => from + (to - from) * (scale(value) - least) / (most - least);
  const decades = () => {
    const stride = Math.ceil((most - least) / 7), all = [];
    for (let power = Math.ceil(least / stride) * stride; power <= most; power += stride)
      all.push([10 ** power, `10<tspan dy="-5" font-size="10">${String(power).replace('-', '−')}</tspan>`]);
    return all;
  };
  return { at, label, ticks: ticks ?? (isLog ? decades() : ticksBetween(least, most, 6).map((value) => [value, short(value).replace('-', '−')])) };
}

const strokeOf = ({ colour = 'var(--ink)', dash = '', width = 1.5 }) => `stroke="${colour}" stroke-width="${width}" stroke-dasharray="${dash}"`;
const markerOf = ({ marker, isFilled, colour = 'var(--ink)' }, x, y) =>
  `<path d="${shapes[marker]}" transform="translate(${x} ${y})" fill="${isFilled ? colour : 'none'}" stroke="${colour}" stroke-width="1.2"/>`;

// series: { name, points: [{ x, y, text }...], colour, dash, width, marker, isFilled }, without a name not in the legend and
// with width 0 without a line. rules: { x or y, text }. cells: { x, y, colour, isFaded, isCrossed, text }, `cell` their
// size in units of the axes' logarithms. Points without a text say nothing.
export function chart({ name, width = 520, height = 380, left = 62, x, y, series = [], rules = [], cells = [], cell = [0, 0] }) {
  const [right, top, bottom] = [rules.some((rule) => rule.text) ? 52 : 14, 10, 44], all = [...series.flatMap(({ points }) => points), ...cells];
  const across = axisOf(x, all.map((point) => point.x), left, width - right), up = axisOf(y, all.map((point) => point.y), height - bottom, top);
  const place = (point) => [across.at(point.x), up.at(point.y)].map((at) => Math.round(10 * at) / 10), isPlaced = (point) => place(point).every(Number.isFinite);
  const parts = [];
  for (const [value, text] of across.ticks) {
    const at = across.at(value);
    parts.push(`<path class="grid" d="M${at} ${top}V${height - bottom}"/><text x="${at}" y="${height - bottom + 18}" text-anchor="middle">${text}</text>`);
  }
  for (const [value, text] of up.ticks)
    parts.push(`<path class="grid" d="M${left} ${up.at(value)}H${width - right}"/><text x="${left - 6}" y="${up.at(value) + 5}" text-anchor="end">${text}</text>`);
  parts.push(`<text x="${(left + width - right) / 2}" y="${height - 6}" text-anchor="middle">${x.label ?? ''}</text>`,
    y.label ? `<text transform="translate(14 ${(top + height - bottom) / 2}) rotate(-90)" text-anchor="middle">${y.label}</text>` : '');
  for (const { x: atX, y: atY, text } of rules) {
    const line = atX === undefined ? `M${left} ${up.at(atY)}H${width - right}` : `M${across.at(atX)} ${top}V${height - bottom}`;
    parts.push(`<path d="${line}" ${strokeOf({ dash: '6 4', width: 0.8 })}/>`);
    if (text) parts.push(`<text x="${width - right + 4}" y="${up.at(atY) + 5}">${text}</text>`);
  }
  const [wide, high] = [across.at(10 ** cell[0]) - across.at(1), up.at(1) - up.at(10 ** cell[1])];
  for (const isFaded of [false, true])
    for (const colour of new Set(cells.map((each) => each.colour))) {
      const own = cells.filter((each) => each.colour === colour && !each.isFaded === !isFaded).map(place);
      if (own.length > 0) parts.push(`<path class="cells" fill="${colour}" opacity="${isFaded ? 0.4 : 1}" d="${own.map(([h, v]) => `M${h - wide / 2} ${v - high / 2}h${wide}v${high}h${-wide}z`).join('')}"/>`);
    }
  const crossed = cells.filter(({ isCrossed }) => isCrossed).map(place);
  if (crossed.length > 0) parts.push(`<path class="crosses" stroke="#111" stroke-width="1.5" d="${crossed.map(([h, v]) => `M${h - 3} ${v - 3}l6 6m0-6l-6 6`).join('')}"/>`);
  const legend = [];
  for (const one of series) {
    const places = one.points.filter(isPlaced).map(place), line = one.width === 0 ? '' : `<path class="line" fill="none" d="M${places.map((at) => at.join(' ')).join('L')}" ${strokeOf(one)}/>`;
    if (places.length === 0) continue;
    parts.push(line, ...(one.marker ? places.map((at) => markerOf(one, ...at)) : []));
    if (one.name) legend.push(`<span><svg viewBox="0 0 28 10" aria-hidden="true">${one.width === 0 ? '' : `<path d="M0 5H28" ${strokeOf(one)}/>`}${one.marker ? markerOf(one, 14, 5) : ''}</svg>${clean(one.name)}</span>`);
  }
  return {
    html: `<svg class="chart" role="img" aria-label="${clean(name)}" viewBox="0 0 ${width} ${height}">${parts.join('')}<path class="frame" d="M${left} ${top}V${height - bottom}H${width - right}"/><circle class="mark" r="7" visibility="hidden"/></svg>`
      + (legend.length > 0 ? `<p class="legend">${legend.join('')}</p>` : ''),
    points: all.filter((point) => point.text && isPlaced(point)).map((point) => ({ at: place(point), text: point.text })),
    width,
  };
}
