# The libraries refer to nothing but themselves and the four memory functions that every C compiler may call: no libm,
# no malloc. Names in __ are the compiler's own (sanitizers, stack protection).
foreach(library IN LISTS LIBRARIES)
  execute_process(COMMAND ${NM} -u ${library} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL " U [^\n]+" symbols "${output}")
  foreach(symbol IN LISTS symbols)
    string(REPLACE " U " "" symbol "${symbol}")
    if(NOT symbol MATCHES "^(twd_.*|__.*|_GLOBAL_OFFSET_TABLE_|mem(cpy|move|set|cmp))$")
      message(SEND_ERROR "${library} refers to ${symbol}")
    endif()
  endforeach()
endforeach()
