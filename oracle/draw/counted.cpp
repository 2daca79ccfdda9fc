#include "oracle/draw/counted.h"

namespace lgs::oracle {

std::string counted(std::uint64_t n, std::string_view noun) {
  std::string text = std::to_string(n);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
  return text.append(" ").append(noun).append(n == 1 ? "" : "s");
}

}  // namespace lgs::oracle
