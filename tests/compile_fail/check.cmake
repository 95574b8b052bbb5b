# Compiles SOURCE with COMPILER and the options in the file OPTIONS, and checks that the outcome is EXPECT, by default what
# its first line says. A second line "// and: text" says what else the compiler must say. PRECOMPILED is the header that
# SOURCE includes first; its precompiled form is beside it.
if(NOT DEFINED EXPECT)
    file(STRINGS ${SOURCE} first_line LIMIT_COUNT 1)
    if(NOT first_line MATCHES "^// expect: (.+)$")
        message(FATAL_ERROR "${SOURCE} does not begin with '// expect: '")
    endif()
    string(REPLACE "\\;" ";" EXPECT "${CMAKE_MATCH_1}") # file(STRINGS) protects semicolons
    file(STRINGS ${SOURCE} ALSO REGEX "^// and: ")
    string(REPLACE "// and: " "" ALSO "${ALSO}")
endif()

if(DEFINED PRECOMPILED)
    set(first -include ${PRECOMPILED})
endif()
execute_process(COMMAND ${COMPILER} -fsyntax-only @${OPTIONS} ${first} ${SOURCE}
                RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)

string(FIND "${output}" "${EXPECT}" at)
if(EXPECT STREQUAL "no error")
    if(NOT code EQUAL 0)
        message(FATAL_ERROR "Must compile, but does not.\n ${SOURCE}\n${output}")
    endif()
elseif(code EQUAL 0)
    message(FATAL_ERROR "Must not compile, but does.\n ${SOURCE}")
elseif(at EQUAL -1)
    message(FATAL_ERROR "Refused, but for another reason.\n ${SOURCE}\n expected: ${EXPECT}\n${output}")
elseif(ALSO)
    string(FIND "${output}" "${ALSO}" at)
    if(at EQUAL -1)
        message(FATAL_ERROR "Refused, but without a word of ${ALSO}.\n ${SOURCE}\n${output}")
    endif()
endif()
