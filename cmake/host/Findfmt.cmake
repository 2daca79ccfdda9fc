include(${CMAKE_CURRENT_LIST_DIR}/HeadersOfHost.cmake)
headers_of_host(fmt::fmt fmt)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY
  FMT_STATIC_THOUSANDS_SEPARATOR=',')  # without locales
set(fmt_FOUND ON)
