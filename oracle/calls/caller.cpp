#include "oracle/calls/caller.h"

#include <algorithm>
#include <tuple>

namespace lgs::oracle {
namespace {

constexpr std::uint32_t kFar = 3;  // places

template <class T>
bool isDone(const Expected<T>& result, Outcome& out) {
  if (!result) out.refusal = result.error();
  return result.has_value();
}

std::vector<PolygonHandle> standingIn(const World& world, Cell cell) {
  std::vector<PolygonHandle> handles;
  for (const PlacedPolygon& p : world.polygons(cell)) handles.push_back(p.handle);
  return handles;
}

// Where a call writes its handles: one too few, just enough, or one too many.
std::vector<PolygonHandle> roomFor(std::size_t count, unsigned room) {
  return std::vector<PolygonHandle>(count + room - 2, Caller::kUntouched);
}

}  // namespace

bool areAlike(const Error& a, const Error& b) {
  const auto fields = [](const Error& e) {
    return std::tie(e.code, e.cell, e.polygon, e.vertex, e.vertex2, e.polygon2, e.other, e.otherBlock, e.segment,
                    e.index, e.index2);
  };
  return fields(a) == fields(b);
}

bool operator==(const Outcome& a, const Outcome& b) {
  const auto fields = [](const Outcome& o) {
    return std::tie(o.shape, o.told, o.handles, o.count, o.changes, o.parts);
  };
  if (a.refusal.has_value() != b.refusal.has_value() || (a.refusal && !areAlike(*a.refusal, *b.refusal))) return false;
  return fields(a) == fields(b);
}

Call Caller::resolved(const Call& call) const {
  const auto sum = [](std::int32_t a, std::int32_t b) {  // far out of range it does not matter which cell it is
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(std::int64_t{a} + b, INT32_MIN, INT32_MAX));
  };
  const auto at = [&](Cell cell) { return Cell{sum(origin_.i, cell.i), sum(origin_.j, cell.j)}; };
  Call out = call;
  out.cells = {at(call.cells.min), at(call.cells.max)};
  for (Coming& coming : out.comes) {
    coming.cell = at(coming.cell);
    if (coming.id == 0) continue;
    coming.shape.clear();
    if (const auto polygons = world.polygonsOf({coming.id}))
      for (const auto& p : *polygons) coming.shape.emplace_back(p.begin(), p.end());
  }
  out.goes.clear();
  for (const Named& named : call.goes) {
    std::vector<PolygonHandle> handles{named.handle};
    if (named.how == Named::How::standing || named.how == Named::How::all) {
      handles = standingIn(world, at(named.cell));
      if (named.how == Named::How::standing)
        handles = {handles.empty() ? PolygonHandle{} : handles[named.nth % handles.size()]};
    } else if (named.how != Named::How::handle) {
      handles = {given.empty() ? PolygonHandle{} : given[named.nth % given.size()]};
      if (named.how == Named::How::beside) handles[0].serial += 1 + named.nth % kFar;
    }
    for (const PolygonHandle handle : handles) out.goes.push_back({Named::How::handle, {}, 0, handle});
  }
  return out;
}

Outcome Caller::makeResolved(const Call& call) {
  Outcome out;
  switch (call.kind) {
    case Call::Kind::shape:
    case Call::Kind::add:
    case Call::Kind::addShape:
    case Call::Kind::replace:
      place(call, out);
      break;
    case Call::Kind::addMany:
      addMany(call, out);
      break;
    case Call::Kind::exchange:
      exchange(call, out);
      break;
    case Call::Kind::fill:
      fill(call, out);
      break;
    case Call::Kind::remove:
      isDone(world.remove(call.goes[0].handle), out);
      break;
    case Call::Kind::removeMany: {
      std::vector<PolygonHandle> handles;
      for (const Named& named : call.goes) handles.push_back(named.handle);
      isDone(world.removeMany(handles), out);
      break;
    }
    case Call::Kind::setBlock:
      isDone(world.setBlock(call.goes[0].handle, call.comes[0].block), out);
      break;
    case Call::Kind::clear: {
      const bool isOne = call.cells.min == call.cells.max;
      const auto count = isOne ? world.clear(call.cells.min) : world.clear(call.cells);
      if (isDone(count, out)) out.count = *count;
      break;
    }
    case Call::Kind::group:
      makeGroup(call, [&](const Call& part) {
        out.parts.push_back(make(part));
        return !out.parts.back().refusal;
      });
      break;
    case Call::Kind::commit:
      out.changes = copyOf(world.commit());
      break;
    case Call::Kind::mark:
      marks_.push_back({world.checkpoint(), given.size()});
      break;
    case Call::Kind::goBack:
      if (!marks_.empty()) goBack(call, out);
      break;
    case Call::Kind::forget:
      if (marks_.empty()) break;
      isDone(world.forget(marks_[call.nth % marks_.size()].mark), out);
      marks_.erase(marks_.begin() + static_cast<std::ptrdiff_t>(call.nth % marks_.size()));
      break;
    case Call::Kind::leave:
      if (const auto count = world.forget(call.cells); isDone(count, out)) out.count = *count;
      break;
    case Call::Kind::copy:
      world = World(world);
      break;
    case Call::Kind::load:
      load(out);
      break;
  }
  given.insert(given.end(), out.handles.begin(), out.handles.end());
  return out;
}

