// Law 6 of an engine that reports what changed: it reports nothing else. A segment that is removed and comes back as it was
// did not change, unless it belongs to another polygon now.
#include "oracle/check/laws/list.h"
#include "oracle/reference/vector.h"
#include "oracle/reference/words.h"

#include <fmt/format.h>
#include <algorithm>
#include <string>
#include <utility>

namespace lgs::oracle {
namespace {

// Whether two segments share a piece, in one direction. Nothing overflows, whatever an engine puts out.
bool overlap(Point a, Point b, Point u, Point v) {
  const Vector along = direction(b - a), aside = direction(u - a), back{-along.x, -along.y};
  if (direction(v - u) != along || (aside != Vector{} && aside != along && aside != back)) return false;
  const auto axis = along.x != 0 ? &Point::x : &Point::y;
  const auto [low, high] = std::minmax(a.*axis, b.*axis);
  const auto [from, to] = std::minmax(u.*axis, v.*axis);
  return std::max(low, from) < std::min(high, to);
}

bool owns(const ScenePolygon& polygon, const OutlineSegment& s) {
  const auto& [cell, block, vertices] = polygon;
  const std::size_t n = vertices.size();
  for (std::size_t k = 0; k < n; ++k)
    if (overlap(s.start, s.end, toWorld(cell, vertices[k]), toWorld(cell, vertices[(k + 1) % n]))) return true;
  return false;
}

class MinimalityLaw : public Law {
 public:
  Found afterCommit(Seen& seen) override {
    const Delta* const delta = seen.engine.delta();
    if (delta == nullptr) return std::nullopt;
    Outline needless = delta->unchanged(), remade = delta->remade();
    for (const std::string& name : seen.added) {
      const ScenePolygon owner = seen.model().standing()[name];
      std::erase_if(remade, [&](const OutlineSegment& s) { return owns(owner, s); });
    }
    const char* const what = needless.empty() ? "removed and added, but is as it was: " : "changed, but is as it was: ";
    if (needless.empty()) needless = std::move(remade);
    if (needless.empty()) return std::nullopt;
    const OutlineSegment& s = needless.front();
    return seen.mismatch(
        Mismatch::Kind::needless,
        fmt::format("{}{}, {}\n", what, inWords(s.start, s.end), placeInWords(s.start, s.end)) + seen.told(),
        std::move(needless));
  }
};

}  // namespace

std::unique_ptr<Law> laws::minimality() { return std::make_unique<MinimalityLaw>(); }

}  // namespace lgs::oracle
