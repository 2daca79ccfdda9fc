// What can be said of a call without making it: whether two are the same, what is simpler, what its parts are.
#include "oracle/calls/call.h"
#include "oracle/calls/shapes.h"

#include <algorithm>
#include <tuple>

namespace lgs::oracle {

using Kind = Call::Kind;

bool operator==(const Call& a, const Call& b) {
  const auto fields = [](const Call& c) {
    return std::tie(c.kind, c.comes, c.goes, c.cells, c.notation, c.offset, c.room, c.keeps, c.nth, c.brush, c.lies);
  };
  return fields(a) == fields(b) && a.group == b.group;
}

bool isPlain(const Call& call) {
  const bool isNamed = !call.name().empty();
  if (call.kind == Kind::add) return isNamed && call.notation == Notation::lattice;
  if (call.kind == Kind::remove) return isNamed && call.goes[0].how == Named::How::name;
  return call.kind == Kind::commit && call.nth == 0;
}

Call tidied(Call call) {
  using enum Call::Kind;
  if (!has(call.kind, KindOfCall::notation) || call.comes.empty()) call.notation = {};
  if (!isReal(call.notation)) call.offset = 0;
  if (!has(call.kind, KindOfCall::room)) call.room = 0;
  if (!has(call.kind, KindOfCall::rect) && call.kind != exchange) call.cells = {};
  if (call.kind == exchange) call.cells.max = call.cells.min;
  if (!has(call.kind, KindOfCall::number)) call.nth = 0;
  if (call.kind != group && call.kind != rollBack) call.keeps = {};
  if (call.kind != put) call.lies = {};
  for (Coming& c : call.comes) {
    if (!has(call.kind, KindOfCall::cell)) c.cell = {};
    if (call.kind == setBlock) c.shape = {};
    if (call.kind == shape) c.block = 0;
    if (c.id != 0) c.shape = {};
  }
  for (Named& named : call.goes) {
    if (named.how == Named::How::handle || named.how == Named::How::all) named.nth = 0;
    if (named.how != Named::How::standing && named.how != Named::How::all) named.cell = {};
  }
  return call;
}

Call movedBy(Call call, Cell by) {
  const auto sum = [](std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(std::int64_t{a} + b, INT32_MIN, INT32_MAX));
  };
  const auto move = [&](Cell& cell) { cell = {sum(cell.i, by.i), sum(cell.j, by.j)}; };
  move(call.cells.min);
  move(call.cells.max);
  for (Coming& coming : call.comes) move(coming.cell);
  for (Named& named : call.goes) move(named.cell);
  for (Call& part : call.group) part = movedBy(std::move(part), by);
  const Point further = toWorld(by, {});
  for (auto& ring : call.brush.rings)
    for (Point& p : ring) p = {p.x + further.x, p.y + further.y};
  return call;
}

std::vector<Call> simpler(const Call& call) {
  std::vector<Call> all = call.group;
  const auto with = [&](auto&& change) { change(all.emplace_back(call)); };
  const auto withoutEach = [&](auto Call::*list, std::size_t least) {
    for (std::size_t k = 0; (call.*list).size() > least && k < (call.*list).size(); ++k)
      with([&](Call& c) { (c.*list).erase((c.*list).begin() + static_cast<std::ptrdiff_t>(k)); });
  };
  const bool isOfMany = has(call.kind, KindOfCall::many) || call.kind == Kind::removeMany;
  withoutEach(&Call::group, 1);
  if (call.kind == Kind::repeat && call.nth > 1) {
    with([](Call& c) { c.nth /= 2; });
    with([](Call& c) { --c.nth; });
  }
  withoutEach(&Call::comes, isOfMany ? 0 : 1);
  withoutEach(&Call::goes, isOfMany ? 0 : 1);
  for (std::size_t k = 0; k < call.comes.size(); ++k) {
    const Coming& coming = call.comes[k];
    if (coming.block != 0) with([&](Call& c) { c.comes[k].block = 0; });
    if (call.kind == Kind::setBlock) continue;
    for (const std::size_t plain : {0U, 6U}) {  // the full square, and the ramp
      const Shape& shape = degenerateShapes()[plain].polygons;
      if (coming.id == 0 && (coming.shape == shape || coming.shape == degenerateShapes()[0].polygons)) continue;
      with([&](Call& c) { c.comes[k] = {coming.cell, shape, coming.block, 0, coming.names}; });
    }
    for (const LocalPolygon& p : coming.shape)
      if (coming.shape.size() > 1) with([&](Call& c) { c.comes[k].shape = {p}; });
  }
  if (call.nth != 0 && call.kind != Kind::repeat && call.kind != Kind::follow) with([](Call& c) { c.nth = 0; });
  for (std::size_t k = 0; k < call.goes.size(); ++k)
    if (call.goes[k].nth != 0) with([&](Call& c) { c.goes[k].nth = 0; });
  if (call.cells.min != call.cells.max) with([&](Call& c) { c.cells.max = c.cells.min; });
  if (call.notation != Notation::lattice) with([&](Call& c) { c.notation = {}; });
  if (call.room != 0) with([&](Call& c) { c.room = 0; });
  if (call.lies.by != Cell{}) with([&](Call& c) { c.lies.by = {}; });
  if (call.lies.symmetry != 0) with([&](Call& c) { c.lies.symmetry = 0; });
  for (Call& each : all) {
    for (Coming& coming : each.comes) coming.names.resize(std::min(coming.names.size(), coming.shape.size()));
    each = tidied(std::move(each));
  }
  return all;
}

}  // namespace lgs::oracle
