// Scenes to begin with: what differs from the paper's in run A, and in run B from A.

export const presets = {
  paper: { a: {}, b: null },
  stiff: { a: { 'contact-stiffness': 1e11, 'damping-by': 'restitution', 'clearance': 0.01 }, b: { newmark: 'average' } },
  laws: { a: { law: 'hunt-crossley' }, b: { law: 'hertz', 'contact-damping': 0 } },
  coarse: { a: { 'step': 1e-3, 'contact-stiffness': 1e8, 'damping-by': 'restitution' }, b: { newmark: 'average' } },
  fixed: { a: { numeric: 'fixed32', duration: 1 }, b: { numeric: 'float32-plain' } },
};
