# JAUSCAT_VERSION as include/jauscat/version.hpp has it.
set(JAUSCAT_VERSION)
foreach(part MAJOR MINOR PATCH)
    file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/../include/jauscat/version.hpp line REGEX "^#define JAUSCAT_VERSION_${part} [0-9]+$")
    string(REGEX MATCH "[0-9]+$" number "${line}")
    list(APPEND JAUSCAT_VERSION ${number})
endforeach()
list(JOIN JAUSCAT_VERSION . JAUSCAT_VERSION)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS include/jauscat/version.hpp)
