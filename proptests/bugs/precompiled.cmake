# For workshop.py alone: the standard headers of lib/ are compiled once, which halves the time that a change of one file
# takes. Given to CMake as CMAKE_PROJECT_LocalGridSeg_INCLUDE.
function(lgs_precompile)
  foreach(target lgs lgs_tiled lgs_box2d)
    if(TARGET ${target})
      target_precompile_headers(${target} PRIVATE <algorithm> <array> <bit> <cassert> <charconv> <cmath> <cstdint>
        <functional> <map> <memory> <optional> <span> <string> <unordered_map> <utility> <vector>)
    endif()
  endforeach()
endfunction()
cmake_language(DEFER CALL lgs_precompile)
