#!/bin/sh
# Writes the files that the READMEs show into a folder: from_readme.sh PROJECT FOLDER
# A file is a fenced block whose first line names it: ```cpp main.cpp
set -eu
mkdir -p "$2"
awk -v folder="$2" '
  /^```/ && file { close(file); file = ""; next }
  /^```[a-z]+ [A-Za-z0-9_.]+$/ { file = folder "/" $2; printf "" > file; next }
  file { print > file }
' "$1/README.md" "$1/kernel/README.md" "$1/host_ref/README.md"
