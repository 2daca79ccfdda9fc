# For cross compilers. headers_of_host(<target> <folder>): a library that is headers alone, as this machine has it. A
# folder by itself leads to them, since the other headers beside them are not for the system that is built for.
# The Find modules here use it; whoever puts this folder into CMAKE_MODULE_PATH gets them.
function(headers_of_host target folder)
  if(NOT TARGET ${target})
    find_path(LGS_HOST_${folder} ${folder} PATHS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
    mark_as_advanced(LGS_HOST_${folder})
    set(headers ${CMAKE_BINARY_DIR}/links-to-host/${folder})
    file(MAKE_DIRECTORY ${headers})
    file(CREATE_LINK ${LGS_HOST_${folder}}/${folder} ${headers}/${folder} SYMBOLIC)
    add_library(${target} INTERFACE IMPORTED GLOBAL)
    set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${headers})
  endif()
endfunction()
