// Prints the result of each check, and sets the exit code in the end.
let failures = 0;

export function check(holds, what) {
  console.log(`${holds ? 'ok    ' : 'FAILED'} ${what}`);
  if (!holds) ++failures;
}

export function finish() {
  console.log(failures === 0 ? 'all is well' : `${failures} failures`);
  process.exit(failures === 0 ? 0 : 1);
}
