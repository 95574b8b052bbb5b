# jauscat_add_jsidl(TARGET FILES file... [NAMESPACE name] [CAPACITY capacity...]): writes the schema headers of JSIDL service
# definitions when TARGET is built, and lets TARGET include them as <NAME/set/service.hpp>, NAME being the namespace with
# / for ::. NAMESPACE is by default the target's name. CAPACITY is that of the lists, as jauscat-jsidl --capacity takes it:
# a number for all, or Message.List=number. The program is the target jauscat_jsidl where this repository is built with it, or
# the jauscat-jsidl that is installed; JAUSCAT_JSIDL names another one.
function(jauscat_add_jsidl target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "NAMESPACE" "FILES;CAPACITY")
    if(NOT arg_FILES OR arg_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "jauscat_add_jsidl: expected jauscat_add_jsidl(TARGET FILES file... [NAMESPACE name] [CAPACITY capacity...])")
    endif()
    if(NOT arg_NAMESPACE)
        string(MAKE_C_IDENTIFIER ${target} arg_NAMESPACE)
    endif()
    if(JAUSCAT_JSIDL)
        set(program ${JAUSCAT_JSIDL})
    elseif(TARGET jauscat_jsidl)
        set(program jauscat_jsidl)
    else()
        find_program(JAUSCAT_JSIDL jauscat-jsidl REQUIRED)
        set(program ${JAUSCAT_JSIDL})
    endif()
    string(REPLACE "::" "/" prefix ${arg_NAMESPACE})
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_jsidl)
    set(capacities)
    foreach(capacity IN LISTS arg_CAPACITY)
        list(APPEND capacities --capacity ${capacity})
    endforeach()
    set(files)
    foreach(file IN LISTS arg_FILES)
        get_filename_component(file ${file} ABSOLUTE)
        list(APPEND files ${file})
    endforeach()
    # Headers of services that are no longer defined must not remain.
    add_custom_command(OUTPUT ${folder}/written
        COMMAND ${CMAKE_COMMAND} -E rm -rf ${folder}/${prefix}
        COMMAND ${program} ${files} --namespace ${arg_NAMESPACE} --include-prefix ${prefix} ${capacities} --output ${folder}/${prefix}
        COMMAND ${CMAKE_COMMAND} -E touch ${folder}/written
        DEPENDS ${files} ${program}
        COMMENT "Writing schemas of ${target}" VERBATIM)
    add_custom_target(${target}_jsidl DEPENDS ${folder}/written)
    add_dependencies(${target} ${target}_jsidl)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "INTERFACE_LIBRARY")
        target_include_directories(${target} INTERFACE ${folder})
    else()
        target_include_directories(${target} PUBLIC ${folder})
    endif()
endfunction()
