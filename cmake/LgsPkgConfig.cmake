# lgs_write_pc(<folder> <library> [REQUIRES <others>...] [PRIVATE <flags>]): what pkg-config says of a library, which
# needs the other ones. It is for the folders of GNUInstallDirs. These are below the prefix, as a rule. Then the prefix is
# told from where the file is, so that the whole can be moved. Or they are absolute.
function(lgs_write_pc folder lgs_name)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "PRIVATE" "REQUIRES")
  list(JOIN arg_REQUIRES ", " lgs_requires)
  set(lgs_private ${arg_PRIVATE})
  set(lgs_prefix ${CMAKE_INSTALL_PREFIX})
  if(NOT IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
    file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
    set(lgs_prefix \${pcfiledir}/${up})
  endif()
  foreach(folder IN ITEMS INCLUDEDIR LIBDIR)
    set(lgs_${folder} \${prefix})
    cmake_path(APPEND lgs_${folder} ${CMAKE_INSTALL_${folder}})  # an absolute one replaces what is there
  endforeach()
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/library.pc.in ${folder}/${lgs_name}.pc @ONLY)
endfunction()

# lgs_install_pc(<library> [REQUIRES <others>...] [PRIVATE <flags>]): writes and installs it.
function(lgs_install_pc library)
  lgs_write_pc(${lgs_pkg_config_dir} ${ARGV})
  install(FILES ${lgs_pkg_config_dir}/${library}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endfunction()
