#include "oracle/check/shrink.h"

#include "oracle/trace/step.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <unordered_set>

namespace lgs::oracle {
namespace {

using Polygon = std::vector<LocalPoint>;
using Clock = std::chrono::steady_clock;

// Every polygon gets a name of its own, p1, p2, … in order; so an add can go without touching another's removal. The
// letters of a name decide which door its edit takes (step.h): they stay, or they go.
Trace renamed(Trace trace, bool withLetters) {
  std::map<std::string, std::string> nameOf;
  std::size_t count = 0;
  for (Edit& edit : trace.edits) {
    if (edit.kind == Edit::Kind::add)
      nameOf[edit.name] = fmt::format("p{}{}", ++count, withLetters ? lettersOf(edit.name) : "");
    if (edit.kind != Edit::Kind::commit) edit.name = nameOf[edit.name];
  }
  return trace;
}

// Drops the removals of polygons that are not there.
void dropOrphans(Trace& trace) {
  std::unordered_set<std::string> alive;
  std::erase_if(trace.edits, [&](const Edit& edit) {
    if (edit.kind == Edit::Kind::add) alive.insert(edit.name);
    return edit.kind == Edit::Kind::remove && alive.erase(edit.name) == 0;
  });
}

// How much there is to say about a coordinate: 0 for 0, 1 for 1, 2 for a half, … 17 for an odd number of units.
int costOf(std::int32_t v) {
  if (v == 0 || v == kUnitsPerCell) return v == 0 ? 0 : 1;
  int cost = 18;
  for (std::int32_t units = std::gcd(v, kUnitsPerCell); units > 0; units /= 2) --cost;
  return cost;
}

// A polygon is simpler than another if it has fewer vertices or, with as many, rounder coordinates.
std::size_t costOf(const Polygon& polygon) {
  std::size_t cost = 1'000 * polygon.size();
  for (const LocalPoint& p : polygon) cost += static_cast<std::size_t>(costOf(p.x) + costOf(p.y));
  return cost;
}

std::vector<std::int32_t> simplerCoordinates(std::int32_t v) {
  std::vector<std::int32_t> result;
  for (std::int32_t step = kUnitsPerCell; step >= 2; step /= 2) {
    const std::int32_t below = v / step * step;
    for (const std::int32_t candidate : {below, below + step}) {
      if (candidate <= kUnitsPerCell && costOf(candidate) < costOf(v)) result.push_back(candidate);
    }
  }
  return result;
}

std::vector<Polygon> simplerPolygons(const Polygon& polygon) {
  constexpr std::int32_t U = kUnitsPerCell;
  std::vector<Polygon> result{{{0, 0}, {U, 0}, {U, U}, {0, U}},
                              {{0, 0}, {U, 0}, {U, U}},
                              {{0, 0}, {U, 0}, {0, U}},
                              {{0, 0}, {U, U}, {0, U}},
                              {{U, 0}, {U, U}, {0, U}}};
  for (std::size_t k = 0; k < polygon.size() && polygon.size() > 3; ++k) {
    result.push_back(polygon);
    result.back().erase(result.back().begin() + static_cast<std::ptrdiff_t>(k));
  }
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    for (const auto axis : {&LocalPoint::x, &LocalPoint::y}) {
      for (const std::int32_t v : simplerCoordinates(polygon[k].*axis)) {
        result.push_back(polygon);
        result.back()[k].*axis = v;
      }
    }
  }
  std::erase_if(result, [&](const Polygon& candidate) { return costOf(candidate) >= costOf(polygon); });
  return result;
}

class Shrinker {
 public:
  Shrinker(Trace trace, const StillFails& stillFails, std::chrono::milliseconds budget)
      : best_(std::move(trace)), stillFails_(stillFails), deadline_(Clock::now() + budget) {}

  Trace run() {
    rename();
    for (bool progress = true; progress && !timeIsUp();) {
      progress = dropEdits();
      progress = simplifyPolygons() || progress;
      progress = simplifyBlocks() || progress;
      progress = moveCells() || progress;
    }
    rename();
    return std::move(best_);
  }

 private:
  bool timeIsUp() const { return Clock::now() >= deadline_; }

  bool attempt(Trace candidate) {
    if (timeIsUp() || candidate == best_ || !stillFails_(candidate)) return false;
    best_ = std::move(candidate);
    return true;
  }

  // Plain doors, or else the plain door of as many edits as can do with it.
  void rename() {
    if (attempt(renamed(best_, false))) return;
    attempt(renamed(best_, true));
    for (std::size_t k = 0; k < best_.edits.size(); ++k) {
      const std::string name = best_.edits[k].name;
      if (best_.edits[k].kind != Edit::Kind::add || lettersOf(name).empty()) continue;
      Trace candidate = best_;
      for (Edit& edit : candidate.edits)
        if (edit.name == name) edit.name.resize(name.size() - lettersOf(name).size());
      attempt(std::move(candidate));
    }
  }

