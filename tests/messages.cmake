# jauscat_test_messages: all messages of the standard behind functions that are the same for each (schema/messages.hpp), for
# the tests of several modules. One translation unit for each subgroup, that is for each third digit of a command code.
foreach(digit IN ITEMS 0x0 0x1 0x2 0x4 0x6 0x8 0xA 0xB 0xD 0xE)
    configure_file(${CMAKE_CURRENT_LIST_DIR}/schema/message_group.cpp.in messages/message_group_${digit}.cpp @ONLY)
    list(APPEND message_groups ${CMAKE_CURRENT_BINARY_DIR}/messages/message_group_${digit}.cpp)
endforeach()

add_library(jauscat_test_messages STATIC EXCLUDE_FROM_ALL ${CMAKE_CURRENT_LIST_DIR}/schema/messages.cpp ${message_groups})
# All the codec of 158 messages, several times over: the time goes into optimising, and the tests gain nothing by it.
target_compile_options(jauscat_test_messages PRIVATE $<$<CONFIG:Release>:-O1>)
set_target_properties(jauscat_test_messages PROPERTIES UNITY_BUILD_BATCH_SIZE 4) # a gigabyte for each unit
# It names all groups: where it sees their template, it instantiates them.
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/schema/messages.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
target_link_libraries(jauscat_test_messages PUBLIC jauscat_test_main jauscat::catalogue)
if(TARGET jauscat::jauscat)
    target_link_libraries(jauscat_test_messages PUBLIC jauscat::jauscat)
endif()
