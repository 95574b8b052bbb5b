# The target jauscat::catalogue: jauscat::text, and the messages of the standard compiled once, by the project that uses it.
# SOURCES is the folder of src/. JAUSCAT_CATALOGUE_SUBGROUPS, a list such as "core;platform", leaves the other subgroups out.
function(jauscat_add_catalogue sources text)
    if(JAUSCAT_CATALOGUE_SUBGROUPS)
        list(TRANSFORM JAUSCAT_CATALOGUE_SUBGROUPS REPLACE "(.+)" "${sources}/catalogue/\\1.cpp" OUTPUT_VARIABLE files)
        list(APPEND files ${sources}/catalogue/ra_3_3.cpp)
        list(JOIN JAUSCAT_CATALOGUE_SUBGROUPS "()," calls)
        set_source_files_properties(${sources}/catalogue/ra_3_3.cpp PROPERTIES
            COMPILE_DEFINITIONS "JAUSCAT_CATALOGUE_SUBGROUPS=${calls}()")
    else()
        file(GLOB files ${sources}/catalogue/*.cpp)
    endif()
    add_library(jauscat_catalogue STATIC EXCLUDE_FROM_ALL ${files})
    add_library(jauscat::catalogue ALIAS jauscat_catalogue)
    set_target_properties(jauscat_catalogue PROPERTIES UNITY_BUILD_BATCH_SIZE 11)
    # Half the compiler's time of -O3, and fast enough for programs that people look at.
    target_compile_options(jauscat_catalogue PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O1>)
    target_link_libraries(jauscat_catalogue PUBLIC ${text})
endfunction()

# The target jauscat::catalogue_sae: the same for the messages of SAE services.
function(jauscat_add_sae_catalogue sources text)
    file(GLOB files ${sources}/catalogue/sae/*.cpp)
    add_library(jauscat_catalogue_sae STATIC EXCLUDE_FROM_ALL ${files})
    add_library(jauscat::catalogue_sae ALIAS jauscat_catalogue_sae)
    set_target_properties(jauscat_catalogue_sae PROPERTIES UNITY_BUILD OFF) # half a gigabyte or more for each source
    target_compile_options(jauscat_catalogue_sae PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O1>)
    target_link_libraries(jauscat_catalogue_sae PUBLIC ${text})
endfunction()
