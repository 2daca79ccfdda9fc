# cmake -DPROGRAM=… -DTEXT=… -P compare.cmake
# Runs PROGRAM, perhaps by an emulator that stands before it in the list, and compares what it prints with the file
# TEXT. Windows ends lines in its own way.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "The program ended with status ${status}: ${PROGRAM}")
endif()
string(REPLACE "\r\n" "\n" printed "${printed}")
file(READ "${TEXT}" promised)
if(NOT "${printed}" STREQUAL "${promised}")
  message(FATAL_ERROR "Promised is\n${promised}but the program prints\n${printed}")
endif()
