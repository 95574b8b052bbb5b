# cmake -DDOC=manual.md -DFILE=program.cpp -P same_text.cmake: the manual has the file's text, whole and unchanged.
file(READ ${DOC} doc)
file(READ ${FILE} text)
string(FIND "${doc}" "\n${text}```" at)
if(at EQUAL -1)
    message(FATAL_ERROR "${DOC} does not have ${FILE} as it is: copy it there between two lines of ```")
endif()
