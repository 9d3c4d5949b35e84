// The machine in SVG: wall, spring, damper, main mass with its cavity, ball, and the stops, which light up with the force.

import { column } from './kernel.mjs';

const floor = 176, middle = 100, rest = 430;  // px
const ballRadius = 22, stopWidth = 10, wall = 22;

export class Machine {
  constructor(figure) {
    figure.querySelector('.drawing').innerHTML = drawing;
    this.parts = {};
    for (const part of figure.querySelectorAll('[data-part]')) this.parts[part.dataset.part] = part;
  }

  // For a scene, and the largest displacement and force that its run has come to.
  fit({ clearance, gravity, base }, largest, peakForce) {
    const key = [clearance, gravity, base, largest, peakForce].join();
    if (key === this.key) return;
    this.key = key;
    const longest = Math.max(largest, 1e-9);
    this.scale = Math.min(150 / longest, 200 / Math.max(clearance, 1e-9));  // px per metre
    this.gap = Math.min(clearance * this.scale, 200);
    this.peakForce = peakForce;
    const half = this.gap / 2 + ballRadius + stopWidth;
    this.half = half + 26;
    const { mass, left, right, scale, weight, base: label } = this.parts;
    weight.setAttribute('d', gravity === 0 ? '' : `M${rest} 16h${70 * Math.sign(gravity)}m${-10 * Math.sign(gravity)} -6l${10 * Math.sign(gravity)} 6l${-10 * Math.sign(gravity)} 6`);
    label.textContent = [gravity !== 0 && 'weight', base !== 'still' && 'shaken base'].filter((word) => word).join(', ');
    label.setAttribute('text-anchor', gravity < 0 ? 'start' : 'end');
    label.setAttribute('x', rest + (gravity < 0 ? 8 : -8));
    mass.setAttribute('d', `M${-this.half} -62h${2 * this.half}v124h${-2 * this.half}zM${-half} -34v68h${2 * half}v-68z`);
    left.setAttribute('x', -half);
    right.setAttribute('x', half - stopWidth);
    const length = roundBelow(120 / this.scale);
    scale.querySelector('path').setAttribute('d', `M0 -4v8M0 0h${length * this.scale}M${length * this.scale} -4v8`);
    scale.querySelector('text').textContent = length >= 1 ? `${length} m` : length >= 1e-3 ? `${+(length * 1e3).toPrecision(1)} mm` : `${+(length * 1e6).toPrecision(1)} um`;
  }

  draw({ data, width }, row) {
    const x1 = data[row * width + column.x1], x2 = data[row * width + column.x2];
    const force = Math.abs(data[row * width + column.force]), side = data[row * width + column.side];
    const at = rest + x1 * this.scale, { mass, ball, spring, damper, left, right, moving } = this.parts;
    moving.setAttribute('transform', `translate(${at} ${middle})`);
    ball.setAttribute('cx', Math.max(-900, Math.min(900, (x2 - x1) * this.scale)));
    const end = at - this.half;
    spring.setAttribute('d', coil(wall, end, middle - 30));
    damper.setAttribute('d', dashpot(wall, end, middle + 34));
    const light = this.peakForce > 0 ? Math.sqrt(Math.min(1, force / this.peakForce)) : 0;
    left.style.setProperty('--light', side < 0 ? light : 0);
    right.style.setProperty('--light', side > 0 ? light : 0);
  }
}

function coil(from, to, y) {
  const turns = 9, lead = 14, pitch = (to - from - 2 * lead) / turns;
  let path = `M${from} ${y}h${lead}`;
  for (let i = 0; i < turns; ++i) path += `l${pitch / 4} -11l${pitch / 2} 22l${pitch / 4} -11`;
  return `${path}H${to}`;
}

function dashpot(from, to, y) {
  const cylinder = from + 110, piston = Math.min(to - 20, cylinder - 12);
  return `M${from} ${y}h50M${cylinder} ${y - 12}H${from + 50}v24H${cylinder}M${piston} ${y - 9}v18M${piston} ${y}H${to}`;
}

function roundBelow(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return power * [5, 2, 1].find((factor) => factor * power <= length);
}

const drawing = `
<svg viewBox="0 0 800 212" aria-hidden="true" focusable="false">
  <path class="ground" d="M${wall} 20V${floor}H790"/><path class="hatch" d="M${wall - 12} 20h12v${floor - 20}h-12z"/>
  <path class="thin" data-part="spring"/><path class="thin" data-part="damper"/>
  <g data-part="moving">
    <path class="mass" data-part="mass" fill-rule="evenodd"/>
    <circle class="wheel" cx="-40" cy="69" r="7"/><circle class="wheel" cx="40" cy="69" r="7"/>
    <rect class="stop" data-part="left" y="-34" width="${stopWidth}" height="68"/>
    <rect class="stop" data-part="right" y="-34" width="${stopWidth}" height="68"/>
    <circle class="ball" data-part="ball" cy="${34 - ballRadius}" r="${ballRadius}"/>
  </g>
  <path class="thin" data-part="weight"/><text data-part="base" y="24"></text>
  <path class="rest" d="M${rest} ${floor + 3}v8"/>
  <g data-part="scale" transform="translate(640 ${floor + 26})"><path class="thin"/><text x="-8" y="4" text-anchor="end"></text></g>
</svg>`;
