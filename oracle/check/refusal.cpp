#include "oracle/check/refusal.h"

#include "oracle/engine/answer.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {

std::string wrongRefusals(const std::vector<RefusedEdit>& expected, const std::vector<RefusedEdit>& actual) {
  const auto at = std::ranges::mismatch(expected, actual, {}, &RefusedEdit::name, &RefusedEdit::name);
  const auto isMoreIn = [](const std::vector<RefusedEdit>& one, const std::vector<RefusedEdit>& other,
                           const RefusedEdit& edit) {
    return std::ranges::count(one, edit.name, &RefusedEdit::name) >
           std::ranges::count(other, edit.name, &RefusedEdit::name);
  };
  if (at.in2 != actual.end() && isMoreIn(actual, expected, *at.in2))
    return fmt::format("refused, but is good: '{}': {}", shortened(at.in2->name), shortened(at.in2->reason));
  if (at.in1 != expected.end() && isMoreIn(expected, actual, *at.in1))
    return fmt::format("accepted, but must be refused as {}: '{}'", at.in1->reason, at.in1->name);
  if (at.in2 == actual.end()) return "";
  return fmt::format("the refusal of '{}' is not reported in the order of the edits", shortened(at.in2->name));
}

}  // namespace lgs::oracle
