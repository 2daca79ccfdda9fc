# Compares the symbols that the shared library shows with symbols.txt: -DNM=… -DLIBRARY=… -DLIST=…
execute_process(COMMAND ${NM} -D --defined-only ${LIBRARY} OUTPUT_VARIABLE shown COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" lines "${shown}")
list(TRANSFORM lines REPLACE "^[0-9a-f]+ " "")
list(TRANSFORM lines REPLACE "^(A [^@]+)@@.*" "\\1")  # llvm-nm gives the version itself a version
list(SORT lines)
list(JOIN lines "\n" found)
file(READ ${LIST} expected)
if(NOT "${found}\n" STREQUAL "${expected}")
  message(FATAL_ERROR "The library shows other symbols than ${LIST} says. It shows:\n${found}")
endif()
