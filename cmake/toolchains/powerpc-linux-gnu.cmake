# PowerPC, big-endian with 32 bits: Linux programs, linked statically so that the emulator needs no system of the target's.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR ppc)
set(CMAKE_CXX_COMPILER powerpc-linux-gnu-g++)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-ppc-static)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
