// Patterns become steps. Code of a part has jumps that count from the step itself, so that it can be moved and repeated.
#include "regexp.h"

#include <algorithm>
#include <charconv>

namespace lgs::tiled {

class RegexpParser {
 public:
  explicit RegexpParser(std::string_view pattern) : pattern_(Letters(pattern).letters) {}

  tl::expected<Regexp, std::string> run() {
    Code code = alternatives();
    if (!atEnd()) fail("has a ')' without its '('");
    if (!fault_.empty()) return tl::unexpected(fault_);
    result_.steps_ = std::move(code);
    return std::move(result_);
  }

 private:
  using Code = std::vector<RegexpStep>;
  using Kind = RegexpStep::Kind;
  using Range = std::pair<char32_t, char32_t>;

  bool atEnd() const { return at_ >= pattern_.size() || !fault_.empty(); }
  bool sees(char32_t letter) const { return !atEnd() && pattern_[at_] == letter; }

  bool take(std::u32string_view text) {
    if (!fault_.empty() || pattern_.compare(at_, text.size(), text) != 0) return false;
    at_ += text.size();
    return true;
  }

  void fail(std::string what) {
    if (fault_.empty()) fault_ = std::move(what);
  }

  Code limited(Code code) {
    if (code.size() > Regexp::kMaxSteps) fail("is too long");
    if (!fault_.empty()) code.clear();
    return code;
  }

  static void append(Code& code, const Code& more) { code.insert(code.end(), more.begin(), more.end()); }
  static std::ptrdiff_t sizeOf(const Code& code) { return static_cast<std::ptrdiff_t>(code.size()); }

  static RegexpStep split(std::ptrdiff_t first, std::ptrdiff_t second, bool isLazy) {
    return isLazy ? RegexpStep{Kind::split, second, first} : RegexpStep{Kind::split, first, second};
  }

  Code alternatives() {
    Code code = sequence();
    while (take(U"|")) {
      const Code other = sequence();
      Code both{split(1, sizeOf(code) + 2, false)};
      append(both, code);
      both.push_back({Kind::jump, sizeOf(other) + 1});
      append(both, other);
      code = limited(std::move(both));
    }
    return code;
  }

  Code sequence() {
    Code code;
    while (!atEnd() && !sees(U'|') && !sees(U')')) {
      append(code, repeated(atom()));
      code = limited(std::move(code));
    }
    return code;
  }

  Code atom() {
    if (take(U"(")) return group();
    if (take(U"^")) return {{Kind::begin}};
    if (take(U"$")) return {{Kind::end}};
    if (sees(U'*') || sees(U'+') || sees(U'?')) fail("has a repetition of nothing");
    if (take(U".")) return letter({{{U'\n', U'\n'}}, true});
    if (take(U"[")) return letter(set());
    RegexpSet one;
    if (!take(U"\\")) {
      one.ranges = {{pattern_[at_], pattern_[at_]}};
      ++at_;
    } else {
      one = escaped();
    }
    return letter(std::move(one));
  }

  Code letter(RegexpSet set) {
    result_.sets_.push_back(std::move(set));
    return {{Kind::letter, 0, 0, result_.sets_.size() - 1}};
  }

  Code group() {
    constexpr int kMaxDepth = 64;
    const bool isNamed = !isAhead(U"?<=") && !isAhead(U"?<!") && take(U"?<");
    const bool isPlain = !isNamed && take(U"?:");
    if (isNamed) {
      while (!atEnd() && !sees(U'>')) ++at_;
      take(U">");
    } else if (sees(U'?')) {
      fail("has a group that begins with '(?', which is not supported, except (?:…) and (?<name>…)");
    }
    const std::size_t number = isPlain ? Regexp::kKept : result_.captures_++;
    if (++depth_ > kMaxDepth) fail("has groups that are nested too deeply");
    Code inner = alternatives();
    --depth_;
    if (!take(U")")) fail("has a '(' without its ')'");
    if (number >= Regexp::kKept) return inner;
    Code code{{Kind::save, 0, 0, 2 * number}};
    append(code, inner);
    code.push_back({Kind::save, 0, 0, 2 * number + 1});
    return code;
  }

  bool isAhead(std::u32string_view text) const { return pattern_.compare(at_, text.size(), text) == 0; }

