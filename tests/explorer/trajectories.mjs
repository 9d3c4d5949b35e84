// Runs the golden trajectories in WebAssembly under node: trajectories.mjs FOLDER_OF_EXPLORER MODULE.wasm
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const [folder, module] = process.argv.slice(2);
const { runTrajectories, verdictOf } = await import(pathToFileURL(`${folder}/self_test.mjs`));
const { status, text } = await runTrajectories(readFileSync(module));
const { passed, count } = verdictOf(text);
console.log(text.split('\n').filter((line) => line.startsWith('#')).join('\n'));
console.log(`${passed} of ${count} trajectories have the golden bits`);
process.exit(status === 0 && count > 0 && passed === count ? 0 : 1);
