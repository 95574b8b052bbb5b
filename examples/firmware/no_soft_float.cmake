# Fails when IMAGE contains a function of the compiler's software floating point: the run-time ABI's names (ARM IHI 0043)
# or GNU's own.
execute_process(COMMAND ${NM} ${IMAGE} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "__aeabi_(c?[df](r?sub|add|mul|div|neg|cmp)|u?[il]2[df]|[dfh]2)[a-z]*|__[a-z]+[sd]f[a-z]*[0-9]?\n"
    found "${symbols}")
if(found)
    file(REMOVE ${IMAGE})
    list(TRANSFORM found STRIP)
    list(JOIN found " " found)
    message(FATAL_ERROR "firmware: software floating point is linked: ${found}")
endif()
