# Compares what lgs_c_layout prints with layout.txt: -DPROGRAM=… -DLIST=…
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE found RESULT_VARIABLE status)
if(status EQUAL 77)
  message("Skipped: layout.txt is for pointers of 64 bits")  # SKIP_REGULAR_EXPRESSION of the test looks for it
  return()
endif()
file(READ ${LIST} expected)
if(NOT status EQUAL 0 OR NOT "${found}" STREQUAL "${expected}")
  message(FATAL_ERROR "The structs lie in another way than ${LIST} says:\n${found}")
endif()
