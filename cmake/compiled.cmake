# The target jauscat::compiled: jauscat::net, and what of it is no template compiled once, by the project that uses it.
# SOURCES is the folder of src/. Users of the target have JAUSCAT_SEPARATE_COMPILATION defined.
function(jauscat_add_compiled sources net)
    file(GLOB files CONFIGURE_DEPENDS ${sources}/*.cpp)
    add_library(jauscat_compiled STATIC EXCLUDE_FROM_ALL ${files})
    add_library(jauscat::compiled ALIAS jauscat_compiled)
    set_target_properties(jauscat_compiled PROPERTIES UNITY_BUILD OFF) # each source takes up to half a gigabyte
    # g++ frees memory earlier, as it does on a machine with little of it: a fifth less for the largest sources.
    target_compile_options(jauscat_compiled PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=30>)
    target_compile_definitions(jauscat_compiled PUBLIC JAUSCAT_SEPARATE_COMPILATION)
    target_link_libraries(jauscat_compiled PUBLIC ${net})
endfunction()
