#include "oracle/check/shrink.h"

#include "oracle/check/simpler.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <set>
#include <unordered_set>

namespace lgs::oracle {
namespace {

// All calls, those in groups too.
template <class Visit>
void forEachCall(std::vector<Call>& calls, Visit visit) {
  for (Call& call : calls) {
    visit(call);
    forEachCall(call.group, visit);
  }
}

// The blocks of a call that it gives to something.
std::vector<Block*> blocksOf(Call& call) {
  std::vector<Block*> blocks;
  if (call.kind != Call::Kind::shape)
    for (Coming& coming : call.comes) blocks.push_back(&coming.block);
  const bool paints = call.kind == Call::Kind::brush && call.brush.deed != BrushEdit::Deed::carve;
  if (paints) blocks.push_back(&call.brush.block);
  return blocks;
}

// Drops the removals of polygons that are not there.
void dropOrphans(Trace& trace) {
  std::unordered_set<std::string> alive;
  std::erase_if(trace.calls, [&](const Call& call) {
    for (const Coming& coming : call.comes) alive.insert(coming.names.begin(), coming.names.end());
    return call.kind == Call::Kind::remove && call.goes[0].how == Named::How::name && alive.erase(call.name()) == 0;
  });
}

// What a call may become: all that is simpler; and an unnamed one add in plain form.
std::vector<Call> formsOf(const Call& call, std::size_t at) {
  std::vector<Call> forms = simpler(call);
  const bool isOfOne = call.comes.size() == 1 && call.comes[0].shape.size() == 1 && call.comes[0].id == 0;
  if (call.kind != Call::Kind::add &&
      (call.kind == Call::Kind::addShape || call.kind == Call::Kind::addMany || call.kind == Call::Kind::replace) &&
      isOfOne) {
    Call add = call;
    add.kind = Call::Kind::add;
    forms.insert(forms.begin(), tidied(std::move(add)));
  }
  if (call.kind == Call::Kind::add && call.name().empty()) {
    Call named = call;
    named.comes[0].names = {fmt::format("q{}", at)};
    forms.push_back(std::move(named));
  }
  return forms;
}

}  // namespace

// Every polygon with a name gets one of its own, p1, p2, … in order; so an add can go without touching another's
// removal.
Trace renamed(Trace trace) {
  std::map<std::string, std::string> nameOf;
  std::size_t count = 0;
  forEachCall(trace.calls, [&](Call& call) {
    for (Named& named : call.goes)
      if (named.how == Named::How::name && nameOf.contains(named.name)) named.name = nameOf[named.name];
    for (Coming& coming : call.comes)
      for (std::string& name : coming.names) {
        std::string next = fmt::format("p{}", ++count);
        nameOf[name] = next;
        name = std::move(next);
      }
  });
  return trace;
}

Trace builtAtOnce(Trace trace) {
  trace = renamed(std::move(trace));
  const auto isRemoval = [](const Call& c) {
    return c.kind == Call::Kind::remove && c.goes[0].how == Named::How::name;
  };
  std::unordered_set<std::string> gone;
  for (const Call& call : trace.calls)
    if (isRemoval(call)) gone.insert(call.name());
  std::erase_if(trace.calls, [&](const Call& call) {
    return call.kind == Call::Kind::commit || (call.kind == Call::Kind::add && gone.contains(call.name()));
  });
  dropOrphans(trace);
  return trace;
}

const std::vector<ShrinkWalk::Pass>& ShrinkWalk::passes() {
  using W = ShrinkWalk;
  // What leaves out most, and the place, come first: where each trial takes seconds, as for a hang, there is time for
  // little else.
  static const std::vector<Pass> kPasses{
      &W::buildAtOnce,   &W::rename,           &W::moveColumns,     &W::moveRows,  &W::dropCalls,
      &W::simplifyCalls, &W::simplifyPolygons, &W::simplifyBrushes, &W::dropPairs, &W::renumberBlocks,
      &W::oneBlock,      &W::rename,           &W::refuseNothing};
  return kPasses;
}

std::optional<Trace> ShrinkWalk::next() {
  constexpr std::size_t kFirstOfRound = 2;
  const std::size_t endOfRound = passes().size() - 2;
  while (pass_ < passes().size()) {
    if (auto candidate = (this->*passes()[pass_])()) {
      if (*candidate != best_) return candidate;
      continue;
    }
    ++pass_;
    if (pass_ == endOfRound && isSmaller_) pass_ = kFirstOfRound;
    if (pass_ == kFirstOfRound) isSmaller_ = false;
    at_ = variant_ = 0;
    length_ = std::max<std::size_t>(best_.calls.size() / 2, 1);
  }
  return std::nullopt;
}

void ShrinkWalk::accept(Trace candidate) {
  at_ -= best_.calls.size() - candidate.calls.size();  // what was dropped is no longer behind
  variant_ = 0;
  isSmaller_ = true;
  best_ = std::move(candidate);
}

std::optional<Trace> ShrinkWalk::buildAtOnce() {
  if (variant_++ != 0) return std::nullopt;
  return builtAtOnce(best_);
}

std::optional<Trace> ShrinkWalk::rename() {
  if (variant_++ != 0) return std::nullopt;
  return renamed(best_);
}

std::optional<Trace> ShrinkWalk::refuseNothing() {
  if (variant_++ != 0 || !isPlain(best_)) return std::nullopt;
  Trace candidate = best_;
  candidate.mayRefuse = false;
  return candidate;
}

std::optional<Trace> ShrinkWalk::dropCalls() {
  const std::size_t size = best_.calls.size();
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
  candidate.calls.erase(candidate.calls.begin() + static_cast<std::ptrdiff_t>(begin),
                        candidate.calls.begin() + static_cast<std::ptrdiff_t>(end));
  dropOrphans(candidate);
  return candidate;
}

// One call after the other in its simpler forms, as long as there are any; a part stands in the place of its group. What
// is already an add or a remove by name is as simple as can be.
std::optional<Trace> ShrinkWalk::simplifyCalls() {
  for (; at_ < best_.calls.size(); ++at_, variant_ = 0) {
    if (isPlain(best_.calls[at_])) continue;
    const std::vector<Call> simple = formsOf(best_.calls[at_], at_);
    if (variant_ >= simple.size()) continue;
    Trace candidate = best_;
    candidate.calls[at_] = simple[variant_++];
    return candidate;
  }
  return std::nullopt;
}

// Polygons that calls bring, one after the other.
std::optional<Trace> ShrinkWalk::simplifyPolygons() {
  for (; at_ < best_.calls.size(); ++at_, variant_ = 0) {
    std::size_t variant = variant_;
    const Call& call = best_.calls[at_];
    for (std::size_t c = 0; c < call.comes.size(); ++c) {
      for (std::size_t p = 0; p < call.comes[c].shape.size(); ++p) {
        const LocalPolygon& polygon = call.comes[c].shape[p];
        const std::size_t variants = variantsOf(polygon);
        for (; variant < variants; ++variant, ++variant_) {
          auto simple = simplerPolygon(polygon, variant);
          if (!simple) continue;
          ++variant_;
          Trace candidate = best_;
          candidate.calls[at_].comes[c].shape[p] = std::move(*simple);
          return candidate;
        }
        variant -= variants;
      }
    }
  }
  return std::nullopt;
}

std::optional<Trace> ShrinkWalk::simplifyBrushes() {
  for (; at_ < best_.calls.size(); ++at_, variant_ = 0) {
    if (best_.calls[at_].kind != Call::Kind::brush) continue;
    while (variant_ < variantsOf(best_.calls[at_].brush)) {
      auto simple = simplerBrush(best_.calls[at_].brush, variant_++);
      if (!simple) continue;
      Trace candidate = best_;
      candidate.calls[at_].brush = std::move(*simple);
      return candidate;
    }
  }
  return std::nullopt;
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
  forEachCall(candidate.calls, [&](Call& call) {
    for (Block* const block : blocksOf(call)) *block = number(*block);
    for (Block& block : call.brush.staying) block = number(block);
  });
  candidate.preserve = {};
  for (const auto& [a, b] : best_.preserve.pairs()) {
    const Block first = number(a);
    candidate.preserve.add(first, number(b));
  }
  return candidate;
}

std::optional<Trace> ShrinkWalk::oneBlock() {
  for (; at_ < best_.calls.size(); ++at_) {
    Trace candidate = best_;
    for (Block* const block : blocksOf(candidate.calls[at_])) *block = 1;
    if (candidate == best_) continue;
    ++at_;
    return candidate;
  }
  return std::nullopt;
}

namespace {

// The cells of a call on one axis.
std::vector<std::int32_t*> linesOf(Call& call, std::int32_t Cell::*axis) {
  using enum Call::Kind;
  std::vector<std::int32_t*> lines;
  for (Coming& coming : call.comes)
    if (call.kind == add || call.kind == addShape || call.kind == addMany || call.kind == replace)
      lines.push_back(&(coming.cell.*axis));
  for (Named& named : call.goes)
    if (named.how == Named::How::standing || named.how == Named::How::all) lines.push_back(&(named.cell.*axis));
  const bool hasCells = call.kind == fill || call.kind == clear || call.kind == exchange;
  if (hasCells) lines.insert(lines.end(), {&(call.cells.min.*axis), &(call.cells.max.*axis)});
  return lines;
}

}  // namespace

// Moves the first line of cells to 0, or else to -1, so that a border of chunks follows it. Then it moves each line
// next to the one before it. It goes from the last line to the first, so that earlier lines stay where they are. Where
// chunks are meant nothing is moved.
std::optional<Trace> ShrinkWalk::moveCells(std::int32_t Cell::*axis) {
  std::int64_t Point::*const coordinate = axis == &Cell::i ? &Point::x : &Point::y;
  std::set<std::int32_t> used;
  bool areChunks = false;
  Trace moved = best_;
  forEachCall(moved.calls, [&](Call& call) {
    using enum Call::Kind;
    areChunks = areChunks || call.kind == unload || call.kind == reload || call.kind == reloadEmpty;
    for (const std::int32_t* line : linesOf(call, axis)) used.insert(*line);
    for (const auto& ring : call.brush.rings)
      for (const Point p : ring) used.insert(cellAt(p).*axis);
  });
  const std::vector<std::int32_t> lines(used.begin(), used.end());
  const auto movedTo = [&](std::int32_t line, std::int32_t target) {
    const std::int64_t by = std::int64_t{line} - target;
    forEachCall(moved.calls, [&](Call& call) {
      for (std::int32_t* const index : linesOf(call, axis))
        if (*index >= line) *index = static_cast<std::int32_t>(*index - by);
      for (auto& ring : call.brush.rings)
        for (Point& p : ring)
          if (cellAt(p).*axis >= line) p.*coordinate -= by * kUnitsPerCell;
    });
    return moved;
  };
  if (at_ >= lines.size() || areChunks) return std::nullopt;
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
