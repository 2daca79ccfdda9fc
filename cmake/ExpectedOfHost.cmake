# For cross compilers: tl::expected as this machine has it, by itself in a folder. It is a header alone, and the other
# headers beside it are not for the system that is built for.
find_file(LGS_EXPECTED_HEADER tl/expected.hpp PATHS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
mark_as_advanced(LGS_EXPECTED_HEADER)
set(tl-expected_DIR ${CMAKE_BINARY_DIR}/tl-expected)
file(COPY ${LGS_EXPECTED_HEADER} DESTINATION ${tl-expected_DIR}/include/tl)
file(WRITE ${tl-expected_DIR}/tl-expected-config.cmake [[
if(NOT TARGET tl::expected)
  add_library(tl::expected INTERFACE IMPORTED)
  set_target_properties(tl::expected PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/include)
endif()
]])
