# What pkg-config says, for folders below the prefix and for absolute ones, as distributions have them.
include(${WRITER})
set(PROJECT_DESCRIPTION "a test")
set(PROJECT_VERSION 1.2.3)
set(CMAKE_INSTALL_PREFIX ${ROOT}/usr)

# expect_folders(<libdir> <includedir>): asks pkg-config where these are, if they are called so.
function(expect_folders CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_INCLUDEDIR)
  cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_LIBDIR BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX} OUTPUT_VARIABLE libdir)
  cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_INCLUDEDIR BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX} OUTPUT_VARIABLE includedir)
  lgs_write_pc(${libdir}/pkgconfig lgs)
  set(ENV{PKG_CONFIG_PATH} ${libdir}/pkgconfig)
  foreach(variable IN ITEMS prefix libdir includedir)
    execute_process(COMMAND ${PKG_CONFIG} --variable=${variable} lgs OUTPUT_VARIABLE found
      OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    cmake_path(ABSOLUTE_PATH found NORMALIZE)
    string(REGEX REPLACE "/$" "" found "${found}")
    set(prefix ${CMAKE_INSTALL_PREFIX})
    if(NOT found STREQUAL "${${variable}}")
      message(SEND_ERROR "${CMAKE_INSTALL_LIBDIR}, ${CMAKE_INSTALL_INCLUDEDIR}: ${variable} is ${found}, "
        "not ${${variable}}")
    endif()
  endforeach()
endfunction()

expect_folders(lib include)
expect_folders(lib/x86_64-linux-gnu include/lgs-0.1)
expect_folders(${ROOT}/far/lib ${ROOT}/far/include)
expect_folders(lib64 ${ROOT}/far/include)
