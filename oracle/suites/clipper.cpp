// Clipper2's text: lines `KEY: VALUE`, and behind SUBJECTS and CLIPS a line for each ring, `x,y, x,y, …`.
#include "oracle/suites/suite.h"
#include "oracle/trace/line.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>

namespace lgs::oracle {
namespace {

using Ring = std::vector<SuitePart::Vertex>;

/// A finite number; nothing, if the word is none.
std::optional<double> numberOf(std::string_view word) {
  double number = 0;
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool isWhole = status == std::errc() && end == word.data() + word.size() && !word.empty();
  return isWhole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<Ring> ringOf(std::span<const std::string_view> words) {
  Ring ring;
  for (std::size_t k = 0; k + 1 < words.size(); k += 2) {
    const auto x = numberOf(words[k]), y = numberOf(words[k + 1]);
    if (!x || !y) return std::nullopt;
    ring.push_back({*x, *y});
  }
  return words.size() % 2 == 0 ? std::optional(std::move(ring)) : std::nullopt;
}

// A case as far as it is read.
struct Caption {
  std::size_t line = 0;  // of its CAPTION
  std::string name, operation, rule = "EVENODD";
  SuitePart subjects, clips;
  SuitePart* open = nullptr;  // where the next rings go

  void finish(const std::string& file, Suite& suite) {
    if (line == 0) return;
    constexpr std::array kRules{"EVENODD", "NONZERO", "POSITIVE", "NEGATIVE"};
    const auto known = std::ranges::find(kRules, rule);
    const NamedOperation named = operationOf(operation);
    if (named.operations.empty() || known == kRules.end()) {
      ++suite.leftOut[fmt::format("case of Clipper2 with CLIPTYPE '{}' and FILLRULE '{}'", operation, rule)];
      return;
    }
    subjects.rule = clips.rule = static_cast<Filled>(known - kRules.begin());
    std::vector<Operand> operands{{subjects}};
    if (!clips.rings.empty() || named.operations[0] != Operation::unite) operands.push_back({clips});
    suite.add(fmt::format("{}:{}: {}", file, line, name), named.operations, operands);
  }
};

}  // namespace

Read readClipper(const std::string& file, std::string_view text, Suite& suite) {
  Caption caption;
  SuitePart ignored;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::vector<std::string_view> words = splitWords(takeLine(text));
    if (words.empty()) continue;
    std::string_view key = words[0];
    if (key.ends_with(':')) key.remove_suffix(1);
    const std::string value(words.size() > 1 ? words[1] : "");
    if (key == "CAPTION") {
      caption.finish(file, suite);
      caption = {};
      caption.line = line;
      caption.name = "caption " + value;
    } else if (key == "CLIPTYPE" || key == "FILLRULE") {
      (key == "CLIPTYPE" ? caption.operation : caption.rule) = value;
    } else if (key == "SUBJECTS" || key == "CLIPS") {
      caption.open = key == "SUBJECTS" ? &caption.subjects : &caption.clips;
    } else if (key == "SUBJECTS_OPEN" || key == "CLIPS_OPEN") {
      ++suite.leftOut["list of open paths"];
      caption.open = &ignored;
    } else if (!key.starts_with("SOL_")) {
      auto ring = ringOf(words);
      if (!ring)
        return tl::unexpected(fmt::format("{}: '{}' is neither a key of Clipper2 nor a ring, x,y, x,y, …", line, key));
      if (caption.open == nullptr) return tl::unexpected(fmt::format("{}: a ring must follow SUBJECTS or CLIPS", line));
      caption.open->rings.push_back(std::move(*ring));
    }
  }
  caption.finish(file, suite);
  return {};
}

}  // namespace lgs::oracle
