// What stands reads as it was placed: the edited cells after each commit; all of them where many may have changed, and
// now and then.
#include "oracle/check/laws/list.h"
#include "oracle/check/reads.h"

namespace lgs::oracle {
namespace {

class PolygonsLaw : public Law {
 public:
  Found after(Seen& seen, const Judged& judged, bool isRefused) override {
    using enum Call::Kind;
    const Call::Kind kind = judged.call.kind;
    const bool isMuch = kind == group || kind == rollBack || kind == redo;
    return isMuch && !isRefused ? nowAndThen(seen) : std::nullopt;
  }

  Found afterCommit(Seen& seen) override {
    for (const Cell& cell : seen.edited)
      if (auto wrong = readCell(seen.world(), seen.model().standing(), cell)) return found(seen, std::move(*wrong));
    return std::nullopt;
  }

  Found nowAndThen(Seen& seen) override {
    auto wrong = readPolygons(seen.library->player());
    return wrong ? found(seen, std::move(*wrong)) : std::nullopt;
  }

 private:
  static Found found(const Seen& seen, WrongRead wrong) {
    return seen.mismatch(Mismatch::Kind::reading, std::move(wrong.text), std::move(wrong.about));
  }
};

}  // namespace

std::unique_ptr<Law> laws::polygons() { return std::make_unique<PolygonsLaw>(); }

}  // namespace lgs::oracle
