# Build the C libraries alone, install them, and move the installed tree: what finds its files from where they lie still
# works. The consumer and the example are copied, so that nothing is found in the source tree.
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/library
  -DCMAKE_C_COMPILER=${CC} -DCMAKE_BUILD_TYPE=Release -DTWIDDLE_HARNESS=OFF -DTWIDDLE_TESTS=OFF -DTWIDDLE_BENCH=OFF
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/library COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${WORK}/library --prefix ${WORK}/first COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${WORK}/first ${WORK}/prefix)
file(COPY ${SOURCE}/tests/install/consumer ${SOURCE}/examples/ring DESTINATION ${WORK})
