// Laws 8 and 9: a brush differs from its exact result by a unit at most, and what it does not reach stays, or is told as
// bent.
#include "oracle/cgal/brushed.h"
#include "oracle/check/laws/list.h"
#include "oracle/check/reach.h"
#include "oracle/trace/plain_edits.h"

namespace lgs::oracle {
namespace {

CellRect near(const BrushEdit& brush) {
  const auto [min, max] = cellsUnder(brush);
  return {{min.i - 1, min.j - 1}, {max.i + 1, max.j + 1}};
}

class BrushesLaw : public Law {
 public:
  void before(Seen& seen, const Judged& judged) override {
    if (judged.call.kind == Call::Kind::brush) before_ = sceneOf(seen.model().standing(), near(judged.call.brush));
  }

  // From then on, what the brush did is as if it had been done by hand.
  Found after(Seen& seen, const Judged& judged, bool isRefused) override {
    if (isRefused || judged.call.kind != Call::Kind::brush) return std::nullopt;
    const BrushEdit& brush = judged.call.brush;
    const Brushed& done = seen.library->player().brushed();
    if (std::string wrong = wrongReach(brush, done); !wrong.empty())
      return seen.mismatch(Mismatch::Kind::reach, std::move(wrong));
    if (!seen.options.cgal) return std::nullopt;
    ++seen.stats.brushed;
    auto far = farFromExact(before_, brush, sceneOf(seen.model().standing(), near(brush)));
    if (!far) return std::nullopt;
    static_cast<void>(seen.engine.commit());  // for the picture
    return seen.mismatch(Mismatch::Kind::rounding, std::move(*far));
  }

 private:
  Scene before_;
};

}  // namespace

std::unique_ptr<Law> laws::brushes() { return std::make_unique<BrushesLaw>(); }

}  // namespace lgs::oracle
