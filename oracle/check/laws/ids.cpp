// Law 6 of an engine that reports what changed: it uses its ids rightly, or no copy could follow.
#include "oracle/check/laws/list.h"

namespace lgs::oracle {
namespace {

class IdsLaw : public Law {
 public:
  Found afterCommit(Seen& seen) override {
    const Delta* const delta = seen.engine.delta();
    if (delta == nullptr || delta->wrongId().empty()) return std::nullopt;
    return seen.mismatch(Mismatch::Kind::changes, delta->wrongId() + "\n" + seen.told());
  }
};

}  // namespace

std::unique_ptr<Law> laws::ids() { return std::make_unique<IdsLaw>(); }

}  // namespace lgs::oracle
