// A plot on a canvas: series in a frame with round ticks. A series is a table of doubles, drawn as a line (of many
// points within a pixel, the least and the most), as points, or as an area down to another column.

import { short, ticksBetween } from './numbers.mjs';

const font = '11px system-ui, sans-serif';
const margin = { left: 60, right: 10, top: 8, bottom: 34 };

export class Plot {
  // `x` and `y`: { label, scale }, where a number times `scale` is what the label's unit shows.
  constructor(figure, { x, y }) {
    this.canvas = figure.querySelector('canvas');
    this.axes = { x: { scale: 1, ...x }, y: { scale: 1, ...y } };
    this.cursor = document.createElement('i');
    const stage = document.createElement('div');
    stage.className = 'stage';
    this.canvas.replaceWith(stage);
    stage.append(this.canvas, this.cursor);
    this.pen = this.canvas.getContext('2d', { alpha: false });
    this.drawn = '';
    // Reading the size in each frame would cause a new layout of the page.
    this.size = [0, 0];
    new ResizeObserver(() => { this.size = [this.canvas.clientWidth, this.canvas.clientHeight]; }).observe(this.canvas);
  }

  // What `make` returns, kept as long as `key` is the same.
  remember(key, make) {
    if (this.key !== key) this.remembered = make();
    this.key = key;
    return this.remembered;
  }

  // Whether there is anything new to draw: `key` says what it would be.
  begin(key, range) {
    const ratio = Math.max(window.devicePixelRatio || 1, 1), [width, height] = this.size;
    const whole = `${key} ${width} ${height} ${ratio} ${theme.name} ${Object.values(range)}`;
    if (whole === this.drawn || width === 0) return false;
    this.drawn = whole;
    const pixels = [Math.round(width * ratio), Math.round(height * ratio)];
    if (this.canvas.width !== pixels[0] || this.canvas.height !== pixels[1]) [this.canvas.width, this.canvas.height] = pixels;
    this.range = range;
    this.ratio = ratio;
    this.frame = { left: margin.left, top: margin.top, width: width - margin.left - margin.right, height: height - margin.top - margin.bottom };
    const { frame } = this, xs = frame.width / (range.right - range.left), ys = frame.height / (range.bottom - range.top);
    this.scales = { xs, x0: frame.left - xs * range.left, ys, y0: frame.top - ys * range.top };
    this.pen.setTransform(1, 0, 0, 1, 0, 0);
    this.pen.drawImage(this.#backdrop(width, height), 0, 0);
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.pen.save();
    this.pen.beginPath();
    this.pen.rect(this.frame.left, this.frame.top, this.frame.width, this.frame.height);
    this.pen.clip();
    return true;
  }
  end() { this.pen.restore(); }

  // Of many points within a pixel's column the least and the most.
  line({ data, count, width }, x, y, style) {
    this.#style(style);
    const { pen, ratio, scales: { x0, xs, y0, ys } } = this, [first, last] = this.#visible(data, count, width, x);
    const column = 1 / (ratio * xs), isDense = last - first > 2 * ratio * this.frame.width;
    pen.beginPath();
    for (let i = first, before = 0; i < last;) {
      const at = data[i * width + x], end = isDense ? (Math.floor(at / column) + 1) * column : at;
      let least = data[i * width + y], most = least;
      for (++i; i < last && data[i * width + x] < end; ++i) {
        const value = data[i * width + y];
        if (value < least) least = value;
        if (value > most) most = value;
      }
      const across = x0 + xs * (isDense ? end - column / 2 : at);
      if ((least - most) * ys < 1) {
        pen.lineTo(across, y0 + ys * (before = (least + most) / 2));
      } else {
        const isNearLeast = Math.abs(before - least) < Math.abs(before - most);
        pen.lineTo(across, y0 + ys * (isNearLeast ? least : most));
        pen.lineTo(across, y0 + ys * (before = isNearLeast ? most : least));
      }
    }
    pen.stroke();
  }

  // Every point joined to the one before it, but for those within a pixel of that.
  path({ data, count, width }, from, to, x, y, style) {
    this.#style(style);
    const { pen, scales: { x0, xs, y0, ys } } = this, end = Math.min(to, count);
    pen.beginPath();
    for (let i = from, beforeX = Infinity, beforeY = 0; i < end; ++i) {
      const across = x0 + xs * data[i * width + x], up = y0 + ys * data[i * width + y];
      if (Math.abs(across - beforeX) + Math.abs(up - beforeY) < 1.2 && i < end - 1) continue;
      pen.lineTo(beforeX = across, beforeY = up);
    }
    pen.stroke();
  }

  area({ data, count, width }, x, low, high, style) {
    const { pen, scales: { x0, xs, y0, ys } } = this, [first, last] = this.#visible(data, count, width, x);
    const stride = Math.max(1, Math.floor((last - first) / this.frame.width));
    pen.fillStyle = style.colour;
    pen.beginPath();
    for (let i = first; i < last; i += stride) pen.lineTo(x0 + xs * data[i * width + x], y0 + ys * data[i * width + high]);
    for (let i = last - 1; i >= first; i -= stride) pen.lineTo(x0 + xs * data[i * width + x], low === null ? y0 : y0 + ys * data[i * width + low]);
    pen.fill();
  }

  points({ data, count, width }, x, y, style, from = 0) {
    const { pen } = this;
    pen.fillStyle = pen.strokeStyle = style.colour;
    pen.lineWidth = 1.5;
    pen.setLineDash([]);
    for (let i = from; i < count; ++i) {
      const at = this.px(data[i * width + x]), value = this.py(Math.min(data[i * width + y], this.range.top));
      pen.beginPath();
      if (style.shape === 'cross') {
        pen.moveTo(at - 3.5, value - 3.5), pen.lineTo(at + 3.5, value + 3.5);
        pen.moveTo(at - 3.5, value + 3.5), pen.lineTo(at + 3.5, value - 3.5);
        pen.stroke();
      } else {
        pen.arc(at, value, 3, 0, 7);
        pen.fill();
      }
    }
  }

  note(text) {
    this.pen.fillStyle = theme.quiet;
    this.pen.font = font;
    this.pen.textAlign = 'center';
    this.pen.textBaseline = 'middle';
    this.pen.fillText(text, this.frame.left + this.frame.width / 2, this.frame.top + this.frame.height / 2);
  }

  // A line at `x` over the picture.
  mark(x) {
    const isSeen = x !== null && x >= this.range?.left && x <= this.range.right;
    this.cursor.style.transform = isSeen ? `translateX(${this.px(x)}px)` : 'translateX(-10px)';
  }

  px(x) { return this.scales.x0 + this.scales.xs * x; }
  py(y) { return this.scales.y0 + this.scales.ys * y; }
  xAt(clientX) {
    const share = (clientX - this.canvas.getBoundingClientRect().left - this.frame.left) / this.frame.width;
    return this.range.left + Math.min(1, Math.max(0, share)) * (this.range.right - this.range.left);
  }

  // Rows are in the order of x.
  #visible(data, count, width, x) {
    const search = (value) => {
      let low = 0, high = count;
      while (low < high) {
        const middle = (low + high) >> 1;
        if (data[middle * width + x] < value) low = middle + 1;
        else high = middle;
      }
      return low;
    };
    return [Math.max(0, search(this.range.left) - 1), Math.min(count, search(this.range.right) + 1)];
  }

