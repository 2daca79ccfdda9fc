# PCRE2::8BIT, regular expressions on bytes. PCRE2's own CMake package has a target of this name; Debian's has no such
# package, so the header and the library are found by themselves.
find_package(PCRE2 QUIET CONFIG)
if(NOT TARGET PCRE2::8BIT)
  find_path(PCRE2_INCLUDE_DIR pcre2.h)
  find_library(PCRE2_LIBRARY pcre2-8)
  mark_as_advanced(PCRE2_INCLUDE_DIR PCRE2_LIBRARY)
  if(PCRE2_INCLUDE_DIR AND PCRE2_LIBRARY)
    add_library(PCRE2::8BIT UNKNOWN IMPORTED)
    set_target_properties(PCRE2::8BIT PROPERTIES
      IMPORTED_LOCATION ${PCRE2_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${PCRE2_INCLUDE_DIR})
  endif()
endif()
set(PCRE2_FOUND OFF)
if(TARGET PCRE2::8BIT)
  set(PCRE2_FOUND ON)
elseif(PCRE2_FIND_REQUIRED)
  message(FATAL_ERROR "PCRE2 is not here: its header pcre2.h and its library pcre2-8 (Debian: libpcre2-dev)")
endif()
