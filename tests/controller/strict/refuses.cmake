# Compile SOURCE with -DMISTAKE_${MISTAKE}: the compiler must refuse it with MESSAGE among what it says; without a
# MESSAGE it must take it.
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${COMPILER} -std=gnu++20 -fsyntax-only -DTWD_NUMBER_FIXED -DTWD_STRICT_TYPES
    -DMISTAKE_${MISTAKE} -I${INCLUDE} ${SOURCE}
  RESULT_VARIABLE result ERROR_VARIABLE said)
if(NOT MESSAGE)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "what has no mistake does not compile:\n${said}")
  endif()
elseif(result EQUAL 0)
  message(FATAL_ERROR "the compiler takes ${MISTAKE}")
else()
  string(FIND "${said}" "${MESSAGE}" where)
  if(where EQUAL -1)
    message(FATAL_ERROR "${MISTAKE} is refused, but not with: ${MESSAGE}\n${said}")
  endif()
endif()
