# Runs the port without vcpkg: cmake -DFEATURES="c;brush" -DOUT=FOLDER -P packaging/vcpkg/try.cmake
# The functions of vcpkg are replaced by what they do to a release build. Then a game is built against the result.
cmake_minimum_required(VERSION 3.22)
if(NOT OUT)
  message(FATAL_ERROR "-DOUT=FOLDER is missing")
endif()
get_filename_component(OUT "${OUT}" ABSOLUTE)
set(PORT localgridseg)
set(CURRENT_PACKAGES_DIR "${OUT}/package")
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}")

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(vcpkg_check_features)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" OUT_FEATURE_OPTIONS FEATURES)
  set(options)
  while(arg_FEATURES)
    list(POP_FRONT arg_FEATURES feature option)
    set(is_on OFF)
    if(feature IN_LIST FEATURES)
      set(is_on ON)
    endif()
    list(APPEND options -D${option}=${is_on})
  endwhile()
  set(${arg_OUT_FEATURE_OPTIONS} ${options} PARENT_SCOPE)
endfunction()

function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" SOURCE_PATH OPTIONS)
  run(${CMAKE_COMMAND} -S "${arg_SOURCE_PATH}" -B "${OUT}/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_LIBDIR=lib
    -DCMAKE_INSTALL_PREFIX=${CURRENT_PACKAGES_DIR} ${arg_OPTIONS})
endfunction()

function(vcpkg_cmake_install)
  run(${CMAKE_COMMAND} --build "${OUT}/build" --target install --parallel 2)
endfunction()

# The package lies one folder less deep afterwards; so its prefix does, too.
function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "PACKAGE_NAME;CONFIG_PATH" "")
  set(there "${CURRENT_PACKAGES_DIR}/share/${arg_PACKAGE_NAME}")
  file(MAKE_DIRECTORY "${CURRENT_PACKAGES_DIR}/share")
  file(RENAME "${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH}" "${there}")
  file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/lib/cmake")
  file(GLOB files "${there}/*.cmake")
  foreach(file IN LISTS files)
    file(READ "${file}" text)
    string(REPLACE [[
get_filename_component(_IMPORT_PREFIX "${CMAKE_CURRENT_LIST_FILE}" PATH)
get_filename_component(_IMPORT_PREFIX "${_IMPORT_PREFIX}" PATH)
]] [[
get_filename_component(_IMPORT_PREFIX "${CMAKE_CURRENT_LIST_FILE}" PATH)
]] text "${text}")
    string(REPLACE "\${CMAKE_CURRENT_LIST_DIR}/../../../" "\${CMAKE_CURRENT_LIST_DIR}/../../" text "${text}")
    file(WRITE "${file}" "${text}")
  endforeach()
endfunction()

function(vcpkg_fixup_pkgconfig)
endfunction()

function(vcpkg_copy_pdbs)
endfunction()

function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" FILE_LIST)
  set(all)
  foreach(file IN LISTS arg_FILE_LIST)
    file(READ "${file}" text)
    string(APPEND all "${text}\n")
  endforeach()
  file(WRITE "${CURRENT_PACKAGES_DIR}/share/${PORT}/copyright" "${all}")
endfunction()

include("${CMAKE_CURRENT_LIST_DIR}/portfile.cmake")

file(GLOB_RECURSE files RELATIVE "${CURRENT_PACKAGES_DIR}" "${CURRENT_PACKAGES_DIR}/*")
foreach(file IN ITEMS include/lgs/world.h lib/liblocalgridseg.a share/LocalGridSeg/LocalGridSegConfig.cmake
    share/localgridseg/copyright share/localgridseg/usage)
  if(NOT file IN_LIST files)
    message(FATAL_ERROR "The port installs no ${file}")
  endif()
endforeach()
run(${CMAKE_COMMAND} -S "${CMAKE_CURRENT_LIST_DIR}/../conan/test_package" -B "${OUT}/game"
  -DCMAKE_PREFIX_PATH=${CURRENT_PACKAGES_DIR})
run(${CMAKE_COMMAND} --build "${OUT}/game")
run("${OUT}/game/game")
foreach(feature IN LISTS FEATURES)
  run(${CMAKE_COMMAND} -S "${CMAKE_CURRENT_LIST_DIR}/../../packaging/tests/consumer" -B "${OUT}/${feature}"
    -DCMAKE_PREFIX_PATH=${CURRENT_PACKAGES_DIR} -DLGS_CONSUMER_COMPONENT=${feature})
endforeach()
message(STATUS "The port is fine, with the features: ${FEATURES}")
