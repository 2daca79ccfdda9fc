include(${CMAKE_CURRENT_LIST_DIR}/HeadersOfHost.cmake)
headers_of_host(FastFloat::fast_float fast_float)
set(FastFloat_FOUND ON)
