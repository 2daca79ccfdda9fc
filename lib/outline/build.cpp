// An update on several threads, while there are no segments yet.
//
// The result is the same on any number of threads, because the segments of each cell are counted first. So lists and
// ids can be given out in order, before the threads fill them in.
//
// No thread writes what another one reads or writes. Counting writes nothing of the world. To create segments, a job
// writes to the lists of its own chunk and to the segments in them. Of the cells around it reads only which polygons
// they hold. Linking writes across the rim of a chunk, so chunks that touch are never linked at the same time.
#include "outline/linking.h"
#include "outline/look.h"
#include "outline/wide_row.h"

#include <array>
#include <atomic>
#include <functional>
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
  std::vector<LiveCell> cells = {};  ///< by rows
  std::size_t segments = 0;          ///< how many these cells show together
  std::size_t first = 0;             ///< where they begin in the list of added segments
};

class Build {
 public:
  Build(const Ground& ground, Outline& outline, const Executor& executor)
      : ground_(ground), outline_(outline), executor_(executor) {
    for (Chunk* chunk : ground.changedChunks()) plans_.push_back({.chunk = chunk});
  }

  void run() {
    forEach(plans_.size(), [this](std::size_t k) { count(plans_[k]); });
    allot();
    forEach(plans_.size(), [this](std::size_t k) { create(plans_[k]); });
    if (outline_.isNoting()) outline_.noteAdded();
    link();
  }

 private:
  /// Each job once, whatever the executor does: what it calls again is not done again, and what it leaves out is done
  /// here.
  template <class Job>
  void forEach(std::size_t count, Job&& job) const {
    const auto begun = std::make_unique<std::atomic_flag[]>(count);
    const std::function<void(std::size_t)> once = [&](std::size_t k) {
      if (k < count && !begun[k].test_and_set()) job(k);
    };
    executor_(count, once);
    for (std::size_t k = 0; k < count; ++k) once(k);
  }

  void count(ChunkPlan& plan) const {
    const Chunk& chunk = *plan.chunk;
    std::vector<LiveCell> cells;  // written to the plan only once, as the plan beside it belongs to another thread
    std::size_t sum = 0;
    for (std::int32_t y = 0; y < kChunkSize; ++y) {
      WideRow showing = dirtyRow(chunk, y);
      if (showing == 0) continue;
      if (!ground_.preserve) showing &= showingRow(chunk, y);
      forEachColumn(showing, [&](std::int32_t x) {
        const CellAt at = cellAt(chunk, x, y);
        const std::uint32_t segments = Look(ground_, at).count();
        if (segments == 0) return;
        cells.push_back({static_cast<std::uint16_t>(at.local), static_cast<std::uint16_t>(segments)});
        sum += segments;
      });
    }
    plan.segments = sum;
    plan.cells = std::move(cells);
  }

  /// Gives out lists and ids, in the order of the chunks.
  void allot() {
    std::size_t segments = 0;
    for (ChunkPlan& plan : plans_) plan.first = std::exchange(segments, segments + plan.segments);
    for (const ChunkPlan& plan : plans_)
      for (const LiveCell cell : plan.cells) outline_.splice({plan.chunk, cell.local}, 0, 0, cell.segments);
    ids_ = outline_.createIds(segments);
  }

  void create(const ChunkPlan& plan) const {
    const SegmentId* next = ids_.data() + plan.first;
    for (const LiveCell cell : plan.cells) {
      const CellAt at{plan.chunk, cell.local};
      const std::uint32_t ref = at.ref();
      Look(ground_, at).fill(outline_.lists.words(at), cell.segments, [&](const PackedEnds& ends, Placed placed) {
        const std::uint32_t id = next++->value;
        outline_.segments[id] = newSegment(ref, ends, placed);
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
      forEach(chunks.size(), [&](std::size_t k) {
        std::vector<Spoke> fan;
        Linking(ground_, outline_, fan).linkChunk(*chunks[k]);
      });
    }
  }

  const Ground& ground_;
  Outline& outline_;
  const Executor& executor_;
  std::span<const SegmentId> ids_;  ///< of all segments, in the order of the plans
  std::vector<ChunkPlan> plans_;    ///< in the order of changedChunks()
};

}  // namespace

void build(const Ground& ground, Outline& outline, const Executor& executor) { Build(ground, outline, executor).run(); }

}  // namespace lgs::detail
