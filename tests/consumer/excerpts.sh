#!/bin/sh
# Excerpts in the README and the manual are in their files, word for word: excerpts.sh PROJECT
# An excerpt is a fenced block whose first line names a path: ```cpp kernel/examples/control_loop/main.cpp
set -eu
cd "$1"
awk '
  function check() {
    if (index(text, block) == 0) { print "not in " file ":\n" block; failed = 1 }
    ++excerpts
  }
  /^```/ && file { check(); file = ""; next }
  /^```[a-z]+ [^ ]+\/[^ ]+$/ { file = $2; block = text = ""; while ((getline line < file) > 0) text = text line "\n"; next }
  file { block = block $0 "\n" }
  END { print excerpts + 0 " excerpts"; exit failed || !excerpts }
' README.md kernel/README.md
