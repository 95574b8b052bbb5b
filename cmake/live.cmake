# The target jauscat::live: the live view of programs (docs/live.md), with Boost.Beast, compiled once, by the project that uses it.
# SOURCES is the folder of src/, PAGE that of page.html, page.css, page.js and live.js, CATALOGUE a target of jauscat::catalogue.
set(JAUSCAT_LIVE_PAGE_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/live_page.cmake)
function(jauscat_add_live sources page catalogue)
    set(made ${CMAKE_CURRENT_BINARY_DIR}/live_page.cpp)
    add_custom_command(OUTPUT ${made}
        COMMAND ${CMAKE_COMMAND} -DFOLDER=${page} -DOUTPUT=${made} -P ${JAUSCAT_LIVE_PAGE_SCRIPT}
        DEPENDS ${page}/page.html ${page}/page.css ${page}/page.js ${page}/live.js
            ${JAUSCAT_LIVE_PAGE_SCRIPT}
        VERBATIM)
    # Alone: a unity source would not wait until it is made.
    set_source_files_properties(${made} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    file(GLOB files ${sources}/live/*.cpp)
    add_library(jauscat_live STATIC EXCLUDE_FROM_ALL ${files} ${made})
    add_library(jauscat::live ALIAS jauscat_live)
    target_compile_options(jauscat_live PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O1>)
    target_link_libraries(jauscat_live PUBLIC ${catalogue} Threads::Threads PRIVATE nlohmann_json::nlohmann_json)
endfunction()
