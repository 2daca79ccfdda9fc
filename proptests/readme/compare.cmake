# cmake -DPROGRAM=… -DTEXT=… -P compare.cmake
# Runs PROGRAM and compares what it prints with the file TEXT, byte by byte.
execute_process(COMMAND "${PROGRAM}" OUTPUT_VARIABLE printed RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "The README's example ended with status ${status}")
endif()
file(READ "${TEXT}" promised)
if(NOT "${printed}" STREQUAL "${promised}")
  message(FATAL_ERROR "The README promises\n${promised}but its example prints\n${printed}")
endif()
