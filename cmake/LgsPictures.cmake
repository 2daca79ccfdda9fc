# The pictures that the pages tell how to draw: cmake --build build/release --target pictures. They go to
# build/release/pictures. Those that the README shows are in docs/.
set(folder ${PROJECT_BINARY_DIR}/pictures)
set(source ${PROJECT_SOURCE_DIR})
set(pictures)
function(lgs_picture name)  # lgs_picture(NAME COMMAND...): a command that writes pictures/NAME.svg
  add_custom_command(OUTPUT ${folder}/${name}.svg COMMAND ${CMAKE_COMMAND} -E make_directory ${folder} COMMAND ${ARGN}
    WORKING_DIRECTORY ${folder} VERBATIM)
  set(pictures ${pictures} ${folder}/${name}.svg PARENT_SCOPE)
endfunction()

if(TARGET lgs-import)
  lgs_picture(cave lgs-import ${source}/examples/maps/cave.tmx -o cave.trace --block class --svg cave.svg)
  lgs_picture(quarry lgs-import ${source}/examples/maps/quarry.ldtk -o quarry.trace --objects Boulder --objects Plank
    --svg quarry.svg)
endif()
if(TARGET lgs-ride)
  lgs_picture(ride lgs-ride ${source}/docs/ride.trace --coast --speed 2 --size 0.6 --svg ride.svg
    --title "A frictionless ball, with and without ghost vertices")
endif()
# What the published algorithm does instead of the laws: a mismatch each, so the status is 1.
file(GLOB traces CONFIGURE_DEPENDS ${source}/docs/departures/*.trace)
foreach(trace IN LISTS traces)
  get_filename_component(name ${trace} NAME_WE)
  lgs_picture(${name} sh -c "$<TARGET_FILE:lgs_cli> replay ${trace} --check --svg ${name}.svg --engine-so \
$<TARGET_FILE:lgs_published_so> >${name}.txt || test $? -eq 1")
endforeach()
add_custom_target(pictures DEPENDS ${pictures})
add_dependencies(pictures lgs_cli lgs_published_so)
