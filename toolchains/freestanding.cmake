# What every target shares: no operating system, no start-up files, no library but the compiler's own.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_EXECUTABLE_SUFFIX_CXX .elf)
set(CMAKE_CXX_FLAGS_INIT "${IMPACT_CPU_FLAGS} -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics \
-fno-unwind-tables -fno-asynchronous-unwind-tables -ffunction-sections -fdata-sections -fno-schedule-insns")
set(CMAKE_CXX_FLAGS_RELEASE "-O2" CACHE STRING "An image is built as firmware usually is")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -Wl,--gc-sections -Wl,--fatal-warnings")
set(CMAKE_CROSSCOMPILING_EMULATOR sh ${CMAKE_CURRENT_LIST_DIR}/emulate.sh ${IMPACT_TARGET})
