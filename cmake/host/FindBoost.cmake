include(${CMAKE_CURRENT_LIST_DIR}/HeadersOfHost.cmake)
headers_of_host(Boost::headers boost)
# Boost 1.74 takes what C++17 has removed for there, with a standard library that it does not know.
target_compile_definitions(Boost::headers INTERFACE BOOST_NO_CXX98_FUNCTION_BASE)
set(Boost_FOUND ON)
