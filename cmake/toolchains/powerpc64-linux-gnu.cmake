# 64-bit PowerPC, big-endian: Linux programs, linked statically so that the emulator needs no system of the target's.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR ppc64)
set(CMAKE_CXX_COMPILER powerpc64-linux-gnu-g++)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-ppc64-static)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
