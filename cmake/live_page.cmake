# cmake -DFOLDER=tools/web -DOUTPUT=page.cpp -P live_page.cmake: a source with page.html, page.css, page.js and live.js as one page,
# without the module of WebAssembly.
file(READ ${FOLDER}/page.html page)
foreach(mark page.css module page.js live.js)
    set(content)
    if(NOT mark STREQUAL "module")
        file(READ ${FOLDER}/${mark} content)
    endif()
    string(FIND "${page}" "/* ${mark} */" first)
    string(FIND "${page}" "/* ${mark} */" last REVERSE)
    if(first EQUAL -1 OR NOT first EQUAL last)
        message(FATAL_ERROR "page.html has not one place for /* ${mark} */")
    endif()
    string(REPLACE "/* ${mark} */" "${content}" page "${page}")
endforeach()
# As numbers, in lines: a compiler may take no more than 64 KiB in one literal.
file(WRITE ${OUTPUT}.html "${page}")
file(READ ${OUTPUT}.html bytes HEX)
file(REMOVE ${OUTPUT}.html)
string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE ${OUTPUT} "// Made by cmake/live_page.cmake.
#include <string_view>

namespace jauscat::net::live {

static constexpr unsigned char bytes[] = {
${bytes}};

[[nodiscard]] std::string_view page() noexcept { return {reinterpret_cast<const char*>(bytes), sizeof bytes}; }

} // namespace jauscat::net::live
")