  Code repeated(const Code& once) {
    std::size_t least = 1;
    std::optional<std::size_t> most = 1;
    if (take(U"*")) {
      least = 0, most.reset();
    } else if (take(U"+")) {
      most.reset();
    } else if (take(U"?")) {
      least = 0;
    } else if (!counts(least, most)) {
      return once;
    }
    const bool isLazy = take(U"?");
    std::size_t again = 0;
    std::optional<std::size_t> andAgain;
    if (sees(U'*') || sees(U'+') || sees(U'?') || counts(again, andAgain)) fail("has a repetition of a repetition");
    if (most && *most < least) fail("has a repetition whose numbers are the wrong way round");
    const std::size_t times = std::max(least, most.value_or(least + 1));
    if (times * (once.size() + 2) > Regexp::kMaxSteps) fail("is too long");
    if (!fault_.empty()) return {};
    Code code;
    for (std::size_t k = 0; k < least; ++k) append(code, once);
    if (!most) {
      code.push_back(split(1, sizeOf(once) + 2, isLazy));
      append(code, once);
      code.push_back({Kind::jump, -sizeOf(once) - 1});
    }
    for (std::size_t k = least; most && k < *most; ++k) {
      const auto rest = static_cast<std::ptrdiff_t>(*most - k) * (sizeOf(once) + 1);
      code.push_back(split(1, rest, isLazy));
      append(code, once);
    }
    return code;
  }

  /// Reads "{2}", "{2,}" or "{2,3}". Any other '{' is a letter.
  bool counts(std::size_t& least, std::optional<std::size_t>& most) {
    const std::size_t before = at_;
    const auto number = [&]() -> std::optional<std::size_t> {
      std::string digits;
      while (!atEnd() && pattern_[at_] >= U'0' && pattern_[at_] <= U'9') digits += static_cast<char>(pattern_[at_++]);
      if (digits.empty()) return std::nullopt;
      std::size_t value = Regexp::kMaxSteps;  // more is too long in any case
      if (digits.size() < 6) std::from_chars(digits.data(), digits.data() + digits.size(), value);
      return value;
    };
    const bool isOpen = take(U"{");
    const auto first = isOpen ? number() : std::nullopt;
    const bool hasComma = first && take(U",");
    const auto second = hasComma ? number() : first;
    if (first && take(U"}")) {
      least = *first;
      most = second;
      return true;
    }
    at_ = before;
    return false;
  }

  /// What follows a backslash.
  RegexpSet escaped() {
    if (atEnd()) {
      fail("ends with a backslash");
      return {};
    }
    const char32_t kind = pattern_[at_++];
    switch (kind) {
      case U'd':
      case U'D':
        return {{{U'0', U'9'}}, kind == U'D'};
      case U'w':
      case U'W':
        return {{{U'0', U'9'}, {U'A', U'Z'}, {U'_', U'_'}, {U'a', U'z'}}, kind == U'W'};
      case U's':
      case U'S':
        return {{{U'\t', U'\r'}, {U' ', U' '}}, kind == U'S'};
      default:
        break;
    }
    const bool isWord =
        (kind >= U'0' && kind <= U'9') || (kind >= U'A' && kind <= U'Z') || (kind >= U'a' && kind <= U'z');
    if (isWord) fail(std::string("has '\\") + static_cast<char>(kind) + "', which is not supported");
    return {{{kind, kind}}};
  }

  /// What follows a '[', up to its ']'.
  RegexpSet set() {
    RegexpSet result;
    result.isNegated = take(U"^");
    for (bool isFirst = true; isFirst || !sees(U']'); isFirst = false) {
      if (atEnd()) {
        fail("has a '[' without its ']'");
        return result;
      }
      if (isAhead(U"[:")) fail("has '[:', which is not supported");
      const RegexpSet from = setPart();
      const bool isRange = sees(U'-') && !isAhead(U"-]") && isOne(from);
      if (isRange) ++at_;
      if (isRange && atEnd()) continue;
      const RegexpSet to = isRange ? setPart() : from;
      if (isRange && (!isOne(to) || to.ranges[0].first < from.ranges[0].first)) fail("has a set with a wrong range");
      if (!fault_.empty()) return result;
      if (isRange) {
        result.ranges.push_back({from.ranges[0].first, to.ranges[0].first});
      } else {
        result.ranges.insert(result.ranges.end(), from.ranges.begin(), from.ranges.end());
      }
    }
    take(U"]");
    return result;
  }

  static bool isOne(const RegexpSet& set) {
    return set.ranges.size() == 1 && set.ranges[0].first == set.ranges[0].second;
  }

  RegexpSet setPart() {
    if (!take(U"\\")) {
      const char32_t letter = pattern_[at_++];
      return {{{letter, letter}}};
    }
    RegexpSet result = escaped();
    if (result.isNegated) fail("has \\D, \\W or \\S in a set, which is not supported");
    return result;
  }

  std::u32string pattern_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::string fault_;
  Regexp result_;
};

tl::expected<Regexp, std::string> Regexp::parse(std::string_view pattern) { return RegexpParser(pattern).run(); }

}  // namespace lgs::tiled
