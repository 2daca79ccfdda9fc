// Laws 8 to 10: a brush differs from its exact result by a unit at most; what it does not reach stays, or is told as
// bent; cells on both sides of a line are cut in one point; and a region that is carved and filled again leaves no seam.
#include "oracle/cgal/brushed.h"
#include "oracle/check/laws/list.h"
#include "oracle/check/reach.h"
#include "oracle/check/rims.h"
#include "oracle/trace/plain_edits.h"

namespace lgs::oracle {
namespace {

CellRect near(const BrushEdit& brush) {
  const auto [min, max] = cellsUnder(brush);
  return {{min.i - 1, min.j - 1}, {max.i + 1, max.j + 1}};
}

bool isFilledAgain(const BrushEdit& carved, const BrushEdit& brush) {
  return brush.deed == BrushEdit::Deed::fill && brush.rings == carved.rings && brush.isEvenOdd == carved.isEvenOdd &&
         brush.staying.empty() && carved.staying.empty();
}

class BrushesLaw : public Law {
 public:
  void before(Seen& seen, const Judged& judged) override {
    if (judged.call.kind == Call::Kind::brush)
      before_ = sceneOf(seen.model().standing(), near(judged.call.brush));
    else
      carved_.reset();
  }

  // From then on, what the brush did is as if it had been done by hand.
  Found after(Seen& seen, const Judged& judged, bool isRefused) override {
    if (judged.call.kind != Call::Kind::brush) return std::nullopt;
    const std::optional<Carved> carved = std::exchange(carved_, std::nullopt);
    if (isRefused) return std::nullopt;
    const BrushEdit& brush = judged.call.brush;
    const Brushed& done = seen.library->player().brushed();
    if (std::string wrong = wrongReach(brush, done); !wrong.empty())
      return seen.mismatch(Mismatch::Kind::reach, std::move(wrong));
    const Scene after = sceneOf(seen.model().standing(), near(brush));
    if (std::string wrong = wrongRim(brush, before_, after); !wrong.empty())
      return seen.mismatch(Mismatch::Kind::rounding, std::move(wrong));
    if (!seen.options.cgal) return std::nullopt;
    ++seen.stats.brushed;
    auto far = farFromExact(before_, brush, after);
    if (!far && carved && isFilledAgain(carved->brush, brush)) far = seamIn(carved->before, brush, after);
    if (!far) {
      if (brush.deed == BrushEdit::Deed::carve) carved_ = Carved{brush, std::move(before_)};
      return std::nullopt;
    }
    static_cast<void>(seen.engine.commit());  // for the picture
    return seen.mismatch(Mismatch::Kind::rounding, std::move(*far));
  }

 private:
  struct Carved {
    BrushEdit brush;
    Scene before;
  };
  Scene before_;
  std::optional<Carved> carved_;  // by the call before this one
};

}  // namespace

std::unique_ptr<Law> laws::brushes() { return std::make_unique<BrushesLaw>(); }

}  // namespace lgs::oracle
