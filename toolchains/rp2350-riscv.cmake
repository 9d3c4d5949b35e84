# Without Zbs, with which GCC 12 breaks off with an internal error.
set(IMPACT_TARGET rp2350-riscv)
set(IMPACT_CPU_FLAGS "-march=rv32imac_zba_zbb -mabi=ilp32")
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(IMPACT_BOARD rv32)
include(${CMAKE_CURRENT_LIST_DIR}/freestanding.cmake)
# GCC 12 has no libgcc of its own for the extensions: that of rv32imac is linked.
string(APPEND CMAKE_EXE_LINKER_FLAGS_INIT " -march=rv32imac")
