// The values of a scene, by the names of impact-sim's options. The controls, the kernel's input, the command and the link
// all follow from this list. A slider has a useful range. The kernel's own range is wider, and the kernel prints it in its
// refusals. `zero` means that a logarithmic slider ends in 0. `samples` means a file of samples, in this unit.

export const groups = [
  { title: 'Contact', values: [
    { name: 'law', label: 'Contact law', choices: { 'hunt-crossley': 'Hunt-Crossley', 'hertz': 'Hertz', 'hooke-newton': 'Hooke-Newton' } },
    { name: 'contact-stiffness', label: 'Stiffness of a stop, k1', unit: (scene) => scene.law === 'hooke-newton' ? 'N/m' : 'N/m^1.5', least: 1e2, most: 1e12, log: true },
    { name: 'damping-by', label: 'Damping of a stop is set by', choices: { 'c1': 'its coefficient c1', 'restitution': 'a restitution, exactly', 'paper': "a restitution, the paper's (2.3), (2.9)", 'hunt-crossley': "each impact's speed: Hunt-Crossley, (2.9)", 'herbert-mcwhannell': "each impact's speed: Herbert-McWhannell", 'lee-wang': "each impact's speed: Lee-Wang", 'lankarani-nikravesh': "each impact's speed: Lankarani-Nikravesh", 'flores': "each impact's speed: Flores", 'hu-guo': "each impact's speed: Hu-Guo", 'exact': "each impact's speed: exactly" }, shown: (scene) => scene.law !== 'hertz' },
    { name: 'contact-damping', label: 'Damping, c1', unit: (scene) => scene.law === 'hooke-newton' ? 'N s/m' : 'N s/m^2.5', least: 1, most: 1e12, log: true, shown: (scene) => scene.law !== 'hertz' && scene['damping-by'] === 'c1' },
    { name: 'restitution', label: 'Restitution, e', unit: () => '', least: 0.05, most: 1, shown: (scene) => scene.law !== 'hertz' && scene['damping-by'] !== 'c1' },
    { name: 'impact-speed', label: 'at an impact speed of', unit: () => 'm/s', least: 0.01, most: 10, log: true, shown: (scene) => scene.law !== 'hertz' && ['restitution', 'paper'].includes(scene['damping-by']) },
    { name: 'tension', label: 'A stop may pull', choices: { clamp: 'no, it releases the ball at zero force', allow: 'yes, as the paper writes it' }, shown: (scene) => scene.law === 'hooke-newton' },
    { name: 'stops', label: 'Stops', choices: { both: 'both', left: 'left', right: 'right' } },
  ] },
  { title: 'Masses and spring', values: [
    { name: 'main-mass', label: 'Main mass, M', unit: () => 'kg', least: 0.01, most: 100, log: true },
    { name: 'main-stiffness', label: 'Its spring, k', unit: () => 'N/m', least: 1, most: 1e6, log: true },
    { name: 'main-damping', label: 'Its damper, c', unit: () => 'N s/m', least: 1e-3, most: 100, log: true },
    { name: 'ball-mass', label: 'Ball, m', unit: () => 'kg', least: 1e-3, most: 10, log: true },
    { name: 'clearance', label: 'Clearance, d', unit: () => 'm', least: 1e-4, most: 0.2, log: true },
  ] },
  { title: 'Drive', values: [
    { name: 'drive', label: 'Drive', choices: { 'sine': 'a sine', 'none': 'none', 'drive-file': 'samples of the force', 'base-file': "samples of the base's displacement" } },
    { name: 'drive-amplitude', label: 'Amplitude', unit: () => 'N', least: 0.1, most: 1000, log: true, shown: (scene) => scene.drive === 'sine' },
    { name: 'drive-pulsation', label: 'Angular frequency', unit: () => 'rad/s', least: 1, most: 1000, log: true, shown: (scene) => scene.drive === 'sine' },
    { name: 'drive-file', label: 'Force, one sample per step', samples: 'N', shown: (scene) => scene.drive === 'drive-file' },
    { name: 'base-file', label: 'Displacement of the base, one sample per step', samples: 'm', shown: (scene) => scene.drive === 'base-file' },
  ] },
  { title: 'Weight, base, friction', values: [
    { name: 'gravity', label: 'Weight (upright: -9.81)', unit: () => 'm/s\u00b2', least: -20, most: 20 },
    { name: 'ball-friction', label: 'Dry friction of the ball', unit: () => 'N', least: 1e-3, most: 100, log: true, zero: true },
    { name: 'base', label: 'The base accelerates', choices: { still: 'no', example: 'like a machine that starts up', samples: 'by samples' }, shown: (scene) => scene.drive !== 'base-file' },
    { name: 'base-acceleration-file', label: 'Acceleration of the base, one sample per step', samples: 'm/s\u00b2', shown: (scene) => baseOf(scene) === 'samples' },
  ] },
  { title: 'Start', values: [
    { name: 'x1', label: 'Main mass at x1', unit: () => 'm', least: -0.1, most: 0.1 },
    { name: 'v1', label: 'with the velocity v1', unit: () => 'm/s', least: -2, most: 2 },
    { name: 'x2', label: 'Ball at x2', unit: () => 'm', least: -0.1, most: 0.1 },
    { name: 'v2', label: 'with the velocity v2', unit: () => 'm/s', least: -2, most: 2 },
  ] },
  { title: 'Computation', values: [
    { name: 'newmark', label: 'Stepper', choices: { 'auto': "auto: the kernel's rule", 'moment': 'moment-fitted', 'moment-4': 'moment-fitted, 4 sub-steps', 'moment-8': 'moment-fitted, 8 sub-steps', 'moment-n': 'moment-fitted, as many sub-steps as required', 'energy': 'energy-consistent', 'impulsive': 'impulsive', 'average': "average acceleration (the paper's)", 'linear': 'linear acceleration', 'fox-goodwin': 'Fox-Goodwin', 'central': 'central difference' } },
    { name: 'numeric', label: 'Number format', choices: { 'fixed32': 'Fixed32', 'float32': 'Float32', 'float32-plain': 'Float32Plain', 'float64': 'Float64 (host)' } },
    { name: 'step', label: 'Step, h', unit: () => 's', least: 2e-6, most: 1e-2, log: true },
    { name: 'duration', label: 'Simulated time', unit: () => 's', least: 0.1, most: 20, log: true },
    { name: 'bounds', label: 'Bounds', choices: { found: 'found by a run in Float64', stated: 'stated' }, shown: (scene) => scene.numeric === 'fixed32' },
    { name: 'bound-displacement', label: 'Largest displacement', unit: () => 'm', least: 1e-3, most: 10, log: true, shown: statesBounds },
    { name: 'bound-speed', label: 'Largest speed', unit: () => 'm/s', least: 1e-2, most: 100, log: true, shown: statesBounds },
    { name: 'bound-penetration', label: 'Largest penetration', unit: () => 'm', least: 1e-6, most: 1, log: true, shown: statesBounds },
    { name: 'bound-force', label: 'Largest sample of the force', unit: () => 'N', least: 1e-3, most: 1e4, log: true, shown: (scene) => statesBounds(scene) && isSampled(scene) },
  ] },
];
export const values = groups.flatMap((group) => group.values);
const fileValues = values.filter(({ samples }) => samples);
export const valueNamed = (name) => values.find((value) => value.name === name);