  #style({ colour, dash = [], thickness = 1.5 }) {
    this.pen.strokeStyle = colour;
    this.pen.lineWidth = thickness;
    this.pen.lineJoin = 'bevel';
    this.pen.setLineDash(dash);
  }

  // Ground, grid and numbers, which stay the same from most pictures to the next.
  #backdrop(width, height) {
    const { ratio, range } = this, { width: across, height: up } = this.canvas;
    const key = [across, up, ratio, theme.name, ...Object.values(range)].join();
    if (key === this.backdropKey) return this.backdrop;
    this.backdropKey = key;
    this.backdrop ??= document.createElement('canvas');
    Object.assign(this.backdrop, { width: across, height: up });
    const pen = this.backdrop.getContext('2d');
    pen.scale(ratio, ratio);
    this.#drawFrame(pen, width, height);
    return this.backdrop;
  }
  #drawFrame(pen, width, height) {
    const { frame, range, axes } = this;
    pen.fillStyle = theme.panel;
    pen.fillRect(0, 0, width, height);
    pen.font = font;
    pen.strokeStyle = theme.grid;
    pen.lineWidth = 1;
    const ends = (low, high, { scale }, count) => ticksBetween(low * scale, high * scale, count).map((tick) => [tick / scale, short(tick)]);
    pen.fillStyle = theme.quiet;
    pen.textAlign = 'center';
    pen.textBaseline = 'top';
    for (const [x, text] of ends(range.left, range.right, axes.x, Math.max(2, frame.width / 90))) {
      pen.beginPath(), pen.moveTo(this.px(x), frame.top), pen.lineTo(this.px(x), frame.top + frame.height), pen.stroke();
      pen.fillText(text, this.px(x), frame.top + frame.height + 4);
    }
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    for (const [y, text] of ends(range.bottom, range.top, axes.y, Math.max(2, frame.height / 40))) {
      pen.beginPath(), pen.moveTo(frame.left, this.py(y)), pen.lineTo(frame.left + frame.width, this.py(y)), pen.stroke();
      pen.fillText(text, frame.left - 5, this.py(y));
    }
    pen.textAlign = 'center';
    pen.textBaseline = 'bottom';
    pen.fillText(axes.x.label, frame.left + frame.width / 2, height - 2);
    pen.save();
    pen.translate(2, frame.top + frame.height / 2);
    pen.rotate(-Math.PI / 2);
    pen.textBaseline = 'top';
    pen.fillText(axes.y.label, 0, 0);
    pen.restore();
  }
}

// The page's colours, as they are now; `name` changes with them.
export const theme = { name: '' };
export function readTheme() {
  const style = getComputedStyle(document.documentElement);
  for (const colour of ['ink', 'quiet', 'grid', 'panel', 'a', 'b', 'bare', 'lost', 'rubbed', 'damped', 'moving'])
    theme[colour] = style.getPropertyValue(`--${colour}`).trim();
  theme.name = theme.panel + theme.ink;
}
