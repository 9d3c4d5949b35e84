# What the Cortex-M toolchain files share. Each sets IMPACT_TARGET and IMPACT_CPU_FLAGS, then includes this.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(IMPACT_CPU_FLAGS "-mthumb ${IMPACT_CPU_FLAGS}")
set(IMPACT_BOARD cortex_m)
include(${CMAKE_CURRENT_LIST_DIR}/freestanding.cmake)
