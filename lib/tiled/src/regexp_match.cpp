// Matching goes through a text once, with all ways through the expression side by side, the preferred ones first.
#include "regexp.h"

#include <algorithm>

namespace lgs::tiled {
namespace {

using Slots = std::array<std::size_t, 2 * Regexp::kKept>;
constexpr std::size_t kUnset = ~std::size_t{0};

struct Way {
  std::size_t step = 0;
  Slots slots;
};

bool isIn(const RegexpSet& set, char32_t letter) {
  const bool isThere = std::any_of(set.ranges.begin(), set.ranges.end(),
                                   [&](const auto& range) { return range.first <= letter && letter <= range.second; });
  return isThere != set.isNegated;
}

/// The ways that stand at one letter of the text. At each step there is one at most, the preferred one.
class Ways {
 public:
  Ways(const std::vector<RegexpStep>& steps, std::size_t size)
      : steps_(&steps), size_(size), known_(steps.size() + 1) {}

  const std::vector<Way>& all() const { return ways_; }

  void clear() {
    ways_.clear();
    std::fill(known_.begin(), known_.end(), false);
  }

  /// Follows a way up to where it needs a letter, or has matched.
  void add(Way from, std::size_t at) {
    open_.push_back(from);
    while (!open_.empty()) {
      Way way = open_.back();
      open_.pop_back();
      if (known_[way.step]) continue;
      known_[way.step] = true;
      if (way.step == steps_->size() || (*steps_)[way.step].kind == RegexpStep::Kind::letter) {
        ways_.push_back(way);
      } else {
        follow(way, at);
      }
    }
  }

 private:
  void follow(Way way, std::size_t at) {
    const RegexpStep& step = (*steps_)[way.step];
    const auto go = [&](std::ptrdiff_t by) {
      Way next = way;
      next.step += static_cast<std::size_t>(by);
      open_.push_back(next);
    };
    switch (step.kind) {
      case RegexpStep::Kind::split:
        go(step.second);
        return go(step.first);
      case RegexpStep::Kind::jump:
        return go(step.first);
      case RegexpStep::Kind::save:
        way.slots[step.number] = at;
        return go(1);
      case RegexpStep::Kind::begin:
        return at == 0 ? go(1) : void();
      case RegexpStep::Kind::end:
        return at == size_ ? go(1) : void();
      case RegexpStep::Kind::letter:
        return;
    }
  }

  const std::vector<RegexpStep>* steps_;
  std::size_t size_;
  std::vector<bool> known_;
  std::vector<Way> ways_, open_;
};

/// The length of the letter that a text begins with, and the letter.
std::pair<std::size_t, char32_t> firstLetter(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const std::size_t length = byte(0) < 0x80 ? 1 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
  constexpr char32_t kNoLetter = 0x110000;
  if (length == 1) return {1, byte(0)};
  if (byte(0) < 0xC0 || text.size() < length) return {1, kNoLetter + byte(0)};
  char32_t letter = byte(0) & (0xFFU >> (length + 1));
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xC0) != 0x80) return {1, kNoLetter + byte(0)};
    letter = letter << 6 | (byte(k) & 0x3FU);
  }
  return {length, letter};
}

}  // namespace

Letters::Letters(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto [length, letter] = firstLetter(text.substr(at));
    letters += letter;
    offsets.push_back(at);
    at += length;
  }
  offsets.push_back(text.size());
}

std::optional<std::array<std::string, Regexp::kKept>> Regexp::match(std::string_view text) const {
  const Letters all(text);
  const std::size_t size = all.letters.size();
  Ways now(steps_, size), next(steps_, size);
  std::optional<Slots> found;
  Slots none;
  none.fill(kUnset);
  for (std::size_t at = 0; at <= size; ++at) {
    if (!found) now.add({0, none}, at);
    next.clear();
    for (const Way& way : now.all()) {
      if (way.step == steps_.size()) {
        found = way.slots;
        break;  // those that follow are less preferred
      }
      if (at < size && isIn(sets_[steps_[way.step].number], all.letters[at]))
        next.add({way.step + 1, way.slots}, at + 1);
    }
    std::swap(now, next);
  }
  if (!found) return std::nullopt;
  std::array<std::string, kKept> result;
  for (std::size_t k = 0; k < kKept; ++k) {
    const std::size_t begin = (*found)[2 * k], end = (*found)[2 * k + 1];
    if (begin == kUnset || end == kUnset) continue;
    result[k] = text.substr(all.offsets[begin], all.offsets[end] - all.offsets[begin]);
  }
  return result;
}

}  // namespace lgs::tiled
