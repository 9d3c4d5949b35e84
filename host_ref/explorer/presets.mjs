// Scenes to begin with: what differs from the paper's in run A, and in run B from A.

export const presets = {
  paper: { a: {}, b: null },
  stiff: { a: { 'contact-stiffness': 1e11, 'damping-by': 'restitution', 'clearance': 0.01 }, b: { newmark: 'average' } },
  laws: { a: { law: 'hunt-crossley' }, b: { law: 'hertz', 'contact-damping': 0 } },
  coarse: { a: { 'step': 1e-3, 'contact-stiffness': 1e8, 'damping-by': 'restitution' }, b: { newmark: 'average' } },
  upright: { a: { 'gravity': -9.81, 'x1': -9.81e-3, 'x2': -9.81e-3, 'drive': 'none', 'base': 'example' }, b: { 'ball-friction': 1 } },
  fixed: { a: { numeric: 'fixed32', duration: 1 }, b: { numeric: 'float32-plain' } },
};