  bool dropEdits() {
    bool progress = false;
    for (std::size_t length = std::max<std::size_t>(best_.edits.size() / 2, 1); length > 0; length /= 2) {
      // From the end: what comes later depends on what came before.
      for (std::size_t end = best_.edits.size(); end > 0 && !timeIsUp();) {
        end = std::min(end, best_.edits.size());
        const std::size_t begin = end > length ? end - length : 0;
        Trace candidate = best_;
        candidate.edits.erase(candidate.edits.begin() + static_cast<std::ptrdiff_t>(begin),
                              candidate.edits.begin() + static_cast<std::ptrdiff_t>(end));
        dropOrphans(candidate);
        progress = attempt(std::move(candidate)) || progress;
        end = begin;
      }
    }
    return progress;
  }

  bool simplifyPolygons() {
    bool progress = false;
    for (std::size_t k = 0; k < best_.edits.size(); ++k) {
      if (best_.edits[k].kind != Edit::Kind::add) continue;
      while (simplifyPolygon(k)) progress = true;
    }
    return progress;
  }

  bool simplifyPolygon(std::size_t k) {
    for (Polygon& polygon : simplerPolygons(best_.edits[k].polygon.vertices)) {
      Trace candidate = best_;
      candidate.edits[k].polygon.vertices = std::move(polygon);
      if (attempt(std::move(candidate))) return true;
    }
    return false;
  }

  bool simplifyBlocks() {
    bool progress = false;
    for (std::size_t drop = 0; drop < best_.preserve.pairs().size();) {
      Trace candidate = best_;
      candidate.preserve = {};
      for (std::size_t k = 0; k < best_.preserve.pairs().size(); ++k) {
        const auto& [a, b] = best_.preserve.pairs()[k];
        if (k != drop) candidate.preserve.add(a, b);
      }
      if (attempt(std::move(candidate))) {
        progress = true;
      } else {
        ++drop;
      }
    }
    progress = renumberBlocks() || progress;
    for (std::size_t k = 0; k < best_.edits.size(); ++k) {
      if (best_.edits[k].kind != Edit::Kind::add || best_.edits[k].polygon.block == 1) continue;
      Trace candidate = best_;
      candidate.edits[k].polygon.block = 1;
      progress = attempt(std::move(candidate)) || progress;
    }
    return progress;
  }

  // Blocks become 1, 2, … in order of first use.
  bool renumberBlocks() {
    Trace candidate = best_;
    std::map<Block, Block> numberOf;
    const auto number = [&](Block block) {
      return numberOf.try_emplace(block, static_cast<Block>(numberOf.size() + 1)).first->second;
    };
    for (Edit& edit : candidate.edits) {
      if (edit.kind == Edit::Kind::add) edit.polygon.block = number(edit.polygon.block);
    }
    candidate.preserve = {};
    for (const auto& [a, b] : best_.preserve.pairs()) {
      const Block first = number(a);
      candidate.preserve.add(first, number(b));
    }
    return attempt(std::move(candidate));
  }

  bool moveCells() {
    bool progress = false;
    for (const auto axis : {&Cell::i, &Cell::j}) {
      std::set<std::int32_t> used;
      for (const Edit& edit : best_.edits) {
        if (edit.kind == Edit::Kind::add) used.insert(edit.polygon.cell.*axis);
      }
      // The first line of cells goes to 0, or else to -1, so that a border of chunks comes after it; each further one next
      // to the one before it; what lies beyond moves along. From the last to the first, so that `used` stays true.
      for (auto line = used.rbegin(); line != used.rend(); ++line) {
        const auto before = std::next(line);
        if (before != used.rend()) {
          progress = moveLines(axis, *line, *before + 1) || progress;
        } else {
          progress = moveLines(axis, *line, 0) || (*line != 0 && moveLines(axis, *line, -1)) || progress;
        }
      }
    }
    return progress;
  }

  // Moves the cells from one line on so that this line comes to lie at `target`.
  bool moveLines(std::int32_t Cell::*axis, std::int32_t line, std::int32_t target) {
    if (line == target) return false;
    Trace candidate = best_;
    for (Edit& edit : candidate.edits) {
      std::int32_t& index = edit.polygon.cell.*axis;
      if (edit.kind == Edit::Kind::add && index >= line) index -= line - target;
    }
    return attempt(std::move(candidate));
  }

  Trace best_;
  const StillFails& stillFails_;
  Clock::time_point deadline_;
};

}  // namespace

Trace shrink(Trace trace, const StillFails& stillFails, std::chrono::milliseconds budget) {
  return Shrinker(std::move(trace), stillFails, budget).run();
}

}  // namespace lgs::oracle
