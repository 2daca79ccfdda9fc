// What hangs together, of an engine that puts it out.
#include "oracle/check/laws/list.h"
#include "oracle/views/named_islands.h"

namespace lgs::oracle {
namespace {

class IslandsLaw : public Law {
 public:
  Found afterCommit(Seen& seen) override {
    if (!seen.engine.can().islands) return std::nullopt;
    std::string text = describeIslands(namedIslands(seen.scene()), seen.engine.islands());
    return text.empty() ? std::nullopt : Found(seen.mismatch(Mismatch::Kind::views, std::move(text)));
  }
};

}  // namespace

std::unique_ptr<Law> laws::islands() { return std::make_unique<IslandsLaw>(); }

}  // namespace lgs::oracle
