# Warnings of this repository's own programs. A consumer's build is left alone.
option(JAUSCAT_WARNINGS_AS_ERRORS "A warning in the library's own programs and tests fails the build" ON)
add_library(jauscat_warnings INTERFACE)
target_compile_options(jauscat_warnings INTERFACE
    -Wall -Wextra -Wconversion -Wshadow -Wpedantic $<$<BOOL:${JAUSCAT_WARNINGS_AS_ERRORS}>:-Werror>)
# At -O3, CMake's own choice for Release, g++ 12 takes the value of an empty std::optional that is copied for one that is read.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}" MATCHES "-O3")
    target_compile_options(jauscat_warnings INTERFACE -Wno-maybe-uninitialized)
endif()
