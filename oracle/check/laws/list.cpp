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
  int number = 0;
  const auto add = [&](Of whose, std::unique_ptr<Law> (*law)()) {
    const int own = number++;
    if (isHeld(whose) && seen.options.law.value_or(own) == own) all.push_back(law()), all.back()->number = own;
  };
#define LGS_ADDED(name, whose) add(Of::whose, laws::name);
  LGS_LAWS(LGS_ADDED)
#undef LGS_ADDED
  return all;
}

}  // namespace lgs::oracle
