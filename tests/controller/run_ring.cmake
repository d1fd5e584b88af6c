# Run the ring example: it must succeed and print 300 rows of a time and six fractions, the last at 3 s.
execute_process(COMMAND ${RING} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
string(REPEAT ",[01]\\.[0-9]+" 6 fractions)
string(REGEX MATCHALL "\n[0-9]\\.[0-9][0-9]${fractions}" rows "${output}")
list(LENGTH rows count)
list(GET rows -1 last)
if(NOT count EQUAL 300 OR NOT last MATCHES "\n3\\.00,")
  message(FATAL_ERROR "expected 300 rows up to 3.00 s, got ${count}, the last being: ${last}")
endif()
