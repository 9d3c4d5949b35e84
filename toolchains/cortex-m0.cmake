set(IMPACT_TARGET cortex-m0)
set(IMPACT_CPU_FLAGS "-mcpu=cortex-m0")
include(${CMAKE_CURRENT_LIST_DIR}/cortex_m.cmake)
