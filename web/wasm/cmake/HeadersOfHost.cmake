# headers_of_host(<target> <folder>): a library that is headers alone, as this machine has it. They are copied into a
# folder by themselves, since the other headers beside them are not for WebAssembly.
function(headers_of_host target folder)
  if(TARGET ${target})
    return()
  endif()
  find_path(LGS_HOST_${folder} ${folder} PATHS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  mark_as_advanced(LGS_HOST_${folder})
  file(COPY ${LGS_HOST_${folder}}/${folder} DESTINATION ${CMAKE_BINARY_DIR}/headers-of-host/${folder})
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  set_target_properties(${target} PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_BINARY_DIR}/headers-of-host/${folder})
endfunction()
