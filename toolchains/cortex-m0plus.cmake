set(IMPACT_TARGET cortex-m0plus)
set(IMPACT_CPU_FLAGS "-mcpu=cortex-m0plus")
include(${CMAKE_CURRENT_LIST_DIR}/cortex_m.cmake)
