# gold links in half the time of GNU ld; where it is missing, the compiler's own linker does.
include(CheckLinkerFlag)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    check_linker_flag(CXX -fuse-ld=gold JAUSCAT_HAS_GOLD)
    if(JAUSCAT_HAS_GOLD)
        add_link_options(-fuse-ld=gold)
    endif()
endif()
