# For the tests in shell, which read this file. $folder is the test's own, removed in the end.
set -eu
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

# needs TOOL...: the test is skipped if one is not installed.
needs() {
  for tool; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed" && exit 77; }
  done
}
