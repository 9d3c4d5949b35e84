set(IMPACT_TARGET cortex-m4f)
set(IMPACT_CPU_FLAGS "-mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard")
include(${CMAKE_CURRENT_LIST_DIR}/cortex_m.cmake)
