# The targets two_files and dist: the amalgamation of the engine and the brushes, and the release archive.
# To build the libraries no Python is needed: then there are no such targets.
find_package(Python3 COMPONENTS Interpreter)
find_file(LGS_EXPECTED_HEADER tl/expected.hpp)
mark_as_advanced(LGS_EXPECTED_HEADER)
if(NOT Python3_FOUND OR NOT LGS_EXPECTED_HEADER)
  return()
endif()

set(lgs_two_files ${PROJECT_BINARY_DIR}/two_files)
add_custom_target(two_files  # they are only written when they change
  COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/scripts/amalgamate.py ${lgs_two_files}
    --expected ${LGS_EXPECTED_HEADER}
  BYPRODUCTS ${lgs_two_files}/localgridseg.h ${lgs_two_files}/localgridseg.cpp
  COMMENT "Writing ${lgs_two_files}/localgridseg.h and .cpp"
  VERBATIM)

set(lgs_archive ${PROJECT_BINARY_DIR}/localgridseg-${PROJECT_VERSION}.tar.gz)
set(lgs_write_archive ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/scripts/dist.py ${lgs_archive}
  --expected ${LGS_EXPECTED_HEADER})
add_custom_target(dist COMMAND ${lgs_write_archive} COMMENT "Writing ${lgs_archive}" VERBATIM)
