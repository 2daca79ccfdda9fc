# What reads; nothing here writes.
include(${CMAKE_CURRENT_LIST_DIR}/SourceOfDebian.cmake)
if(NOT TARGET zstd::libzstd_static)
  source_of_debian(folder "zstd-*")
  file(GLOB names ${folder}/lib/common/*.c ${folder}/lib/decompress/*.c)
  list(FILTER names EXCLUDE REGEX "/(pool|threading|debug)\\.c$")
  add_library(libzstd STATIC ${names})
  target_include_directories(libzstd SYSTEM PUBLIC ${folder}/lib)
  target_compile_definitions(libzstd PRIVATE ZSTD_DISABLE_ASM ZSTD_LEGACY_SUPPORT=0 ZSTD_NO_INLINE ZSTD_STRIP_ERROR_STRINGS
    HUF_FORCE_DECOMPRESS_X1 ZSTD_FORCE_DECOMPRESS_SEQUENCES_SHORT)
  target_compile_options(libzstd PRIVATE -w)
  add_library(zstd::libzstd_static ALIAS libzstd)
endif()
set(zstd_FOUND ON)
