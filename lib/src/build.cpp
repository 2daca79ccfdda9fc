// What makes the result the same on any number of threads: the segments of each cell are counted first, so that ids and
// records can be given out in order before the threads fill them in.
//
// No thread writes what another one reads or writes. Counting writes nothing of the world. When segments are created, each
// job writes the records of its own chunk's cells and their segments, and of the cells around reads only which polygons
// they hold. Linking writes across the rim of a chunk, so chunks that touch are never linked at the same time.
#include "build.h"

#include "exposed_edges.h"
#include "linking.h"

#include <array>

namespace lgs::detail {
namespace {

/// A cell that shows something.
struct LiveCell {
  std::uint16_t local;
  std::uint16_t segments;  ///< how many
};

struct ChunkPlan {
  Chunk* chunk = nullptr;
  std::vector<LiveCell> cells;  ///< by rows
  std::size_t first = 0;        ///< where the chunk's segments begin in the list of those added
};

class Build {
 public:
  Build(World::Impl& world, const Executor& executor) : world_(world), exposed_(world), executor_(executor) {
    for (Chunk* chunk : world.dirtyChunks) plans_.push_back({chunk, {}, 0});
  }

  void run() {
    executor_(plans_.size(), [this](std::size_t k) { count(plans_[k]); });
    for (ChunkPlan& plan : plans_) allot(plan);
    executor_(plans_.size(), [this](std::size_t k) { create(plans_[k]); });
    link();
  }

 private:
  /// Calls emit(ends, slot, touching) for the exposed edges of one part of a cell after the other, and done(part) after
  /// each.
  template <class Emit, class Done>
  void forEachEdge(CellAt at, Emit&& emit, Done&& done) const {
    const InternedContent& content = exposed_.contentOf(at);
    const ExposedEdges::Facing facing = exposed_.facing(at);
    for (unsigned part = 0; part < kParts; ++part) {
      exposed_.forEach(at, content, facing, part, emit);
      done(part);
    }
  }

  void count(ChunkPlan& plan) const {
    const Chunk& chunk = *plan.chunk;
    forEachRowNear(chunk.dirtyRows, [&](std::int32_t y) {
      WideRow showing = dirtyRow(chunk, y);
      if (showing == 0) return;
      if (!world_.preserve) showing &= showingRow(chunk, y);
      forEachColumn(showing, [&](std::int32_t x) {
        const CellAt at = cellAt(chunk, x, y);
        std::uint32_t segments = 0;
        forEachEdge(
            at, [&](const PackedEnds&, Slot, std::uint8_t) { ++segments; }, [](unsigned) {});
        if (segments != 0)
          plan.cells.push_back({static_cast<std::uint16_t>(at.local), static_cast<std::uint16_t>(segments)});
      });
    });
  }

  /// Gives ids and records to the segments of a chunk.
  void allot(ChunkPlan& plan) {
    std::vector<SegmentId>& added = world_.changes.added;
    plan.first = added.size();
    for (const LiveCell cell : plan.cells) {
      world_.grid.spliceSegments({plan.chunk, cell.local}, 0, 0, cell.segments);
      for (unsigned k = 0; k < cell.segments; ++k) added.push_back({world_.segments.take()});
    }
  }

  void create(const ChunkPlan& plan) {
    const SegmentId* next = world_.changes.added.data() + plan.first;
    for (const LiveCell cell : plan.cells) {
      const CellAt at{plan.chunk, cell.local};
      const std::uint32_t ref = plan.chunk->ref(cell.local);
      CellRecord& r = world_.grid.liveRecord(at);
      std::uint32_t* id = r.ids();
      r.touching = 0;
      forEachEdge(
          at,
          [&](const PackedEnds& ends, Slot slot, std::uint8_t touching) {
            r.touching |= touching;
            *id = next++->value;
            world_.segments[*id++] = newSegment(ref, ends, world_.grid.placed(at, slot));
          },
          [&](unsigned part) { r.end[part] = static_cast<std::uint16_t>(id - r.ids()); });
    }
  }

  /// In four goes, by whether a chunk's coordinates are odd: those of one go do not touch.
  void link() {
    std::array<std::vector<const Chunk*>, 4> apart;
    for (const ChunkPlan& plan : plans_)
      apart[static_cast<std::size_t>((plan.chunk->ci & 1) + 2 * (plan.chunk->cj & 1))].push_back(plan.chunk);
    for (const auto& chunks : apart) {
      executor_(chunks.size(), [&](std::size_t k) {
        std::vector<Spoke> fan;
        Linking(world_, fan).linkChunk(*chunks[k]);
      });
    }
  }

  World::Impl& world_;
  ExposedEdges exposed_;
  const Executor& executor_;
  std::vector<ChunkPlan> plans_;  ///< of the dirty chunks, in the order in which edits touched them
};

}  // namespace

void build(World::Impl& world, const Executor& executor) { Build(world, executor).run(); }

}  // namespace lgs::detail
