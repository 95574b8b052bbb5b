# The target jauscat::compiled: jauscat::net, and what of it is no template compiled once, by the project that uses it.
# SOURCES is the folder of src/. JAUSCAT_COMPILED_WITHOUT, a list such as "jsidl;sae_links", leaves sources out that no program of a
# build uses. Users of the target have JAUSCAT_SEPARATE_COMPILATION defined.
function(jauscat_add_compiled sources net)
    file(GLOB files ${sources}/*.cpp)
    foreach(source IN LISTS JAUSCAT_COMPILED_WITHOUT)
        list(REMOVE_ITEM files ${sources}/${source}.cpp)
    endforeach()
    add_library(jauscat_compiled STATIC EXCLUDE_FROM_ALL ${files})
    add_library(jauscat::compiled ALIAS jauscat_compiled)
    if(CMAKE_UNITY_BUILD)
        # Half the time of a unit for each source, and a gigabyte for each of these (memory.cmake has more).
        set(JAUSCAT_COMPILED_BATCH_SIZE 6 CACHE STRING "Sources of jauscat::compiled that are compiled as one unit")
        set_target_properties(jauscat_compiled PROPERTIES UNITY_BUILD_BATCH_SIZE ${JAUSCAT_COMPILED_BATCH_SIZE})
    else()
        # g++ frees memory earlier, as it does on a machine with little of it: half a gigabyte for the largest sources.
        target_compile_options(jauscat_compiled PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=30>)
    endif()
    target_compile_definitions(jauscat_compiled PUBLIC JAUSCAT_SEPARATE_COMPILATION)
    target_link_libraries(jauscat_compiled PUBLIC ${net})
endfunction()
