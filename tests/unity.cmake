# Where CMAKE_UNITY_BUILD is on, several sources of a test program are compiled as one: most of the time goes into reading
# headers and into templates that all of them instantiate. Each source is then in a namespace of its own, after the headers
# of all, so that names in one do not meet those in another. A source that specialises templates, or includes headers on a
# condition, stays alone.
function(jauscat_unity target)
    if(CMAKE_UNITY_BUILD)
        cmake_language(EVAL CODE "cmake_language(DEFER CALL jauscat_unity_sources ${target})") # when it has all its sources
    endif()
endfunction()

function(jauscat_unity_sources target)
    get_target_property(sources ${target} SOURCES)
    set(headers "#pragma once")
    foreach(source IN LISTS sources)
        set(path ${source})
        cmake_path(ABSOLUTE_PATH path)
        file(STRINGS ${path} alone REGEX "^template <.*> struct jauscat::|^# +include ")
        if(NOT source MATCHES "_test[.]cpp$" OR alone)
            set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
            continue()
        endif()
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
        file(STRINGS ${path} includes REGEX "^#include ")
        foreach(include IN LISTS includes)
            string(REGEX MATCH "\"(.+)\"" quoted "${include}")
            if(quoted AND EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${CMAKE_MATCH_1})
                set(include "#include \"${CMAKE_CURRENT_SOURCE_DIR}/${CMAKE_MATCH_1}\"")
            endif()
            list(APPEND headers ${include})
        endforeach()
    endforeach()
    list(REMOVE_DUPLICATES headers)
    list(JOIN headers "\n" headers)
    set(all_headers ${CMAKE_CURRENT_BINARY_DIR}/${target}_headers.hpp)
    file(CONFIGURE OUTPUT ${all_headers} CONTENT "${headers}\n" @ONLY)
    set_target_properties(${target} PROPERTIES
        UNITY_BUILD_UNIQUE_ID JAUSCAT_SOURCE
        UNITY_BUILD_CODE_BEFORE_INCLUDE "#include \"${all_headers}\"\nnamespace JAUSCAT_SOURCE {"
        UNITY_BUILD_CODE_AFTER_INCLUDE "}")
endfunction()
