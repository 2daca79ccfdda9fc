#include "oracle/check/shrink.h"

#include "oracle/check/simpler.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <set>
#include <unordered_set>

namespace lgs::oracle {
namespace {

// Every polygon gets a name of its own, p1, p2, … in order; so an add can go without touching another's removal. The
// ways of the edits stay, or they become plain.
Trace renamed(Trace trace, bool withWays) {
  std::map<std::string, std::string> nameOf;
  std::size_t count = 0;
  for (Edit& edit : trace.edits) {
    if (!withWays) edit.way = Edit::plainWay(edit.kind);
    if (edit.kind == Edit::Kind::add) nameOf[edit.name] = fmt::format("p{}", ++count);
    if (edit.kind != Edit::Kind::commit) edit.name = nameOf[edit.name];
  }
  return trace;
}

// The block of an edit that has one.
Block* blockOf(Edit& edit) {
  if (edit.kind == Edit::Kind::add) return &edit.polygon.block;
  const bool paints = edit.kind == Edit::Kind::brush && edit.brush.deed != BrushEdit::Deed::carve;
  return paints ? &edit.brush.block : nullptr;
}

// Drops the removals of polygons that are not there.
void dropOrphans(Trace& trace) {
  std::unordered_set<std::string> alive;
  std::erase_if(trace.edits, [&](const Edit& edit) {
    if (edit.kind == Edit::Kind::add) alive.insert(edit.name);
    return edit.kind == Edit::Kind::remove && alive.erase(edit.name) == 0;
  });
}

}  // namespace

const std::vector<ShrinkWalk::Pass>& ShrinkWalk::passes() {
  using W = ShrinkWalk;
  static const std::vector<Pass> kPasses{
      &W::rename,   &W::dropEdits,   &W::simplifyPolygons, &W::simplifyBrushes, &W::dropPairs, &W::renumberBlocks,
      &W::oneBlock, &W::moveColumns, &W::moveRows,         &W::plainWays,       &W::rename};
  return kPasses;
}

std::optional<Trace> ShrinkWalk::next() {
  constexpr std::size_t kFirstOfRound = 1;
  const std::size_t endOfRound = passes().size() - 1;
  while (pass_ < passes().size()) {
    if (auto candidate = (this->*passes()[pass_])()) {
      if (*candidate != best_) return candidate;
      continue;
    }
    ++pass_;
    if (pass_ == endOfRound && isSmaller_) pass_ = kFirstOfRound;
    if (pass_ == kFirstOfRound) isSmaller_ = false;
    at_ = variant_ = 0;
    length_ = std::max<std::size_t>(best_.edits.size() / 2, 1);
  }
  return std::nullopt;
}

void ShrinkWalk::accept(Trace candidate) {
  at_ -= best_.edits.size() - candidate.edits.size();  // what was dropped is no longer behind
  variant_ = 0;
  isSmaller_ = true;
  best_ = std::move(candidate);
}

std::optional<Trace> ShrinkWalk::rename() {
  if (variant_ == 2) return std::nullopt;
  return renamed(best_, variant_++ != 0);
}

// One edit after the other is made in the plain way; or at least by itself, or without a detour and all that.
std::optional<Trace> ShrinkWalk::plainWays() {
  for (; at_ < best_.edits.size(); ++at_, variant_ = 0) {
    const Way way = best_.edits[at_].way;
    const std::array ways{Edit::plainWay(best_.edits[at_].kind), Way{way.door, way.detour, false, way.number},
                          Way{way.door, Detour::none, way.joins, 0}};
    if (variant_ == ways.size() || way == ways[0]) continue;
    Trace candidate = best_;
    candidate.edits[at_].way = ways[variant_++];
    return candidate;
  }
  return std::nullopt;
}

std::optional<Trace> ShrinkWalk::dropEdits() {
  const std::size_t size = best_.edits.size();
  if (at_ >= size) {
    at_ = 0;
    length_ /= 2;
  }
  if (length_ == 0 || size == 0) return std::nullopt;
  // From the end: what comes later depends on what came before.
  const std::size_t end = size - at_;
  const std::size_t begin = end > length_ ? end - length_ : 0;
  at_ = size - begin;
  Trace candidate = best_;
  candidate.edits.erase(candidate.edits.begin() + static_cast<std::ptrdiff_t>(begin),
                        candidate.edits.begin() + static_cast<std::ptrdiff_t>(end));
  dropOrphans(candidate);
  return candidate;
}

// What edits of a kind are made with, in all the simpler forms that there are of it.
template <class Part, class Simpler>
std::optional<Trace> ShrinkWalk::simplify(Edit::Kind kind, Part part, Simpler simpler) {
  for (; at_ < best_.edits.size(); ++at_, variant_ = 0) {
    if (best_.edits[at_].kind != kind) continue;
    while (variant_ < variantsOf(part(best_.edits[at_]))) {
      auto simple = simpler(part(best_.edits[at_]), variant_++);
      if (!simple) continue;
      Trace candidate = best_;
      part(candidate.edits[at_]) = std::move(*simple);
      return candidate;
    }
  }
  return std::nullopt;
}

std::optional<Trace> ShrinkWalk::simplifyPolygons() {
  return simplify(
      Edit::Kind::add, [](Edit & edit) -> auto& { return edit.polygon.vertices; }, simplerPolygon);
}

std::optional<Trace> ShrinkWalk::simplifyBrushes() {
  return simplify(
      Edit::Kind::brush, [](Edit & edit) -> auto& { return edit.brush; }, simplerBrush);
}

std::optional<Trace> ShrinkWalk::dropPairs() {
  if (variant_++ != 0) {
    ++at_;
    variant_ = 1;
  }
  const auto& pairs = best_.preserve.pairs();
  if (at_ >= pairs.size()) return std::nullopt;
  Trace candidate = best_;
  candidate.preserve = {};
  std::size_t k = 0;
  for (const auto& [a, b] : pairs)
    if (k++ != at_) candidate.preserve.add(a, b);
  return candidate;
}

// Blocks become 1, 2, … in order of first use.
std::optional<Trace> ShrinkWalk::renumberBlocks() {
  if (variant_++ != 0) return std::nullopt;
  Trace candidate = best_;
  std::map<Block, Block> numberOf;
  const auto number = [&](Block block) {
    return numberOf.try_emplace(block, static_cast<Block>(numberOf.size() + 1)).first->second;
  };
  for (Edit& edit : candidate.edits) {
    if (Block* const block = blockOf(edit)) *block = number(*block);
  }
  candidate.preserve = {};
  for (const auto& [a, b] : best_.preserve.pairs()) {
    const Block first = number(a);
    candidate.preserve.add(first, number(b));
  }
  return candidate;
}

std::optional<Trace> ShrinkWalk::oneBlock() {
  while (at_ < best_.edits.size() && blockOf(best_.edits[at_]) == nullptr) ++at_;
  if (at_ >= best_.edits.size()) return std::nullopt;
  Trace candidate = best_;
  *blockOf(candidate.edits[at_++]) = 1;
  return candidate;
}

// Moves the first line of cells to 0, or else to -1, so that a border of chunks follows it. Then it moves each line
// next to the one before it. It goes from the last line to the first, so that earlier lines stay where they are.
std::optional<Trace> ShrinkWalk::moveCells(std::int32_t Cell::*axis) {
  std::int64_t Point::*const coordinate = axis == &Cell::i ? &Point::x : &Point::y;
  std::set<std::int32_t> used;
  for (const Edit& edit : best_.edits) {
    if (edit.kind == Edit::Kind::add) used.insert(edit.polygon.cell.*axis);
    for (const auto& ring : edit.brush.rings)
      for (const Point p : ring) used.insert(cellAt(p).*axis);
  }
  const std::vector<std::int32_t> lines(used.begin(), used.end());
  const auto movedTo = [&](std::int32_t line, std::int32_t target) {
    Trace candidate = best_;
    for (Edit& edit : candidate.edits) {
      std::int32_t& index = edit.polygon.cell.*axis;
      if (edit.kind == Edit::Kind::add && index >= line) index -= line - target;
      for (auto& ring : edit.brush.rings)
        for (Point& p : ring)
          if (cellAt(p).*axis >= line) p.*coordinate -= std::int64_t{line - target} * kUnitsPerCell;
    }
    return candidate;
  };
  if (at_ >= lines.size()) return std::nullopt;
  const std::size_t k = lines.size() - 1 - at_;
  if (k != 0) {
    ++at_;
    return movedTo(lines[k], lines[k - 1] + 1);
  }
  if (variant_ == 2 || lines[0] == 0) return std::nullopt;
  return movedTo(lines[0], variant_++ == 0 ? 0 : -1);
}

Trace shrink(Trace trace, const StillFails& stillFails, std::chrono::milliseconds budget) {
  const auto deadline = std::chrono::steady_clock::now() + budget;
  ShrinkWalk walk(std::move(trace));
  while (std::chrono::steady_clock::now() < deadline) {
    auto candidate = walk.next();
    if (!candidate) break;
    if (stillFails(*candidate)) walk.accept(std::move(*candidate));
  }
  return walk.best();
}

}  // namespace lgs::oracle
