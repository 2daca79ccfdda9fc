#include "bench/edit_times.h"

#include "oracle/calls/random.h"

#include <algorithm>

namespace lgs::bench {
namespace {

using oracle::Random;

constexpr std::size_t kLagAnywhere = 1'000;
constexpr std::size_t kLagNearby = 50;
constexpr std::int32_t kReach = 3;  // how far a digging player reaches, in cells

class Planner {
 public:
  Planner(const Tiles& tiles, Where where, std::uint64_t seed)
      : tiles_(tiles), where_(where), random_(seed), isAway_(tiles.size()), at_(random_.below(tiles.size())) {}

  std::uint32_t next() {
    std::int32_t reach = kReach;
    do {
      at_ = where_ == Where::anywhere ? random_.below(tiles_.size()) : near(at_, reach++ / 4 + kReach);
    } while (tiles_.isEmpty(at_) || isAway_[at_]);
    isAway_[at_] = true;
    return static_cast<std::uint32_t>(at_);
  }

  void isBack(std::uint32_t cell) { isAway_[cell] = false; }

 private:
  std::size_t near(std::size_t at, std::int32_t reach) {
    const Cell cell = tiles_.cell(at);
    const auto step = [&](std::int32_t from, std::int32_t size) {
      return std::clamp(from + random_.below(2 * reach + 1) - reach, 0, size - 1);
    };
    const std::int32_t i = step(cell.i, tiles_.width);
    const std::int32_t j = step(cell.j, tiles_.height);
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(tiles_.width) + static_cast<std::size_t>(i);
  }

  const Tiles& tiles_;
  Where where_;
  Random random_;
  std::vector<bool> isAway_;
  std::size_t at_;
};

}  // namespace

EditPlan planEdits(const Tiles& tiles, std::size_t count, Where where, std::uint64_t seed) {
  EditPlan plan;
  plan.lag = std::min({count, tiles.occupied() / 10, where == Where::anywhere ? kLagAnywhere : kLagNearby});
  Planner planner(tiles, where, seed);
  for (std::size_t k = 0; k < count; ++k) {
    if (k > plan.lag) planner.isBack(plan.cells[k - plan.lag - 1]);
    plan.cells.push_back(planner.next());
  }
  return plan;
}

std::vector<std::uint32_t> distinctCells(const Tiles& tiles, std::size_t count, std::uint64_t seed) {
  Planner planner(tiles, Where::anywhere, seed);
  std::vector<std::uint32_t> cells;
  while (cells.size() < count) cells.push_back(planner.next());
  return cells;
}

void timeRemovesAndAdds(Incremental& subject, const Tiles& tiles, const EditPlan& plan, EditTimes& times,
                        const std::function<void()>& afterEdit) {
  times.first.reserve(plan.cells.size());
  times.back.reserve(plan.cells.size());
  const auto edit = [&](Times& taken, std::size_t cell, const auto& work) {
    subject.find(cell);
    const Nanoseconds time = timeOf(work);
    taken.add(subject.ownTime().value_or(time));
    if (afterEdit) afterEdit();
  };
  for (std::size_t k = 0; k < plan.cells.size() + plan.lag; ++k) {
    if (k < plan.cells.size()) {
      const std::size_t cell = plan.cells[k];
      edit(times.first, cell, [&] { subject.remove(cell); });
    }
    if (k >= plan.lag) {
      const std::size_t cell = plan.cells[k - plan.lag];
      edit(times.back, cell, [&] { subject.add(cell, tiles.at[cell]); });
    }
  }
}

}  // namespace lgs::bench