function statesBounds(scene) { return scene.numeric === 'fixed32' && scene.bounds === 'stated'; }
export const isSampled = ({ drive }) => drive === 'drive-file' || drive === 'base-file';
// A base that moves by samples of its displacement does not accelerate as well.
export function baseOf({ drive, base }) { return drive === 'base-file' ? 'still' : base; }
export const isShown = (value, scene) => !value.shown || value.shown(scene);

// The kernel's defaults, and values that only the page has.
export function initialScene(kernel) {
  const ofThePage = {
    'damping-by': 'c1', 'impact-speed': 0.8, 'tension': 'clamp', 'stops': 'both', 'drive': 'sine', 'duration': 2,
    'bounds': 'found', 'bound-displacement': 0.1, 'bound-speed': 2, 'bound-penetration': 0.03, 'bound-force': 10,
    'base': 'still', 'drive-file': '', 'base-file': '', 'base-acceleration-file': '',
  };
  const scene = { ...ofThePage, ...kernel.defaultScene(), restitution: 0.68 };
  for (const { name, choices, samples } of values) if (!choices && !samples) scene[name] = Number(scene[name]);
  return scene;
}

// The paper's, tables 1 and 2.
export const usualDamping = { 'hooke-newton': 20.81, 'hertz': 0, 'hunt-crossley': 19560 };

