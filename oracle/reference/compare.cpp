#include "oracle/reference/compare.h"

#include "oracle/reference/vector.h"
#include "oracle/reference/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

namespace lgs::oracle {
namespace {

using Kind = Difference::Kind;

std::pair<Point, Point> endsOf(const OutlineSegment& s) { return {s.start, s.end}; }

// The outline's segments that start at a point.
std::span<const OutlineSegment> leaving(const Outline& outline, Point start) {
  const auto first = std::partition_point(outline.begin(), outline.end(), [&](auto& s) { return s.start < start; });
  const auto last = std::partition_point(first, outline.end(), [&](auto& s) { return s.start == start; });
  return {first, last};
}

bool has(const Outline& outline, Point start, Point end) {
  const std::pair ends(start, end);
  const auto at = std::ranges::lower_bound(outline, ends, {}, endsOf);
  return at != outline.end() && endsOf(*at) == ends;
}

// The outline's segment that leaves from the same start in the same direction, but ends elsewhere.
const OutlineSegment* otherLength(const Outline& outline, const OutlineSegment& segment) {
  for (const OutlineSegment& s : leaving(outline, segment.start)) {
    if (s.end != segment.end && direction(s.end - s.start) == direction(segment.end - segment.start)) return &s;
  }
  return nullptr;
}

// Whether v is shorter than w. Both have the same direction, so the sum of their components tells.
bool isShorter(Vector v, Vector w) { return std::abs(v.x) + std::abs(v.y) < std::abs(w.x) + std::abs(w.y); }

std::string noteOnMissing(const OutlineSegment& missing, const Outline& expected, const Outline& actual) {
  if (const OutlineSegment* other = otherLength(actual, missing)) {
    return isShorter(missing.end - missing.start, other->end - other->start)
               ? fmt::format("not cut at {}", inWords(missing.end))
               : fmt::format("cut at {}, where it should go on", inWords(other->end));
  }
  const bool reverseIsThere = has(actual, missing.end, missing.start);
  if (has(expected, missing.end, missing.start)) {
    return reverseIsThere ? "an overlap to be preserved, of which only the other side is there"
                          : "an overlap to be preserved, cancelled";
  }
  return reverseIsThere ? "it is there in the opposite direction" : "";
}

std::string noteOnExtra(const OutlineSegment& extra, const Outline& expected, const Outline& actual) {
  if (extra.start == extra.end) return "it has no length";
  if (has(expected, extra.start, extra.end)) return "it is there twice";
  if (const OutlineSegment* other = otherLength(expected, extra)) {
    return isShorter(other->end - other->start, extra.end - extra.start)
               ? fmt::format("it should be cut at {}", inWords(other->end))
               : fmt::format("it should go on to {}", inWords(other->end));
  }
  if (has(expected, extra.end, extra.start)) return "only the opposite direction should be there";
  return has(actual, extra.end, extra.start) ? "an overlap that should have been cancelled" : "";
}

// A right ghost is the far end of a segment of the outline.
std::string noteOnGhost(bool ghostIsThere) { return ghostIsThere ? "" : "no segment of the outline leads there"; }

void compareSame(const OutlineSegment& e, const OutlineSegment& a, const Outline& actual,
                 std::vector<Difference>& found) {
  if (e.ghost1 != a.ghost1) {
    found.push_back({Kind::ghost1, e, a, noteOnGhost(!a.ghost1 || has(actual, *a.ghost1, a.start))});
  }
  if (e.ghost2 != a.ghost2) {
    found.push_back({Kind::ghost2, e, a, noteOnGhost(!a.ghost2 || has(actual, a.end, *a.ghost2))});
  }
  if (e.block != a.block) found.push_back({Kind::block, e, a, ""});
}

// Walks through both outlines in their order. Calls missing(e), extra(a) or same(e, a) with indices into the two.
template <class Missing, class Extra, class Same>
void walkBoth(const Outline& expected, const Outline& actual, Missing missing, Extra extra, Same same) {
  std::size_t e = 0;
  std::size_t a = 0;
  while (e < expected.size() || a < actual.size()) {
    if (a == actual.size() || (e < expected.size() && endsOf(expected[e]) < endsOf(actual[a]))) {
      missing(e++);
    } else if (e == expected.size() || endsOf(actual[a]) < endsOf(expected[e])) {
      extra(a++);
    } else {
      same(e++, a++);
    }
  }
}

// A missing or extra segment explains the wrong ghosts around it, so it comes first.
void sortForReading(std::vector<Difference>& found) {
  const auto key = [](const Difference& d) {
    return std::pair(d.kind != Kind::missing && d.kind != Kind::extra, endsOf(d.segment()));
  };
  std::stable_sort(found.begin(), found.end(), [&](auto& l, auto& r) { return key(l) < key(r); });
}

}  // namespace

std::vector<Difference> compare(const Outline& expected, const Outline& actual) {
  std::vector<Difference> found;
  walkBoth(
      expected, actual,
      [&](std::size_t e) {
        found.push_back({Kind::missing, expected[e], {}, noteOnMissing(expected[e], expected, actual)});
      },
      [&](std::size_t a) {
        found.push_back({Kind::extra, {}, actual[a], noteOnExtra(actual[a], expected, actual)});
      },
      [&](std::size_t e, std::size_t a) { compareSame(expected[e], actual[a], actual, found); });
  sortForReading(found);
  return found;
}

std::vector<Difference> compare(const OwnedOutline& expected, const OwnedOutline& actual) {
  std::vector<Difference> found = compare(expected.outline, actual.outline);
  if (found.empty() && expected.owner == actual.owner) return found;
  const auto ignore = [](std::size_t) {};
  walkBoth(expected.outline, actual.outline, ignore, ignore, [&](std::size_t e, std::size_t a) {
    if (expected.owner[e] == actual.owner[a]) return;
    found.push_back({Kind::owner, expected.outline[e], actual.outline[a],
                     fmt::format("expected polygon {} of the scene, got {}", expected.owner[e], actual.owner[a])});
  });
  sortForReading(found);
  return found;
}

std::string describe(const Difference& difference) {
  const OutlineSegment& s = difference.segment();
  const std::string segment = fmt::format("{}, {}{}", inWords(s.start, s.end), placeInWords(s.start, s.end),
                                          s.block == 0 ? "" : fmt::format(", block {}", s.block));
  std::string text;
  switch (difference.kind) {
    case Kind::missing:
      text = "missing segment: " + segment;
      break;
    case Kind::extra:
      text = "extra segment: " + segment;
      break;
    case Kind::ghost1:
      text = fmt::format("wrong ghost1 at {}: expected {}, got {}; segment {}", inWords(s.start),
                         ghostInWords(s.ghost1), ghostInWords(difference.actual->ghost1), segment);
      break;
    case Kind::ghost2:
      text = fmt::format("wrong ghost2 at {}: expected {}, got {}; segment {}", inWords(s.end), ghostInWords(s.ghost2),
                         ghostInWords(difference.actual->ghost2), segment);
      break;
    case Kind::block:
      text = fmt::format("wrong block: expected {}, got {}; segment {}", s.block, difference.actual->block, segment);
      break;
    case Kind::owner:
      text = "wrong owner: segment " + segment;
      break;
  }
  return difference.note.empty() ? text : text + ": " + difference.note;
}

std::string describe(const std::vector<Difference>& differences, std::size_t most) {
  std::string text;
  for (std::size_t k = 0; k < std::min(most, differences.size()); ++k) text += describe(differences[k]) + "\n";
  if (differences.size() > most) text += fmt::format("... and {} more\n", differences.size() - most);
  return text;
}

Outline withUnknownLinksOf(const Outline& actual, Outline expected, const std::vector<KnownLinks>& known) {
  const auto ignore = [](std::size_t) {};
  walkBoth(expected, actual, ignore, ignore, [&](std::size_t e, std::size_t a) {
    if (!known[e].ghost1) expected[e].ghost1 = actual[a].ghost1;
    if (!known[e].ghost2) expected[e].ghost2 = actual[a].ghost2;
  });
  return expected;
}

}  // namespace lgs::oracle