bool Caller::makeShapes(const Call& call) {
  Outcome out;
  if (!isByShape(call.kind) && call.kind != Call::Kind::shape) return true;
  return std::ranges::all_of(call.comes, [&](const Coming& coming) { return makeShape(call, coming, out); });
}

// A single polygon in the notation of the call.
bool Caller::makeShape(const Call& call, const Coming& coming, Outcome& out) {
  out.shape = {coming.id};
  if (coming.id != 0) return true;
  const auto make = [this](auto points) { return world.shape(points); };
  const auto made = coming.shape.size() == 1 ? inNotation(coming.shape[0], call.notation, call.offset, make)
                                             : world.shape(std::span<const std::vector<LocalPoint>>(coming.shape));
  if (isDone(made, out)) out.shape = *made;
  return made.has_value();
}

// The handles of what was placed last in a cell.
void Caller::keepLast(Cell cell, std::size_t count, Outcome& out) {
  const auto all = standingIn(world, cell);
  const auto first = all.end() - static_cast<std::ptrdiff_t>(std::min(count, all.size()));
  out.handles.insert(out.handles.end(), first, all.end());
}

void Caller::place(const Call& call, Outcome& out) {
  const Coming& coming = call.comes[0];
  if (call.kind != Call::Kind::add && (!makeShape(call, coming, out) || call.kind == Call::Kind::shape)) return;
  const auto made = [&]() -> Expected<PolygonHandle> {
    if (call.kind == Call::Kind::add)
      return inNotation(coming.shape[0], call.notation, call.offset,
                        [&](auto points) { return world.add(coming.cell, points, coming.block); });
    const bool replaces = call.kind == Call::Kind::replace;
    if (call.room == 0)
      return replaces ? world.replace(coming.cell, out.shape, coming.block)
                      : world.add(coming.cell, out.shape, coming.block);
    out.told = roomFor(std::max<std::size_t>(coming.shape.size(), 1), call.room);
    return replaces ? world.replace(coming.cell, out.shape, coming.block, out.told)
                    : world.add(coming.cell, out.shape, coming.block, out.told);
  }();
  if (!isDone(made, out)) return;
  out.told.insert(out.told.begin(), *made);  // what it returns, then what it writes
  keepLast(coming.cell, coming.shape.size(), out);
}

void Caller::addMany(const Call& call, Outcome& out) {
  std::vector<Placement> placements;
  for (const Coming& coming : call.comes) {
    if (!makeShape(call, coming, out)) return;
    placements.push_back({coming.cell, out.shape, coming.block});
  }
  if (call.room != 0 && !placements.empty()) out.told = roomFor(placements.size(), call.room);
  if (!isDone(world.addMany(placements, out.told), out)) return;
  for (auto coming = call.comes.begin(); coming != call.comes.end(); ++coming) {
    std::size_t later = 0;  // polygons that the call places in the same cell after these
    for (auto other = coming + 1; other != call.comes.end(); ++other)
      if (other->cell == coming->cell) later += other->shape.size();
    keepLast(coming->cell, coming->shape.size() + later, out);
    out.handles.resize(out.handles.size() - later);
  }
}

void Caller::exchange(const Call& call, Outcome& out) {
  std::vector<PolygonHandle> goes;
  for (const Named& named : call.goes) goes.push_back(named.handle);
  std::vector<NewPolygon> comes;
  for (const Coming& coming : call.comes) comes.push_back({coming.shape[0], coming.block});
  if (call.room != 0 && !comes.empty()) out.told = roomFor(comes.size(), call.room);
  if (isDone(world.exchange(call.cells.min, goes, comes, out.told), out)) keepLast(call.cells.min, comes.size(), out);
}

void Caller::fill(const Call& call, Outcome& out) {
  const Coming& coming = call.comes[0];
  if (!makeShape(call, coming, out)) return;
  const auto count = world.fill(call.cells, out.shape, coming.block);
  if (!isDone(count, out)) return;
  out.count = *count;
  if (isEmpty(call.cells)) return;  // it may have any number of rows
  for (std::int32_t j = call.cells.min.j; j <= call.cells.max.j; ++j)
    for (std::int32_t i = call.cells.min.i; i <= call.cells.max.i; ++i) keepLast({i, j}, coming.shape.size(), out);
}

bool Caller::makeGroup(const Call& call, const std::function<bool(const Call&)>& make) {
  const std::size_t before = given.size();
  Transaction edits = world.edit();
  bool keeps = call.keeps != Call::Keeps::never;
  for (const Call& part : call.group) {
    if (make(part) || call.keeps != Call::Keeps::ifAll) continue;
    keeps = false;
    break;
  }
  if (keeps)
    edits.keep();
  else
    given.resize(before);
  return keeps;
}

void Caller::goBack(const Call& call, Outcome& out) {
  const std::size_t k = call.nth % marks_.size();
  if (!isDone(world.rollBack(marks_[k].mark), out)) return;
  out.changes = copyOf(world.changesOfRollBack());
  given.resize(marks_[k].given);
  marks_.resize(k + 1);
}

void Caller::load(Outcome& out) {
  out.changes = copyOf(world.commit());
  std::vector<std::byte> bytes;
  const auto keep = [&](std::span<const std::byte> piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); };
  if (!isDone(world.save(keep), out)) return;
  auto loaded = World::load(bytes, world.preserveRelation());
  out.count = loaded ? 0 : 1;  // whoever looks at outcomes sees that it is not
  if (!loaded) return;
  world = std::move(*loaded);
  marks_.clear();
}

}  // namespace lgs::oracle
