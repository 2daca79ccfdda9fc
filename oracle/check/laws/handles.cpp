// A handle of a polygon that is gone names nothing, until a mark of before brings the polygon back.
#include "oracle/check/laws/list.h"

#include <algorithm>

namespace lgs::oracle {
namespace {

class HandlesLaw : public Law {
 public:
  void before(Seen&, const Judged& judged) override {
    going_.clear();
    if (!judged.verdict.accepted || judged.verdict.isOpen || judged.call.kind == Call::Kind::setBlock) return;
    for (const Named& named : judged.call.goes) going_.push_back(named.handle);
  }

  Found after(Seen& seen, const Judged& judged, bool isRefused) override {
    if (!isRefused && !isEdit(judged.call.kind)) gone_.clear();  // what was void may be valid again
    if (isRefused || !isEdit(judged.call.kind)) return std::nullopt;
    World& world = seen.world();
    for (const PolygonHandle handle : going_) {
      const auto again = world.remove(handle);
      if (again || again.error().code != ErrorCode::staleHandle || again.error().other != handle ||
          world.polygon(handle) || world.cellOf(handle))
        return seen.mismatch(Mismatch::Kind::verdict, "the handle of a removed polygon is not stale");
      gone_.push_back(handle);
    }
    return std::nullopt;
  }

  Found nowAndThen(Seen& seen) override {
    const World& world = seen.world();
    const auto isThere = [&](PolygonHandle handle) { return world.polygon(handle).has_value(); };
    if (std::ranges::any_of(gone_, isThere))
      return seen.mismatch(Mismatch::Kind::reading, "the handle of a removed polygon names another one now");
    for (const auto& entry : seen.model().standing().cells())
      if (isThere({entry.second.front().handle.cellRef, 0}))
        return seen.mismatch(Mismatch::Kind::reading, "a handle without serial names a polygon");
    return std::nullopt;
  }

 private:
  std::vector<PolygonHandle> going_, gone_;
};

}  // namespace

std::unique_ptr<Law> laws::handles() { return std::make_unique<HandlesLaw>(); }

}  // namespace lgs::oracle
