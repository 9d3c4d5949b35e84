# Puts the page together: cmake -D FOLDER=... -D OUTPUT=... -D KERNEL=... -D TRAJECTORIES=... -D STEP_BUDGET=... -D PARTS=... -P page.cmake
# The modules become one script, in the order of their imports; KERNEL and TRAJECTORIES are base64 of gzip files.
# STEP_BUDGET may be absent.

set(script "")
foreach(module numbers samples kernel scene run plot plots machine sweep cost link self_test controls words presets main)
  file(READ ${FOLDER}/${module}.mjs text)
  string(REGEX REPLACE "(^|\n)import [^\n]*" "\\1" text "${text}")
  string(REGEX REPLACE "(^|\n)export (async |class |const |function )" "\\1\\2" text "${text}")
  string(APPEND script "// ${module}.mjs\n${text}")
endforeach()
file(READ ${FOLDER}/style.css style)
file(READ ${KERNEL} kernel)
file(READ ${TRAJECTORIES} trajectories)
set(step_budget "")
if(EXISTS ${STEP_BUDGET})
  file(READ ${STEP_BUDGET} step_budget)
endif()
# C++'s lists are JSON's with other brackets.
file(READ ${PARTS} parts)
string(REGEX REPLACE "//[^\n]*\n" "" parts "${parts}")
string(REGEX REPLACE ",\n$" "" parts "${parts}")
string(REPLACE "{" "[" parts "${parts}")
string(REPLACE "}" "]" parts "${parts}")
file(READ ${FOLDER}/page.html.in page)
foreach(part style script kernel trajectories step_budget parts)
  string(REPLACE "@${part}@" "${${part}}" page "${page}")
endforeach()
file(WRITE ${OUTPUT} "${page}")
