// Numbers of things, for people to read.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lgs::oracle {

/// "1 segment", "12,345 segments"
std::string counted(std::uint64_t n, std::string_view noun);

}  // namespace lgs::oracle
