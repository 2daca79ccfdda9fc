# For workshop.py alone: what makes a change of one file cheap. The libraries are hardly optimised, their standard headers
# are compiled once, and with LGS_BUGS_AS_ONE each library is one file. The linker is mold where it is there. Given to CMake
# as CMAKE_PROJECT_LocalGridSeg_INCLUDE.
find_program(LGS_MOLD mold)
if(LGS_MOLD)
  add_link_options(-fuse-ld=mold)
endif()
function(lgs_quick_libraries)
  foreach(target lgs lgs_brush lgs_pieces lgs_views lgs_tiled lgs_box2d lgs_falling)
    if(TARGET ${target})
      target_compile_options(${target} PRIVATE -O1)
      target_precompile_headers(${target} PRIVATE <algorithm> <array> <bit> <cassert> <charconv> <cmath> <cstdint>
        <functional> <map> <memory> <optional> <span> <string> <unordered_map> <utility> <vector>)
      set_target_properties(${target} PROPERTIES UNITY_BUILD "${LGS_BUGS_AS_ONE}" UNITY_BUILD_BATCH_SIZE 0)
    endif()
  endforeach()
endfunction()
cmake_language(DEFER CALL lgs_quick_libraries)
