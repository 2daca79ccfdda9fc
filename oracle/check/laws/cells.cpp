// While a world follows its cells, a copy that cellChanges() alone keeps up to date is what stands, as of the last commit.
#include "oracle/check/laws/list.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace lgs::oracle {
namespace {

using Content = std::vector<std::tuple<PolygonHandle, Block, LocalPolygon>>;

Content contentOf(std::span<const PlacedPolygon> polygons) {
  Content out;
  for (const PlacedPolygon& p : polygons)
    out.emplace_back(p.handle, p.block, LocalPolygon(p.vertices.begin(), p.vertices.end()));
  return out;
}

std::map<Cell, Content> cellsOf(const World& world) {
  std::map<Cell, Content> cells;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) { cells[cell].push_back(contentOf({&p, 1})[0]); });
  return cells;
}

class CellsLaw : public Law {
 public:
  Found after(Seen& seen, const Judged& judged, bool isRefused) override {
    using enum Call::Kind;
    const Call::Kind kind = judged.call.kind;
    if (isRefused) return std::nullopt;
    if (kind == follow) isOn_ = judged.call.nth % 2 != 0;
    if (kind == follow) begin(seen.world());
    if (kind == load) isOn_ = false;
    if (isOfMemory(kind) || kind == leave) isOrdered_ = false;  // cells that come and go are named, too
    if (isOn_) note(cellsOf(seen.world()));
    return std::nullopt;
  }

  Found afterTravel(Seen& seen) override {
    isOrdered_ = false;  // edits may be pending from before the mark
    return isOn_ ? listen(seen, false) : std::nullopt;
  }

  Found afterCommit(Seen& seen) override {
    if (!isOn_) return std::nullopt;
    if (auto found = listen(seen, true)) return found;
    if (isTold(seen.world())) return std::nullopt;
    return seen.mismatch(Mismatch::Kind::changes, "cellChanges() does not tell of a cell that changed");
  }

 private:
  // Nothing is pending.
  void begin(const World& world) {
    told_ = now_ = cellsOf(world);
    first_.clear();
  }

  bool isTold(const World& world) const {
    std::map<Cell, std::size_t> met;
    const auto isNext = [&](Cell cell, const PlacedPolygon& p) {
      const auto told = told_.find(cell);
      if (told == told_.end()) return false;
      const std::size_t k = met[cell]++;
      if (k >= told->second.size()) return false;
      const auto& [handle, block, vertices] = told->second[k];
      return handle == p.handle && block == p.block && std::ranges::equal(vertices, p.vertices);
    };
    bool areAll = true;
    world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) { areAll = areAll && isNext(cell, p); });
    return areAll &&
           std::ranges::all_of(told_, [&](const auto& entry) { return met[entry.first] == entry.second.size(); });
  }

  // Which edit was the first since the last commit to change each cell.
  void note(std::map<Cell, Content> now) {
    ++calls_;
    for (const auto& [cell, content] : now)
      if (now_[cell] != content) first_.try_emplace(cell, calls_);
    for (const auto& [cell, content] : now_)
      if (!now.contains(cell)) first_.try_emplace(cell, calls_);
    now_ = std::move(now);
  }

  Found listen(Seen& seen, bool isCommit) {
    std::set<Cell> named;
    const std::map<Cell, std::uint64_t> first = std::exchange(first_, {});
    const bool isOrdered = std::exchange(isOrdered_, isCommit);
    std::uint64_t last = 0;
    now_ = cellsOf(seen.world());
    for (const CellChange& change : seen.world().cellChanges()) {
      const auto wrong = [&](const char* what) {
        return seen.mismatch(Mismatch::Kind::changes,
                             fmt::format("cellChanges() {} cell ({}, {})", what, change.cell.i, change.cell.j));
      };
      if (!named.insert(change.cell).second) return wrong("names twice");
      if (const auto call = first.find(change.cell); isOrdered && call != first.end()) {
        if (call->second < last) return wrong("names in another order than that of the calls");
        last = call->second;
      }
      if (told_[change.cell] != contentOf(change.before)) return wrong("tells of another past of");
      told_[change.cell] = contentOf(change.now);
      if (change.now.empty()) told_.erase(change.cell);
    }
    return std::nullopt;
  }

  bool isOn_ = false;
  std::map<Cell, Content> told_;
  std::map<Cell, Content> now_;  // edits that are pending, too
  std::map<Cell, std::uint64_t> first_;
  std::uint64_t calls_ = 0;
  bool isOrdered_ = true;  // whether the order is that of first_ alone
};

}  // namespace

std::unique_ptr<Law> laws::cells() { return std::make_unique<CellsLaw>(); }

}  // namespace lgs::oracle
