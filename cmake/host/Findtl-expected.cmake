include(${CMAKE_CURRENT_LIST_DIR}/HeadersOfHost.cmake)
headers_of_host(tl::expected tl)
set(tl-expected_FOUND ON)
