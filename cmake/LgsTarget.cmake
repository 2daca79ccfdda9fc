# lgs_target(<target> [NOT_SANITIZED] [SELDOM_RUN]): what every target of this project is compiled with. Warnings and
# sanitizers are for those who work on the project; a game that has it as a subproject keeps its own. NOT_SANITIZED is
# for code that is little beside the headers that it includes (CGAL, CLI11, JSON): with sanitizers these take minutes to
# compile. SELDOM_RUN is for libraries in which tests spend little time: tests with sanitizers do not optimise them.
function(lgs_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  file(RELATIVE_PATH room ${LocalGridSeg_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  set(is_library OFF)
  if(room MATCHES "^(lib(/.*)?|addons/[^/]+)$")
    set(is_library ON)
  endif()
  if(is_library)
    # Some machines work out a * b + c with a single rounding, and compilers use that where they may. Processors of 1980
    # round every result twice. Then answers in `double` would depend on the machine. Microsoft's compiler does neither
    # unless it is asked to; but it has to be told that the sources are in UTF-8. MSVC means clang-cl, too.
    if(MSVC)
      target_compile_options(${target} PRIVATE /utf-8 $<$<CXX_COMPILER_ID:Clang>:/clang:-ffp-contract=off>)
    else()
      target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off>)
    endif()
    if(CMAKE_SIZEOF_VOID_P EQUAL 4 AND CMAKE_SYSTEM_PROCESSOR MATCHES "86|AMD64" AND NOT MSVC)
      target_compile_options(${target} PRIVATE -msse2 -mfpmath=sse)
    endif()
  endif()
  if(CMAKE_SOURCE_DIR STREQUAL LocalGridSeg_SOURCE_DIR AND MSVC)
    target_compile_options(${target} PRIVATE /W4)
  elseif(CMAKE_SOURCE_DIR STREQUAL LocalGridSeg_SOURCE_DIR)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
      # GCC 12 warns of string concatenation where nothing is wrong (its bug 105651, fixed in 13).
      $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)
    if(LGS_SANITIZE)
      if(NOT "NOT_SANITIZED" IN_LIST ARGN)
        target_compile_options(${target} PRIVATE
          -fsanitize=${LGS_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
          -D_GLIBCXX_ASSERTIONS  # an index beyond a vector's end may be within its memory
          $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)  # GCC takes the sanitizers' own code for uses
        if(is_library)
          lgs_check_integers(${target})
        else()
          # These checks of pointers take up to a fifth of the time to compile. Outside lib/ they find nothing more: a
          # null pointer crashes anyway, and the others are for casts of pointers, which only lib/ has.
          target_compile_options(${target} PRIVATE -fno-sanitize=null,alignment,vptr)
        endif()
      endif()
      if("SELDOM_RUN" IN_LIST ARGN AND LGS_BUILD_TESTS)
        target_compile_options(${target} PRIVATE -O0)
      endif()
      target_link_options(${target} PUBLIC -fsanitize=${LGS_SANITIZE})
    endif()
  endif()
endfunction()

# lgs_check_integers(<target>): with clang and LGS_SANITIZE_INTEGERS no number may be cut, change its sign or wrap unasked.
# cmake/integers.txt names the files where numbers wrap on purpose.
function(lgs_check_integers target)
  if(LGS_SANITIZE_INTEGERS AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    set(ignored ${LocalGridSeg_SOURCE_DIR}/cmake/integers.txt)
    target_compile_options(${target} PRIVATE -fsanitize=integer -fno-sanitize-recover=all
      -fsanitize-ignorelist=${ignored})
  endif()
endfunction()

# lgs_component(<name> [HEADERS <folder>...] [STANDS_ON <component>...] [NO_PC]): makes the library lgs_<name> of this folder a
# component of the package: gives it an alias, a file name with a version, the folders of its public headers (include/,
# and those that are named), and installs it.
function(lgs_component name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "NO_PC" "" "HEADERS;STANDS_ON")
  set(folders include ${arg_HEADERS})
  list(TRANSFORM folders PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  add_library(LocalGridSeg::${name} ALIAS lgs_${name})
  set_target_properties(lgs_${name} PROPERTIES EXPORT_NAME ${name} OUTPUT_NAME localgridseg_${name}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_include_directories(lgs_${name}
    PUBLIC "$<BUILD_INTERFACE:${folders}>" $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  if(LGS_INSTALL)
    lgs_install(${name} lgs_${name} ${folders})
    if(NOT arg_NO_PC)
      list(TRANSFORM arg_STANDS_ON PREPEND localgridseg_)
      lgs_install_pc(localgridseg_${name} REQUIRES localgridseg ${arg_STANDS_ON})
    endif()
  endif()
endfunction()

# lgs_is_timed(<target>): it is compiled file by file, as in most games.
function(lgs_is_timed target)
  if(PROJECT_IS_TOP_LEVEL AND LGS_BUILD_BENCH AND NOT LGS_SANITIZE)
    set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
  endif()
endfunction()

# lgs_without_exceptions(<target>): compiles it without exceptions and RTTI, which it does not need. Microsoft's compiler
# and clang-cl do not know these options.
function(lgs_without_exceptions target)
  if(NOT MSVC)
    target_compile_options(${target} PRIVATE -fno-exceptions -fno-rtti)
  endif()
endfunction()

# lgs_ends_without_memory(<file>...): for the sources of a face, whose functions are noexcept. When memory runs out, what
# they call throws, in code that does not know of exceptions and would leave things half done. So these files do know of
# them, and end the program. In WebAssembly nothing throws: the library itself ends it.
function(lgs_ends_without_memory)
  if(NOT MSVC AND NOT CMAKE_SYSTEM_PROCESSOR MATCHES "wasm")
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -fexceptions SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# lgs_quick_to_build(<target> <headers>...), lgs_quick_to_build(<target> REUSE_FROM <other>): for code whose own speed
# does not matter, as tests and commands, where all that takes long is in libraries. It is optimised little, with
# sanitizers not at all, and the headers that take longest to read are read once, here or for the other target.
function(lgs_quick_to_build target)
  if(LGS_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  else()
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  if(ARGV1 STREQUAL "REUSE_FROM")
    target_precompile_headers(${target} ${ARGN})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# lgs_link_first(<program> <library>...): has the linker look at these libraries before the program's own files. Of an
# inline function that many files have it keeps the first one it meets. Else the references would run the copies of
# std::vector that unoptimised tests have, and sanitized tests take three times as long.
function(lgs_link_first program)
  if(LGS_SANITIZE)
    list(TRANSFORM ARGN REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE files)
    list(JOIN files "," files)
    target_link_options(${program} PRIVATE "LINKER:--whole-archive,${files},--no-whole-archive")
  endif()
endfunction()

# lgs_loads_a_library(<test>): for tests in which Python loads a library of this project. A library with the address
# sanitizer needs the sanitizer's own library to be there first. What Python itself leaks is no finding. The thread
# sanitizer must be in the program itself.
function(lgs_loads_a_library test)
  set_tests_properties(${test} PROPERTIES LABELS tools)
  if(LGS_SANITIZE MATCHES "thread")
    set_tests_properties(${test} PROPERTIES DISABLED ON)
  elseif(LGS_SANITIZE MATCHES "address")
    set(runtime libasan.so)
    if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
      set(runtime libclang_rt.asan-${CMAKE_SYSTEM_PROCESSOR}.so)
    endif()
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=${runtime}
      OUTPUT_VARIABLE runtime OUTPUT_STRIP_TRAILING_WHITESPACE)
    set_tests_properties(${test} PROPERTIES ENVIRONMENT "LD_PRELOAD=${runtime};ASAN_OPTIONS=detect_leaks=0")
  endif()
endfunction()
