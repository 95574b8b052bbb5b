# Units of several sources need up to 4 GB, and g++ spends a fifth of its time on garbage collection, which then begins at an
# eighth of the machine's memory. Rounded, so that the options, by which the compiler cache finds a unit, stay the same.
cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY) # MiB
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND memory GREATER 4095)
    math(EXPR heap_size "${memory} / 4096 * 4096 * 1024 / 8") # KiB
    add_compile_options(--param=ggc-min-heapsize=${heap_size})
endif()
if(memory GREATER 14000)
    set(JAUSCAT_COMPILED_BATCH_SIZE 14 CACHE STRING "Sources of jauscat::compiled that are compiled as one unit")
endif()
