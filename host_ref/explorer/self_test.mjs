// The golden trajectories in WebAssembly: tests/target/trajectory_test.cpp, the program that runs on every emulated
// target, with a console that keeps its lines. Each trajectory prints {"label", hash, digits}, and a line that begins
// with # where it differs from the golden value.

export async function runTrajectories(bytes) {
  let text = '', memory = null;
  const print = (address) => {
    const rest = new Uint8Array(memory.buffer, address);
    text += new TextDecoder().decode(rest.subarray(0, rest.indexOf(0)));
  };
  const print_number = (number) => { text += String(number >>> 0); };
  const print_hexadecimal = (number) => { text += BigInt.asUintN(64, number).toString(16).padStart(16, '0'); };
  const { instance } = await WebAssembly.instantiate(bytes, { console: { print, print_number, print_hexadecimal } });
  memory = instance.exports.memory;
  const status = instance.exports.run();
  return { status, text };
}

// How many trajectories were as golden, of how many.
export function verdictOf(text) {
  const lines = text.split('\n'), count = lines.filter((line) => line.startsWith('{"')).length;
  const differing = lines.filter((line) => line.startsWith('# no golden') || line.startsWith('# differs')).length;
  return { passed: count - differing, count };
}
