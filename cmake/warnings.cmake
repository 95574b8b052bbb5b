# Warnings of this repository's own programs. A consumer's build is left alone.
add_library(jauscat_warnings INTERFACE)
target_compile_options(jauscat_warnings INTERFACE
    -Wall -Wextra -Wconversion -Wshadow -Wpedantic -Werror)