// The options that the scene depends on, as [option, value] pairs. `files` makes the example's file.
const pageOnly = ['damping-by', 'bounds', 'base'];
export function optionsOf(scene, files) {
  const options = [];
  for (const value of values) {
    if (!isShown(value, scene) || pageOnly.includes(value.name) || (value.name === 'drive' && isSampled(scene))) continue;
    options.push([value.name, String(scene[value.name])]);
  }
  if (baseOf(scene) === 'example') options.push(['base-acceleration-file', files.example(scene.step, Math.round(scene.duration / scene.step))]);
  if (scene.law === 'hertz') options.push(['contact-damping', '0']);
  else if (scene['damping-by'] === 'paper') options.push(['paper-damping', 'yes']);
  else if (!['c1', 'restitution'].includes(scene['damping-by'])) options.push(['damping', scene['damping-by']]);
  return options;
}

// The options of the command, without the values that are impact-sim's defaults. The damping stays, because its default
// depends on the law, and so does the step, which impact-sim would choose. With a file the duration stays as well.
const toolDefaults = { duration: '1', tension: 'clamp', stops: 'both', drive: 'sine' };
const alwaysStated = ['contact-damping', 'restitution', 'step'];
export function argumentsOf(scene, initial, every, files) {
  const all = optionsOf(scene, files), stated = filesOf(all).length > 0 ? [...alwaysStated, 'duration'] : alwaysStated;
  const isDefault = (name, text) => !stated.includes(name) && text === (toolDefaults[name] ?? String(initial[name]));
  const options = all.filter(([name, text]) => !isDefault(name, text));
  return every > 1 ? [...options, ['every', String(every)]] : options;
}
// The files that options name.
export const filesOf = (options) => options.filter(([name]) => fileValues.some((value) => value.name === name)).map(([, file]) => file);
// The value of a requested file that has not been loaded yet.
export const missingFile = (scene) => fileValues.find((value) => isShown(value, scene) && scene[value.name] === '');
export const commandOf = (options) => ['impact-sim', ...options.map(([name, text]) => `--${name}=${text}`)].join(' ');

// Scenes to begin with: what differs from the paper's in run A, and in run B from A.
export const presets = {
  paper: { a: {}, b: null },
  stiff: { a: { 'contact-stiffness': 1e11, 'damping-by': 'restitution', 'clearance': 0.01 }, b: { newmark: 'average' } },
  laws: { a: { law: 'hunt-crossley' }, b: { law: 'hertz', 'contact-damping': 0 } },
  coarse: { a: { 'step': 1e-3, 'contact-stiffness': 1e8, 'damping-by': 'restitution' }, b: { newmark: 'average' } },
  upright: { a: { 'gravity': -9.81, 'x1': -9.81e-3, 'x2': -9.81e-3, 'drive': 'none', 'base': 'example' }, b: { 'ball-friction': 1 } },
  fixed: { a: { numeric: 'fixed32', duration: 1 }, b: { numeric: 'float32-plain' } },
};
