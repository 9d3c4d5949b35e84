// Cycles of the steps that step_cost.cpp measures, on an emulated RP2040: rp2040_cycles.js STEP_COST_IMAGE
//
// Runs the same image in rp2040js (npm; found through NODE_PATH), one instruction at a time. A counter of cycles takes
// the place of SysTick. Prints step_cost's rows, with the target rp2040. Fails unless every configuration has made
// 11000 steps, or if a step takes fewer cycles than instructions.
//
// The count runs from the first instruction of the step to its return, by rp2040js's table of the Cortex-M0+. An
// instruction takes 1 cycle, MULS too, since the RP2040 has the single-cycle multiplier. A load, a store, a taken
// branch, BX and BLX take 2, and BL takes 3. LDM, STM, PUSH and POP of N registers take 1 + N, and a POP with PC 3 + N.
// Its N omits LR and PC, which Arm's counts, so each PUSH with LR and each POP with PC is one cycle short.
//
// Wait states are not counted. The image is at 0, as on the other emulated boards, in a memory without delay, like the
// RP2040's RAM. Code in its flash also waits when the cache misses. Interrupts, DMA and the other core, which share the
// bus, are not counted either.
"use strict";
const fs = require("fs");

let RP2040;
try {
  ({ RP2040 } = require("rp2040js"));
} catch (error) {
  if (error.code !== "MODULE_NOT_FOUND") throw error;
  console.log("skipped: no module rp2040js; npm install it in a folder, and name its node_modules in NODE_PATH");
  process.exit(77);
}

const chip = new RP2040();
const core = chip.core;

// The image, by its ELF program headers, at the address of rp2040js's boot ROM.
const memory = new Uint8Array(256 * 1024);
chip.bootrom = new Uint32Array(memory.buffer);
const elf = fs.readFileSync(process.argv[2]);
const headers = elf.readUInt32LE(28), size = elf.readUInt16LE(42), count = elf.readUInt16LE(44);
for (let header = headers; header < headers + count * size; header += size) {
  const [type, offset, , address, bytes] = [0, 4, 8, 12, 16].map((field) => elf.readUInt32LE(header + field));
  if (type === 1) memory.set(elf.subarray(offset, offset + bytes), address);
}

// instruction_counter.cpp reads SysTick before and after a step, divides by 16.384 ticks per instruction, and subtracts
// 2: the first reading and the call, which are 2 cycles each.
const top = 0xffffff;
let instructions = 0, begin = null, steps = 0;
chip.ppb.readUint32 = (offset) => {
  if (offset !== 0x18) throw new Error(`read of system register ${offset.toString(16)}`);
  if (begin === null) {
    begin = { cycles: core.cycles, instructions };
    return top;
  }
  const cycles = core.cycles - begin.cycles - 4, executed = instructions - begin.instructions - 2;
  begin = null;
  ++steps;
  if (cycles < executed) throw new Error(`step ${steps}: ${cycles} cycles for ${executed} instructions`);
  return top - Math.round((cycles + 2) * 16.384);
};

// Semihosting, as in console.cpp.
function string_at(address) {
  let string = "";
  for (let byte; (byte = chip.readUint8(address)) !== 0; ++address) string += String.fromCharCode(byte);
  return string;
}
let text = "", exit_code = null;
chip.onBreak = () => {
  const [operation, argument] = core.registers;
  if (operation === 0x04) text += string_at(argument);
  else exit_code = chip.readUint32(argument + 4);
};

core.reset();
for (; exit_code === null; ++instructions) core.executeInstruction();

console.log(text.trimEnd().replace(/instructions/g, "cycles").replace(/^cortex-m0/gm, "rp2040"));
const configurations = (text.match(/,free,/g) || []).length;
if (configurations === 0 || steps !== 11000 * configurations) {
  console.log(`${steps} steps of ${configurations} configurations`);
  exit_code = 1;
}
process.exitCode = exit_code;
