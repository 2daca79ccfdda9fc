# An overlay port: it takes the source from LGS_SOURCE, or from the folder above packaging/ if it lies there.
# A port in a registry would say here where the release archive is, with its hash.
if(DEFINED ENV{LGS_SOURCE})
  set(SOURCE_PATH "$ENV{LGS_SOURCE}")
else()
  get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
endif()

vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURE_OPTIONS
  FEATURES
    box2d LGS_BUILD_BOX2D
    brush LGS_BUILD_BRUSH
    c LGS_BUILD_C
    debug LGS_BUILD_DEBUG
    falling LGS_BUILD_FALLING
    pieces LGS_BUILD_PIECES
    tiled LGS_BUILD_TILED
    views LGS_BUILD_VIEWS)

vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${FEATURE_OPTIONS} -DLGS_BUILD_TOOLS=OFF -DLGS_BUILD_TESTS=OFF -DLGS_BUILD_BENCH=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME LocalGridSeg CONFIG_PATH lib/cmake/LocalGridSeg)
vcpkg_fixup_pkgconfig()
vcpkg_copy_pdbs()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share"
  "${CURRENT_PACKAGES_DIR}/share/doc")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/LICENSES.md")
