# Compile the consumer with nothing but COMPILER (and its OPTIONS) and what pkg-config says of PACKAGE, and run it.
file(GLOB_RECURSE description ${WORK}/prefix/${PACKAGE}.pc)
get_filename_component(folder "${description}" DIRECTORY)
set(ENV{PKG_CONFIG_PATH} ${folder})
execute_process(COMMAND ${PKG_CONFIG} --cflags --libs ${PACKAGE} OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
set(program ${WORK}/${NAME})
execute_process(COMMAND ${COMPILER} ${OPTIONS} ${WORK}/consumer/main.c -x none -o ${program} ${flags}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${program} COMMAND_ERROR_IS_FATAL ANY)
