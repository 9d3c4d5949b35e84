# SPDX-License-Identifier: MIT
# impact_c_library(NAME RIG_HEADER [FLOAT] [SAMPLED] [BASE] [CONTACT_FORCE] [SNAPSHOTS]): a static library of one scene for C, see impact_c.h.
# Link NAME to a target of C sources: it carries the include path and the definitions. For the C compiler as the linker give
# that target LINKER_LANGUAGE C.
set(IMPACT_C_FOLDER ${CMAKE_CURRENT_LIST_DIR})
function(impact_c_library name rig)
  set(words FLOAT SAMPLED BASE CONTACT_FORCE SNAPSHOTS)
  cmake_parse_arguments(PARSE_ARGV 2 rig_has "${words}" "" "")
  if(rig_has_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "impact_c_library(${name}): unknown: ${rig_has_UNPARSED_ARGUMENTS}. Known: ${words}")
  endif()
  get_filename_component(rig ${rig} ABSOLUTE)
  add_library(${name} STATIC ${IMPACT_C_FOLDER}/impact_c.cpp)
  target_include_directories(${name} PUBLIC ${IMPACT_C_FOLDER})
  target_compile_definitions(${name} PRIVATE IMPACT_C_RIG="${rig}")
  foreach(what ${words})
    if(rig_has_${what})
      target_compile_definitions(${name} PUBLIC IMPACT_C_${what})
    endif()
  endforeach()
  target_link_libraries(${name} PRIVATE impact::kernel)
  target_compile_options(${name} PRIVATE -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffunction-sections)
endfunction()
