# Install rules: the libraries, their headers and the CMake package. Each library has an export file of its own, so that
# whoever wants the engine alone needs none of the importer's libraries.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
include(${CMAKE_CURRENT_LIST_DIR}/LgsPkgConfig.cmake)
set(lgs_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/LocalGridSeg)
set(lgs_pkg_config_dir ${CMAKE_CURRENT_BINARY_DIR}/pkgconfig)
add_custom_target(lgs_installed)  # builds all that is installed, and nothing else

# lgs_install(<component> <target> <folder with the headers' folder lgs/ in it>...)
function(lgs_install component target)
  add_dependencies(lgs_installed ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${component})
  install(TARGETS ${target} EXPORT LocalGridSeg-${component} COMPONENT development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT development)
  install(EXPORT LocalGridSeg-${component} NAMESPACE LocalGridSeg:: DESTINATION ${lgs_package_dir} COMPONENT development)
  foreach(folder IN LISTS ARGN)
    install(DIRECTORY ${folder}/lgs DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
      FILES_MATCHING PATTERN "*.h")
  endforeach()
endfunction()

# lgs_install_package(): what finds them, when all are known.
function(lgs_install_package)
  configure_package_config_file(
    ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/LocalGridSegConfig.cmake.in ${PROJECT_BINARY_DIR}/LocalGridSegConfig.cmake
    INSTALL_DESTINATION ${lgs_package_dir})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/LocalGridSegConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/LocalGridSegConfig.cmake ${PROJECT_BINARY_DIR}/LocalGridSegConfigVersion.cmake
    DESTINATION ${lgs_package_dir} COMPONENT development)
  if(LGS_BUILD_TILED)
    install(FILES ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/FindPCRE2.cmake DESTINATION ${lgs_package_dir}
      COMPONENT development)
  endif()
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
endfunction()
