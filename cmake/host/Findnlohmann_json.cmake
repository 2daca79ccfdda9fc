include(${CMAKE_CURRENT_LIST_DIR}/HeadersOfHost.cmake)
headers_of_host(nlohmann_json::nlohmann_json nlohmann)
set(nlohmann_json_FOUND ON)
