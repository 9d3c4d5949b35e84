set(IMPACT_TARGET cortex-m7f)
set(IMPACT_CPU_FLAGS "-mcpu=cortex-m7 -mfpu=fpv5-sp-d16 -mfloat-abi=hard")
include(${CMAKE_CURRENT_LIST_DIR}/cortex_m.cmake)
