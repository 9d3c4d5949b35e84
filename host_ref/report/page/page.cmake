# Puts the page together: cmake -D FOLDER=... -D TEMPLATE=... -D OUTPUT=... -D HAS_EXPLORER=... -P page.cmake
# @NAME@ in the template stands for FOLDER/NAME.svg or NAME.html.
set(here ${CMAKE_CURRENT_LIST_DIR})
file(READ ${here}/style.css style)
file(READ ${here}/script.js script)

# Ink, grid and series take the page's colours, which follow its light or dark.
set(colours "rgb(  0, 114, 178)=blue" "rgb(213,  94,   0)=vermilion" "rgb(  0, 158, 115)=green"
  "rgb(230, 159,   0)=orange" "rgb(204, 121, 167)=purple" "rgb( 86, 180, 233)=sky" "rgb(128, 128, 128)=middle")
file(GLOB parts ${FOLDER}/*.svg ${FOLDER}/*.html)
foreach(part ${parts})
  get_filename_component(name ${part} NAME_WE)
  file(READ ${part} content)
  string(REGEX REPLACE "<\\?xml[^>]*\\?>" "" content "${content}")
  string(REGEX REPLACE "rgb\\( *0, *0, *0\\)" "black" content "${content}")
  string(REPLACE "rgb(190, 190, 190)" "gray" content "${content}")
  foreach(colour ${colours})
    string(REGEX MATCH "^(.*)=(.*)$" colour "${colour}")
    string(REPLACE "${CMAKE_MATCH_1}" "var(--${CMAKE_MATCH_2})" content "${content}")
  endforeach()
  string(REGEX REPLACE "<title>Gnuplot</title>|<title>gnuplot_plot_[0-9]*</title>|<desc>[^<]*</desc>" "" content "${content}")
  string(REGEX REPLACE "<g fill=\"none\"[^>]*>[\n\t ]*</g>\n" "" content "${content}")  # empty groups
  # A point's text, from gnuplot's hypertext to a title that needs no script.
  string(REGEX REPLACE
    "<g fill=\"none\"[^>]*>[\n\t ]*<g onmousemove=\"gnuplot_svg.showHypertext\\(evt,'([^']*)'\\)\"[^>]*><title> </title>[\n\t ]*<use ([^>]*) color='[^']*'/></g>[\n\t ]*</g>"
    "<g class=\"point\"><title>\\1</title><use \\2/></g>" content "${content}")
  string(REPLACE "frontier_" "Error against run time, the best of each kind: " label "${name}")
  string(REPLACE "error_vs_time_" "Error against run time, every method: " label "${label}")
  string(REPLACE "error_parts_" "Errors of method and rounding: " label "${label}")
  string(REGEX REPLACE "^stability_" "Restitution error over step and stiffness: " label "${label}")
  string(REPLACE "_" " " label "${label}")
  string(REPLACE "<svg " "<svg role=\"img\" aria-label=\"${label}\" " content "${content}")
  string(REPLACE "gpPt" "${name}-pt" content "${content}")  # ids are the page's own
  string(REPLACE "gpDot" "${name}-dot" content "${content}")
  string(REPLACE "gnuplot_plot_" "${name}-plot-" content "${content}")
  string(REPLACE "gnuplot_canvas" "${name}-canvas" content "${content}")
  set(${name} "${content}")
endforeach()

foreach(law hooke-newton hertz hunt-crossley)
  set(maps_${law} "")
  file(GLOB maps ${FOLDER}/stability_${law}_*.svg)
  foreach(map ${maps})
    get_filename_component(name ${map} NAME_WE)
    if(NOT name MATCHES "^stability_hunt-crossley_(auto|average|textbook-rk4)_float64$")  # shown before
      string(APPEND maps_${law} "<figure>${${name}}</figure>\n")
    endif()
  endforeach()
endforeach()
set(other_frontiers "")
foreach(law Hertz Hooke-Newton)
  string(TOLOWER ${law} name)
  foreach(target cortex-m4f cortex-m3 host)
    string(APPEND other_frontiers "<figure class=\"best\">${frontier_${name}_${target}}<figcaption>${law}, ${target}</figcaption></figure>\n"
      "<figure class=\"all\">${error_vs_time_${name}_${target}}<figcaption>${law}, ${target}</figcaption></figure>\n")
  endforeach()
endforeach()
set(coupled_picture "")
if(DEFINED coupled_scenes)
  set(coupled_picture "<figure>${coupled_scenes}<figcaption>Dashed: the hundredth of a scene's energy, over up to some hundred contacts, above which the tests fail, two of a moment-fitted stepper that is named; in Fixed32 they also allow what it rounds, in the places of its units, which follow from the bounds and not from what a scene has. What is beyond 1000 stands at the edge; a point says what it is.</figcaption></figure>")
endif()
set(explorer_link "")
if(HAS_EXPLORER)
  set(explorer_link "<p><a class=\"explorer\" href=\"explorer.html\">Move the sliders: the kernel itself, running in this browser</a></p>")
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
