set(IMPACT_TARGET cortex-m3)
set(IMPACT_CPU_FLAGS "-mcpu=cortex-m3")
include(${CMAKE_CURRENT_LIST_DIR}/cortex_m.cmake)
