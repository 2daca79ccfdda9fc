# For workshop.py alone: the standard headers of lib/ are compiled once, which halves the time that a change of one file
# takes; with LGS_BUGS_IN_BATCHES its files are compiled in batches. Given to CMake as
# CMAKE_PROJECT_LocalGridSeg_INCLUDE.
function(lgs_quick_library)
  foreach(target lgs lgs_brush lgs_pieces lgs_tiled lgs_box2d)
    if(TARGET ${target})
      target_precompile_headers(${target} PRIVATE <algorithm> <array> <bit> <cassert> <charconv> <cmath> <cstdint>
        <functional> <map> <memory> <optional> <span> <string> <unordered_map> <utility> <vector>)
      set_target_properties(${target} PROPERTIES UNITY_BUILD "${LGS_BUGS_IN_BATCHES}" UNITY_BUILD_BATCH_SIZE 6)
    endif()
  endforeach()
endfunction()
cmake_language(DEFER CALL lgs_quick_library)
