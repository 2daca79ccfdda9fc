# Compiles a program by what pkg-config says of the installed library, and runs it.
set(ENV{PKG_CONFIG_PATH} ${WHERE})
execute_process(COMMAND ${PKG_CONFIG} --modversion ${LIBRARY} OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
if(NOT version STREQUAL VERSION)
  message(FATAL_ERROR "pkg-config says version ${version}, not ${VERSION}")
endif()
execute_process(COMMAND ${PKG_CONFIG} --cflags --libs ${LIBRARY} OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
execute_process(COMMAND ${PKG_CONFIG} --variable=libdir ${LIBRARY} OUTPUT_VARIABLE libdir OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${COMPILER} -std=${STANDARD} ${SOURCE} -o ${PROGRAM} ${flags} -Wl,-rpath,${libdir}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PROGRAM} COMMAND_ERROR_IS_FATAL ANY)
