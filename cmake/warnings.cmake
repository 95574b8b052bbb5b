# Warnings of this repository's own programs. A consumer's build is left alone.
option(JAUSCAT_WARNINGS_AS_ERRORS "A warning in the library's own programs and tests fails the build" ON)
add_library(jauscat_warnings INTERFACE)
target_compile_options(jauscat_warnings INTERFACE
    -Wall -Wextra -Wconversion -Wshadow -Wpedantic $<$<BOOL:${JAUSCAT_WARNINGS_AS_ERRORS}>:-Werror>)
