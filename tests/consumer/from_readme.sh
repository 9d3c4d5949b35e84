#!/bin/sh
# Writes the files that the README and the kernel's manual show into a folder: from_readme.sh PROJECT FOLDER
# A file is a fenced block whose first line names it: ```cpp main.cpp
set -eu
awk -v folder="$2" '
  /^```/ && file { close(file); file = ""; next }
  /^```[a-z]+ [A-Za-z0-9_.]+$/ { file = folder "/" $2; printf "" > file; next }
  file { print > file }
' "$1/README.md" "$1/kernel/README.md"
