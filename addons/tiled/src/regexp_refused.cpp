// Where there is no PCRE2, in WebAssembly.
#include "regexp.h"

namespace lgs::tiled {

tl::expected<std::vector<Fit>, std::string> namesThatFit(std::string_view, const std::vector<std::string>&,
                                                         std::uint64_t&) {
  return tl::unexpected<std::string>("can not be read in WebAssembly: list the maps of the world as \"maps\"");
}

}  // namespace lgs::tiled
