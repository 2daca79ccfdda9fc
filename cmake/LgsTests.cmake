# What the tests of all rooms share. A room sets `lgs_label`, the label of its tests: `ctest -L heart`, `-L box2d`, …
include(GoogleTest)
find_package(fmt REQUIRED)
find_package(GTest REQUIRED)
find_package(nlohmann_json REQUIRED)  # to write maps for the importer
find_package(pugixml REQUIRED)  # to read pictures
find_package(Python3 REQUIRED COMPONENTS Interpreter)
find_package(rapidcheck REQUIRED)
find_package(ZLIB REQUIRED)  # to pack maps for the importer
find_package(zstd REQUIRED)

# What CTest runs, and no more, for builds that are there to be tested: all of it, for the sanitizers; the laws, the costs
# and the packages, which are tested in Release too (the others have the label "once"); and what `./test.sh quick` runs,
# with the label "quick".
add_custom_target(lgs_tested)
add_custom_target(lgs_tested_in_release)
add_custom_target(lgs_tested_quick)
add_dependencies(lgs_tested_quick lgs_cli)
add_dependencies(lgs_tested lgs_tested_in_release)
set(lgs_heavy lgs lgs_cgal lgs_check lgs_generate lgs_reference lgs_trace)  # libraries in which tests spend their time
if(LGS_SANITIZE STREQUAL "thread")  # which has an `operator new` of its own, and lets nobody replace it
  set(lgs_without_memory EXCLUDE "allocations|cost_test|steady_state")
endif()

# lgs_test_program(<program> [ALONE] [ONCE] [QUICK] [SHARDS <n>] SOURCES <pattern>... [EXCLUDE <regex>] [LIBRARIES <library>...]
# [FIRST <library>...] [FILTER <tests>] [PREFIX <of names>]): a program of GoogleTest's. CTest runs it in n parts side by
# side (2 by default), since with sanitizers a process for each test takes longer to begin than the test. ALONE is for
# programs that need nothing of lgs_test_support. ONCE: not in Release. FIRST are libraries in which the tests spend their
# time (lgs_link_first).
function(lgs_test_program program)
  cmake_parse_arguments(PARSE_ARGV 1 arg "ALONE;ONCE;QUICK" "EXCLUDE;FILTER;PREFIX;SHARDS" "SOURCES;LIBRARIES;FIRST")
  set(sources)
  foreach(pattern IN LISTS arg_SOURCES)
    file(GLOB found RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS ${pattern})
    if(NOT found)
      message(FATAL_ERROR "${program}: there is no file ${pattern} in ${CMAKE_CURRENT_SOURCE_DIR}")
    endif()
    list(APPEND sources ${found})
  endforeach()
  if(arg_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX ${arg_EXCLUDE})
  endif()
  add_executable(${program} ${sources})
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${program} PRIVATE ${arg_LIBRARIES} GTest::gtest_main)
  lgs_target(${program})
  if(NOT arg_ALONE)
    target_link_libraries(${program} PRIVATE lgs_test_support)
    lgs_quick_to_build(${program} REUSE_FROM lgs_test_support)
  endif()
  if(arg_FIRST)
    lgs_link_first(${program} ${arg_FIRST})
  endif()
  set(labels ${lgs_label})
  if(arg_QUICK)
    add_dependencies(lgs_tested_quick ${program})
    list(APPEND labels quick)
  endif()
  if(arg_ONCE)
    add_dependencies(lgs_tested ${program})
    list(APPEND labels once)
  else()
    add_dependencies(lgs_tested_in_release ${program})
  endif()
  if(NOT arg_SHARDS)
    set(arg_SHARDS 2)
  endif()
  if(arg_FILTER)
    string(PREPEND arg_FILTER --gtest_filter=)
  endif()
  foreach(shard RANGE 1 ${arg_SHARDS})
    math(EXPR index "${shard} - 1")
    add_test(NAME ${arg_PREFIX}${program}.${shard} COMMAND ${program} --gtest_brief=1 ${arg_FILTER})
    set_tests_properties(${arg_PREFIX}${program}.${shard} PROPERTIES TIMEOUT 1200 COST 100 LABELS "${labels}"
      FAIL_REGULAR_EXPRESSION " 0 tests from"  # a part of nothing would pass
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${arg_SHARDS};GTEST_SHARD_INDEX=${index}")
  endforeach()
endfunction()

# lgs_label_tests(): gives the room's label to the tests of this folder that have none.
function(lgs_label_tests)
  get_property(tests DIRECTORY PROPERTY TESTS)
  foreach(test IN LISTS tests)
    get_test_property(${test} LABELS labels)
    if(NOT lgs_label IN_LIST labels)
      set_property(TEST ${test} APPEND PROPERTY LABELS ${lgs_label})
    endif()
  endforeach()
endfunction()

# lgs_test_says(<test> <regex>): it passes if it prints this. CTest then asks for no status, so a sanitizer's report fails it.
function(lgs_test_says test says)
  set_tests_properties(${test} PROPERTIES PASS_REGULAR_EXPRESSION "${says}"
    FAIL_REGULAR_EXPRESSION "Sanitizer|runtime error")
endfunction()

# lgs_consumer_test(<name> <folder> <fixture> <definition>...): a project that uses the package is built and run.
function(lgs_consumer_test name folder fixture)
  add_test(NAME package.${name}
    COMMAND ${CMAKE_CTEST_COMMAND}
      --build-and-test ${folder} ${CMAKE_CURRENT_BINARY_DIR}/${name}
      --build-generator ${CMAKE_GENERATOR} --build-makeprogram ${CMAKE_MAKE_PROGRAM} --build-noclean
      --build-options ${ARGN}
      --test-command consumer)
  set_tests_properties(package.${name} PROPERTIES FIXTURES_REQUIRED ${fixture})
endfunction()
set(lgs_consumer_prefix ${PROJECT_BINARY_DIR}/prefix)  # where the test package.install puts the package
set(lgs_consumer_definitions -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER})
