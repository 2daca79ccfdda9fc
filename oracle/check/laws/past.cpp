// Laws 7 and 12: a world in which nothing was undone, copied, saved or refused is the same, to the last id and byte.
#include "oracle/check/laws/list.h"
#include "oracle/check/observed.h"

namespace lgs::oracle {
namespace {

class PastLaw : public Law {
 public:
  Found atEnd(Seen& seen) override {
    const Player& player = seen.library->player();
    if (!player.hasLeft() || !player.isOfOnePast()) return std::nullopt;
    ++seen.stats.pasts;
    std::string wrong = wrongPast(player);
    return wrong.empty() ? std::nullopt : Found(seen.mismatch(Mismatch::Kind::past, std::move(wrong)));
  }
};

}  // namespace

std::unique_ptr<Law> laws::past() { return std::make_unique<PastLaw>(); }

}  // namespace lgs::oracle
