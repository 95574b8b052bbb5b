# The target jauscat::catalogue: jauscat::text, and the messages of the standard compiled once, by the project that uses it.
# SOURCES is the folder of src/.
function(jauscat_add_catalogue sources text)
    file(GLOB files CONFIGURE_DEPENDS ${sources}/catalogue/*.cpp)
    add_library(jauscat_catalogue STATIC EXCLUDE_FROM_ALL ${files})
    add_library(jauscat::catalogue ALIAS jauscat_catalogue)
    set_target_properties(jauscat_catalogue PROPERTIES UNITY_BUILD OFF) # each source takes half a gigabyte
    # Half the compiler's time of -O3, and fast enough for programs that people look at.
    target_compile_options(jauscat_catalogue PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O1>)
    target_link_libraries(jauscat_catalogue PUBLIC ${text})
endfunction()
