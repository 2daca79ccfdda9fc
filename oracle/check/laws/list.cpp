#include "oracle/check/laws/list.h"

namespace lgs::oracle {
namespace {

enum class Of { any, library, regions };

}  // namespace

Laws lawsOf(const Seen& seen) {
  Laws all;
  const bool isOfRegions = seen.library == nullptr && seen.engine.can().regions;
  const auto isHeld = [&](Of whose) {
    return whose == Of::regions ? isOfRegions : seen.library != nullptr || (whose == Of::any && !isOfRegions);
  };
#define LGS_ADDED(name, whose) \
  if (isHeld(Of::whose)) all.push_back(laws::name());
  LGS_LAWS(LGS_ADDED)
#undef LGS_ADDED
  return all;
}

}  // namespace lgs::oracle
