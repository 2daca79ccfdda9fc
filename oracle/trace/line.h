// A line of a trace as words.
#pragma once

#include <string_view>
#include <vector>

namespace lgs::oracle {

/// The words of a line, without the comment at its end. Spaces, tabs and commas part them.
std::vector<std::string_view> splitWords(std::string_view line);

}  // namespace lgs::oracle
