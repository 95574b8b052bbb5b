# Installs the library into a new folder (HOW find_package), builds the consumer beside it and runs it.
function(run)
    execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT code EQUAL 0)
        message(FATAL_ERROR "failed (${code}): ${ARGV}\n${output}")
    endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
set(way -DJAUSCAT_SOURCE=${SOURCE})
if(HOW STREQUAL find_package)
    run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
    set(way -DCMAKE_PREFIX_PATH=${WORK}/prefix)
endif()
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/install/consumer -B ${WORK}/build -G ${GENERATOR}
    -DCMAKE_CXX_COMPILER=${COMPILER} ${way})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/codec_consumer)
run(${WORK}/build/net_consumer)
