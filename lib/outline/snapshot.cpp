#include "outline/snapshot.h"

#include "outline/look.h"

#include <span>
#include <utility>
#include <vector>

namespace lgs::detail {
namespace {

using What = SnapshotError::What;

/// Ids as distances from the previous id + 1. That is mostly one byte, and never less. So a short file cannot ask for
/// many segments.
class IdReader {
 public:
  explicit IdReader(SnapshotReader& in) : in_(in) {}

  /// Once reading has failed, any number.
  std::uint32_t read() {
    last_ += unfolded(in_.number(4 * std::uint64_t{kMaxSegment})) + 1;
    if (last_ < 1 || last_ > kMaxSegment) in_.fail(What::badSegments);
    return static_cast<std::uint32_t>(last_);
  }
  std::vector<std::uint32_t> readList() {
    std::vector<std::uint32_t> ids(in_.count(kMaxSegment));
    for (std::uint32_t& id : ids) id = read();
    return ids;
  }

 private:
  SnapshotReader& in_;
  std::int64_t last_ = 0;
};

/// How many segments a ground shows; or more than `most`, if they are more.
std::uint64_t countShown(const Ground& ground, std::uint64_t most) {
  std::uint64_t shown = 0;
  ground.grid.forEachCell(kWholeWorld, [&](CellAt at, Cell) {
    if (shown <= most && ground.held(at).size() != 0) shown += Look(ground, at).count();
  });
  return shown;
}

}  // namespace

void save(const Ground& ground, const Outline& outline, SnapshotWriter& out) {
  std::int64_t last = 0;
  const auto write = [&](std::span<const std::uint32_t> ids) {
    for (const std::uint32_t id : ids) {
      out.number(folded(id - last - 1));
      last = id;
    }
  };
  const std::span<const std::uint32_t> free = outline.segments.free();
  out.number(free.size());
  write(free);
  out.number(0);  // older libraries have some of the free ones apart
  ground.grid.forEachCell(kWholeWorld, [&](CellAt at, Cell) { write(outline.lists.of(at).all()); });
}

// Each id up to the highest names a segment, or is free.
void load(const Ground& ground, Outline& outline, SnapshotReader& in) {
  IdReader ids(in);
  std::vector<std::uint32_t> free = ids.readList();
  const std::vector<std::uint32_t> more = ids.readList();
  free.insert(free.end(), more.begin(), more.end());
  if (in.failed()) return;
  const std::uint64_t shown = countShown(ground, in.left()), count = free.size() + shown;
  if (shown > in.left()) return in.fail(What::cut);  // an id takes a byte at least
  if (count >= kMaxSegment) return in.fail(What::capacity);
  std::vector<bool> seen(static_cast<std::size_t>(count) + 1);
  const auto see = [&](std::uint32_t id) {  // whether it may be used, and was not yet
    if (id == kNoSegment || id >= seen.size() || seen[id]) in.fail(What::badSegments);
    if (!in.failed()) seen[id] = true;
    return !in.failed();
  };
  for (const std::uint32_t id : free) see(id);
  outline.load(static_cast<std::uint32_t>(count), std::move(free));
  ground.grid.forEachCell(kWholeWorld, [&](CellAt at, Cell) {
    if (in.failed() || ground.held(at).size() == 0) return;
    const Look look(ground, at);
    const std::uint32_t here = look.count();
    if (here == 0) return;
    look.fill(outline.splice(at, 0, 0, here), here, [&](const PackedEnds& ends, Placed placed) {
      const std::uint32_t id = ids.read();
      if (see(id)) outline.segments[id] = newSegment(at.ref(), ends, placed);
      return id;
    });
  });
}

}  // namespace lgs::detail
