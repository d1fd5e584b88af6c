# Build PROJECT (a copy in WORK) against the installed package and run PROGRAMS.
execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/${PROJECT} -B ${WORK}/${PROJECT}-build -DCMAKE_C_COMPILER=${CC}
  -DCMAKE_PREFIX_PATH=${WORK}/prefix COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/${PROJECT}-build COMMAND_ERROR_IS_FATAL ANY)
foreach(program IN LISTS PROGRAMS)
  execute_process(COMMAND ${WORK}/${PROJECT}-build/${program} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
