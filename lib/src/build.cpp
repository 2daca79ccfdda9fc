// What makes the result the same on any number of threads: the segments of each cell are counted first, so that ids and
// records can be given out in order before the threads fill them in.
//
// No thread writes what another one reads or writes. Counting writes nothing of the world. When segments are created, each
// job writes the records of its own chunk's cells and their segments, and of the cells around reads only which polygons
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
  std::uint16_t segments;  ///< how many
};

struct ChunkPlan {
  Chunk* chunk = nullptr;
  std::span<LiveCell> cells;  ///< by rows
  std::size_t segments = 0;   ///< of all of them
  std::size_t first = 0;      ///< where these begin in the list of those added
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
    std::size_t sum = 0;  // written to the plan once: the plan beside it belongs to another thread
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
      Look(world_, at).fill(world_.grid.liveRecord(at), [&](const PackedEnds& ends, Placed placed) {
        const std::uint32_t id = next++->value;
        world_.segments[id] = newSegment(at.chunk->ref(at.local), ends, placed);
        return id;
      });
    }
  }

  /// In four goes, by whether a chunk's coordinates are odd: those of one go do not touch.
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
  std::unique_ptr<LiveCell[]> cells_;  ///< room for all cells of each chunk; what stays empty costs no memory
  std::vector<ChunkPlan> plans_;       ///< of the dirty chunks, in the order in which edits touched them
};

}  // namespace

void build(World::Impl& world, const Executor& executor) { Build(world, executor).run(); }

}  // namespace lgs::detail
