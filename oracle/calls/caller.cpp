#include "oracle/calls/caller.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace lgs::oracle {
namespace {

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

// Without one; with one that is none; or one that runs the jobs from the last to the first, by 3 the even ones before
// the odd ones.
const Changes& commitBy(World& world, std::uint32_t executor) {
  if (executor % 4 == 0) return world.commit();
  if (executor % 4 == 1) return world.commit(Executor());
  const bool apart = executor % 4 == 3;
  return world.commit([apart](std::size_t count, const std::function<void(std::size_t)>& job) {
    for (std::size_t k = count; k-- > 0;)
      if (!apart || k % 2 == 0) job(k);
    for (std::size_t k = 0; k < count; ++k)
      if (apart && k % 2 != 0) job(k);
  });
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
    return std::tie(o.shape, o.told, o.handles, o.count, o.changes, o.chunks, o.parts, o.brushed.removed,
                    o.brushed.added, o.foreseen.changes.added, o.foreseen.after);
  };
  const auto areSame = [](const Body& one, const Body& other) {
    return one.origin == other.origin && one.polygons == other.polygons;
  };
  if (!std::ranges::equal(a.bodies, b.bodies, areSame)) return false;
  if (a.refusal.has_value() != b.refusal.has_value() || (a.refusal && !areAlike(*a.refusal, *b.refusal))) return false;
  return fields(a) == fields(b);
}

Call Caller::resolved(const Call& call) const {
  Call out = call.group.empty() ? movedBy(call, origin_) : call;
  for (Coming& coming : out.comes) {
    if (coming.id == 0) continue;
    coming.shape.clear();
    if (const auto polygons = world.polygonsOf({coming.id}))
      for (const auto& p : *polygons) coming.shape.emplace_back(p.begin(), p.end());
  }
  const std::vector<Named> goes = std::exchange(out.goes, {});
  for (const Named& named : goes) {
    if (named.how == Named::How::handle || named.how == Named::How::name) {
      out.goes.push_back(named);
      continue;
    }
    std::vector<PolygonHandle> handles{named.handle};
    if (named.how == Named::How::standing || named.how == Named::How::all) {
      handles = standingIn(world, named.cell);
      if (named.how == Named::How::standing)
        handles = {handles.empty() ? PolygonHandle{} : handles[named.nth % handles.size()]};
    } else {
      handles = {given.empty() ? PolygonHandle{} : given[named.nth % given.size()]};
      if (named.how == Named::How::beside) handles[0].serial += 1 + named.nth % kFar;
    }
    for (const PolygonHandle handle : handles) out.goes.push_back({.how = Named::How::handle, .handle = handle});
  }
  return out;
}

Outcome Caller::makeResolved(const Call& call) {
  Outcome out;
  const std::uint64_t chunks = isOfMemory(call.kind) ? world.stats().chunks : 0;
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
      return out;
    case Call::Kind::repeat:
      for (std::uint32_t k = 0; k < call.nth; ++k)
        for (const Call& part : call.group) out.parts.push_back(make(part));
      return out;
    case Call::Kind::commit:
      changes = &commitBy(world, call.nth);
      out.changes = copyOf(*changes);
      break;
    case Call::Kind::foresee:
      foresee(call, out, [&](const Call& part) { out.parts.push_back(make(part)); });
      return out;
    case Call::Kind::mark:
      timeline_.mark({world.mark(), given, bodies});
      return out;
    case Call::Kind::rollBack:
      if (timeline_.hasMarks()) rollBack(call, out);
      return out;
    case Call::Kind::redo:
      if (timeline_.hasAhead()) redo(call, out);
      return out;
    case Call::Kind::forget:
      if (!timeline_.hasMarks()) return out;
      isDone(world.forget(timeline_.at(call.nth).mark), out);
      timeline_.forget(call.nth);
      return out;
    case Call::Kind::leave:
      if (const auto count = world.forgetChunks(call.cells); isDone(count, out)) out.count = *count;
      break;
    case Call::Kind::copy:
      world = World(world);
      return out;
    case Call::Kind::load:
      load(out);
      return out;
    case Call::Kind::follow:
      isDone(world.followCells(call.nth % 2 != 0), out);
      return out;
    case Call::Kind::unload:
      unload(call, out);
      break;
    case Call::Kind::reload:
      reload(call, out);
      break;
    case Call::Kind::reloadEmpty:
      if (const auto count = world.reloadEmpty(call.cells); isDone(count, out)) out.count = *count;
      break;
    case Call::Kind::brush:
      if (auto done = stroke(world, call.brush); isDone(done, out)) out.brushed = std::move(*done);
      break;
    case Call::Kind::take:
      take(call, out);
      break;
    case Call::Kind::put:
      putBack(call, out);
      break;
  }
  if (!movesInTime(call.kind) && (!isOfMemory(call.kind) || world.stats().chunks != chunks))
    timeline_.happened(Redo::maybe);
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

void Caller::unload(const Call& call, Outcome& out) {
  const auto count = world.unload(call.cells, [&](Cell corner, std::span<const std::byte> bytes) {
    shelf_[corner].emplace_back(bytes.begin(), bytes.end());
    out.chunks.push_back(corner);
  });
  if (isDone(count, out)) out.count = *count;
}

// The newest bytes that fit: another world may have given them.
void Caller::reload(const Call& call, Outcome& out) {
  std::vector<Cell> corners;
  for (const auto& entry : shelf_)
    if (contains(call.cells, entry.first)) corners.push_back(entry.first);
  if (call.nth % 2 != 0) std::ranges::reverse(corners);
  for (const Cell corner : corners) {
    const std::vector<Bytes>& kept = shelf_.at(corner);
    const auto isTaken = [&](const Bytes& bytes) {
      const auto done = world.reload(bytes);
      return done && *done == corner;
    };
    // Of a chunk that is away none but the last bytes may be taken; where there is none, any.
    const bool isAway = world.firstUnloaded({corner, corner}).has_value();
    if (isAway ? std::ranges::any_of(kept, isTaken) : isTaken(kept.back())) out.chunks.push_back(corner);
  }
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
  changes = nullptr;
  timeline_.clear();
}

Region regionOf(const BrushEdit& brush) {
  return {brush.rings, brush.isEvenOdd ? FillRule::evenOdd : FillRule::nonZero};
}

Expected<BrushResult> stroke(World& world, const BrushEdit& brush) {
  StayingBlocks staying;
  if (!brush.staying.empty())
    staying = [&brush](Block block) { return std::ranges::find(brush.staying, block) != brush.staying.end(); };
  if (brush.deed == BrushEdit::Deed::carve) return carve(world, regionOf(brush), staying);
  const PaintMode mode = brush.deed == BrushEdit::Deed::fill ? PaintMode::fill : PaintMode::replace;
  return paint(world, regionOf(brush), brush.block, mode, staying);
}

}  // namespace lgs::oracle
