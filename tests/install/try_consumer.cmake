# Builds the consumer beside the library in a new folder, WORK, and runs it. HOW is the way to the library:
#   find_package, pkg_config         installed into a folder
#   compiled_library                 installed with its compiled libraries
#   add_subdirectory, fetch_content  the sources; their archive
#   single_header                    what scripts/amalgamate writes
function(run)
    execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${WORK}/build
        RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT code EQUAL 0)
        message(FATAL_ERROR "failed (${code}): ${ARGV}\n${output}")
    endif()
endfunction()

set(consumer ${SOURCE}/tests/install/consumer)
set(programs codec_consumer text_consumer esi_consumer net_consumer)
if(HOW STREQUAL fetch_content)
    set(programs net_consumer) # the rest is that of add_subdirectory
elseif(HOW STREQUAL single_header)
    set(programs codec_consumer)
elseif(HOW STREQUAL compiled_library)
    set(programs catalogue_consumer sae_consumer compiled_consumer)
endif()
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/build)

if(HOW STREQUAL find_package OR HOW STREQUAL pkg_config)
    run(${CMAKE_COMMAND} --install ${BUILD} --component development --prefix ${WORK}/prefix)
    set(way -DCMAKE_PREFIX_PATH=${WORK}/prefix)
    if(HOW STREQUAL find_package)
        list(APPEND way -DJAUSCAT_BUILT=${COMPILED} -DJAUSCAT_BUILT_CATALOGUE=${CATALOGUE}
            -DJAUSCAT_BUILT_SAE_CATALOGUE=${SAE_CATALOGUE})
    endif()
elseif(HOW STREQUAL compiled_library)
    foreach(component development compiled)
        run(${CMAKE_COMMAND} --install ${BUILD} --component ${component} --prefix ${WORK}/prefix)
    endforeach()
    set(way -DCMAKE_PREFIX_PATH=${WORK}/prefix)
elseif(HOW STREQUAL add_subdirectory)
    set(way -DJAUSCAT_SOURCE=${SOURCE})
elseif(HOW STREQUAL fetch_content)
    run(${CMAKE_COMMAND} -E chdir ${SOURCE} ${CMAKE_COMMAND} -E tar czf ${WORK}/jauscat.tar.gz
        CMakeLists.txt LICENSE cmake include schemas src)
    set(way -DJAUSCAT_ARCHIVE=${WORK}/jauscat.tar.gz)
endif()

if(HOW STREQUAL single_header)
    # All that the consumer may include is one file, which has the name of the header that it asks for.
    run(${SOURCE}/scripts/amalgamate --output ${WORK}/jauscat/wire/wire.hpp)
    run(${COMPILER} -std=c++20 -Wall -Wextra -Werror -I${WORK} ${consumer}/codec_consumer.cpp -o codec_consumer)
elseif(HOW STREQUAL pkg_config)
    set(ENV{PKG_CONFIG_PATH} ${WORK}/prefix/share/pkgconfig)
    run(${consumer}/with_pkg_config.sh ${consumer})
else()
    run(${CMAKE_COMMAND} -S ${consumer} -B . -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} -DJAUSCAT_HOW=${HOW} ${way})
    run(${CMAKE_COMMAND} --build . --target version_consumer ${programs})
    run(${WORK}/build/version_consumer)
endif()
if(HOW STREQUAL compiled_library)
    # Nothing of the library is compiled, and pkg-config has it, too.
    file(GLOB_RECURSE compiled ${WORK}/build/*jauscat_compiled*.o ${WORK}/build/*jauscat_catalogue*.o)
    if(compiled)
        message(FATAL_ERROR "The consumer compiles what is installed: ${compiled}")
    endif()
    set(ENV{PKG_CONFIG_PATH} ${WORK}/prefix/share/pkgconfig)
    run(${consumer}/with_pkg_config.sh ${consumer} compiled)
endif()
if(HOW STREQUAL find_package)
    # Of the sources of jauscat::compiled and of the catalogues the consumer compiles one each. All are installed as they
    # are here.
    file(GLOB_RECURSE sources RELATIVE ${SOURCE}/src ${SOURCE}/src/*.cpp)
    foreach(source IN LISTS sources)
        run(${CMAKE_COMMAND} -E compare_files ${SOURCE}/src/${source} ${WORK}/prefix/share/jauscat/src/${source})
    endforeach()
    run(${CMAKE_COMMAND} --build . --target installed_sources catalogue_consumer sae_consumer compiled_consumer
        header_only_consumer)
    run(${WORK}/build/catalogue_consumer)
    run(${WORK}/build/sae_consumer)
    run(${WORK}/build/compiled_consumer)
    run(${WORK}/build/header_only_consumer)
    # A program that mixes both ways does not link, and the linker names the class.
    execute_process(COMMAND ${CMAKE_COMMAND} --build . --target mixed_consumer WORKING_DIRECTORY ${WORK}/build
        RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(code EQUAL 0 OR NOT output MATCHES "undefined reference to .*jauscat::(header_only|compiled_once)::node")
        message(FATAL_ERROR "A program of both ways links, or for another reason does not:\n${output}")
    endif()
endif()
foreach(program IN LISTS programs)
    run(${WORK}/build/${program})
endforeach()
