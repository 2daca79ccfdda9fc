// The result is the same on any number of threads, because the segments of each cell are counted first. So records and
// ids can be given out in order, before the threads fill them in.
//
// No thread writes what another one reads or writes. Counting writes nothing of the world. To create segments, a job
// writes to the records of its own chunk and to the segments in them. Of the cells around it reads only which polygons
// they hold. Linking writes across the rim of a chunk, so chunks that touch are never linked at the same time.
#include "build.h"

#include "linking.h"
#include "look.h"
#include "wide_row.h"

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace lgs::detail {
namespace {

/// A cell that shows something.
struct LiveCell {
  std::uint16_t local;
  std::uint16_t segments;  ///< how many it shows
};

struct ChunkPlan {
  Chunk* chunk = nullptr;
  std::span<LiveCell> cells;  ///< by rows
  std::size_t segments = 0;   ///< how many these cells show together
  std::size_t first = 0;      ///< where they begin in the list of added segments
};

class Build {
 public:
  Build(World::Impl& world, const Executor& executor)
      : world_(world),
        executor_(executor),
        cells_(std::make_unique_for_overwrite<LiveCell[]>(world.dirtyChunks.size() * kChunkCells)) {
    plans_.reserve(world.dirtyChunks.size());
    for (Chunk* chunk : world.dirtyChunks)
      plans_.push_back({.chunk = chunk, .cells = {cells_.get() + plans_.size() * kChunkCells, 0}});
  }

  void run() {
    executor_(plans_.size(), [this](std::size_t k) { count(plans_[k]); });
    allot();
    executor_(plans_.size(), [this](std::size_t k) { create(plans_[k]); });
    link();
  }

 private:
  void count(ChunkPlan& plan) const {
    const Chunk& chunk = *plan.chunk;
    LiveCell* last = plan.cells.data();
    std::size_t sum = 0;  // written to the plan only once, as the plan beside it belongs to another thread
    for (std::int32_t y = 0; y < kChunkSize; ++y) {
      WideRow showing = dirtyRow(chunk, y);
      if (showing == 0) continue;
      if (!world_.preserve) showing &= showingRow(chunk, y);
      forEachColumn(showing, [&](std::int32_t x) {
        const CellAt at = cellAt(chunk, x, y);
        const std::uint32_t segments = Look(world_, at).count();
        if (segments == 0) return;
        *last++ = {static_cast<std::uint16_t>(at.local), static_cast<std::uint16_t>(segments)};
        sum += segments;
      });
    }
    plan.segments = sum;
    plan.cells = {plan.cells.data(), last};
  }

  /// Gives out records and ids, in the order of the chunks.
  void allot() {
    std::vector<SegmentId>& added = world_.changes.added;
    std::size_t segments = 0;
    for (ChunkPlan& plan : plans_) plan.first = std::exchange(segments, segments + plan.segments);
    added.reserve(segments);
    for (const ChunkPlan& plan : plans_)
      for (const LiveCell cell : plan.cells) world_.grid.spliceSegments({plan.chunk, cell.local}, 0, 0, cell.segments);
    for (; segments != 0; --segments) added.push_back({world_.segments.take()});
  }

  void create(const ChunkPlan& plan) const {
    const SegmentId* next = world_.changes.added.data() + plan.first;
    for (const LiveCell cell : plan.cells) {
      const CellAt at{plan.chunk, cell.local};
      const std::uint32_t ref = at.chunk->ref(at.local);
      Look(world_, at).fill(world_.grid.liveRecord(at), [&](const PackedEnds& ends, Placed placed) {
        const std::uint32_t id = next++->value;
        world_.segments[id] = newSegment(ref, ends, placed);
        return id;
      });
    }
  }

  /// In four goes, by which coordinates of a chunk are odd. The chunks of one go do not touch.
  void link() {
    std::array<std::vector<const Chunk*>, 4> apart;
    for (const ChunkPlan& plan : plans_) {
      const std::int32_t parity = (plan.chunk->ci & 1) + 2 * (plan.chunk->cj & 1);
      apart[static_cast<std::size_t>(parity)].push_back(plan.chunk);
    }
    for (const auto& chunks : apart) {
      executor_(chunks.size(), [&](std::size_t k) {
        std::vector<Spoke> fan;
        Linking(world_, fan).linkChunk(*chunks[k]);
      });
    }
  }

  World::Impl& world_;
  const Executor& executor_;
  std::unique_ptr<LiveCell[]> cells_;  ///< room for all cells of each chunk; the system gives memory for what is used
  std::vector<ChunkPlan> plans_;       ///< in the order in which edits touched the chunks
};

}  // namespace

void build(World::Impl& world, const Executor& executor) { Build(world, executor).run(); }

}  // namespace lgs::detail
