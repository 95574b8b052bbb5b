# Builds the consumer beside the library in a new folder, WORK, and runs it. HOW is the way to the library:
#   find_package, pkg_config         installed into a folder
#   add_subdirectory, fetch_content  the sources; their archive
#   single_header                    what scripts/amalgamate writes
function(run)
    execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT code EQUAL 0)
        message(FATAL_ERROR "failed (${code}): ${ARGV}\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

set(consumer ${SOURCE}/tests/install/consumer)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/build)

# compile(NAME FLAGS...): without CMake, as one would at the prompt.
function(compile name)
    run(${COMPILER} -std=c++20 -Wall -Wextra -Werror ${consumer}/${name}.cpp -o ${WORK}/build/${name} ${ARGN})
endfunction()

if(HOW STREQUAL find_package OR HOW STREQUAL pkg_config)
    run(${CMAKE_COMMAND} --install ${BUILD} --component development --prefix ${WORK}/prefix)
    set(way -DCMAKE_PREFIX_PATH=${WORK}/prefix)
elseif(HOW STREQUAL add_subdirectory)
    set(way -DJAUSCAT_SOURCE=${SOURCE})
elseif(HOW STREQUAL fetch_content)
    run(${CMAKE_COMMAND} -E chdir ${SOURCE} ${CMAKE_COMMAND} -E tar czf ${WORK}/jauscat.tar.gz
        CMakeLists.txt LICENSE cmake include schemas)
    set(way -DJAUSCAT_ARCHIVE=${WORK}/jauscat.tar.gz)
endif()

if(HOW STREQUAL pkg_config)
    set(ENV{PKG_CONFIG_PATH} ${WORK}/prefix/share/pkgconfig)
    foreach(pair "jauscat codec_consumer" "jauscat-net net_consumer")
        separate_arguments(pair)
        list(POP_FRONT pair package name)
        run(pkg-config --cflags --libs ${package})
        separate_arguments(flags UNIX_COMMAND "${output}")
        compile(${name} ${flags})
    endforeach()
elseif(HOW STREQUAL single_header)
    # All that the consumer may include is one file, which has the name of the header that it asks for.
    run(${SOURCE}/scripts/amalgamate --output ${WORK}/jauscat/jauscat.hpp)
    compile(codec_consumer -I${WORK})
else()
    run(${CMAKE_COMMAND} -S ${consumer} -B ${WORK}/build -G ${GENERATOR}
        -DCMAKE_CXX_COMPILER=${COMPILER} -DJAUSCAT_HOW=${HOW} ${way})
    run(${CMAKE_COMMAND} --build ${WORK}/build)
endif()
run(${WORK}/build/codec_consumer)
if(NOT HOW STREQUAL single_header)
    run(${WORK}/build/net_consumer)
endif()
