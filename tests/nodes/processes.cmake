# test_processes: starts programs and waits for what they print, for the tests of nodes and of jauscat-ecat.
include_guard(GLOBAL)
add_library(test_processes STATIC EXCLUDE_FROM_ALL ${CMAKE_CURRENT_LIST_DIR}/program.cpp)
target_link_libraries(test_processes PUBLIC jauscat_test_main jauscat::jauscat Boost::filesystem Threads::Threads
    nlohmann_json::nlohmann_json)
target_compile_options(test_processes PRIVATE $<$<CONFIG:Release>:-O0>)
