// Law 7: a call that is refused changes nothing.
#include "oracle/check/laws/list.h"
#include "oracle/check/reads.h"
#include "oracle/trace/call_text.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

// Whether a refusal left all counts as they were. It may leave new shapes.
bool areSameCounts(const Stats& a, const Stats& b) {
  return a.polygons == b.polygons && a.cells == b.cells && a.segments == b.segments && a.chunks == b.chunks;
}

class RefusalsLaw : public Law {
 public:
  void before(Seen& seen, const Judged& judged) override {
    if (!judged.verdict.accepted || judged.verdict.isOpen) before_ = seen.world().stats();
  }

  Found after(Seen& seen, const Judged& judged, bool isRefused) override {
    if (!isRefused) return std::nullopt;
    const Call& call = judged.call;
    const Player& player = seen.library->player();
    CellSet cells{call.cells.min, call.cells.max};
    for (const Coming& coming : call.comes) cells.insert(coming.cell);
    for (const Named& named : call.goes)
      if (player.isAlive(named.name)) cells.insert(player.standing().cellOf(named.name));
    const bool isSame = std::ranges::none_of(
        cells, [&](Cell cell) { return readCell(player.world(), player.standing(), cell).has_value(); });
    const bool isSameAll = call.kind != Call::Kind::brush || !readPolygons(player);
    if (isSame && isSameAll && areSameCounts(player.world().stats(), before_)) return std::nullopt;
    return seen.mismatch(Mismatch::Kind::refusal, fmt::format("the refusal changed something: {}", printCall(call)));
  }

 private:
  Stats before_;
};

}  // namespace

std::unique_ptr<Law> laws::refusals() { return std::make_unique<RefusalsLaw>(); }

}  // namespace lgs::oracle
