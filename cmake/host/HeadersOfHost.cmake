# For cross compilers. headers_of_host(<target> <folder>): a library that is headers alone, as this machine has it. They
# are copied into a folder by themselves, since the other headers beside them are not for the system that is built for.
# The Find modules here use it; whoever puts this folder into CMAKE_MODULE_PATH gets them.
function(headers_of_host target folder)
  if(NOT TARGET ${target})
    find_path(LGS_HOST_${folder} ${folder} PATHS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
    mark_as_advanced(LGS_HOST_${folder})
    set(headers ${CMAKE_BINARY_DIR}/headers-of-host/${folder})
    file(COPY ${LGS_HOST_${folder}}/${folder} DESTINATION ${headers})
    add_library(${target} INTERFACE IMPORTED GLOBAL)
    set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${headers})
  endif()
endfunction()
