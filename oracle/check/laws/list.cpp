#include "oracle/check/laws/list.h"

namespace lgs::oracle {
namespace {

enum class Of { any, library };

}  // namespace

Laws lawsOf(const Seen& seen) {
  Laws all;
#define LGS_ADDED(name, whose) \
  if (Of::whose == Of::any || seen.library != nullptr) all.push_back(laws::name());
  LGS_LAWS(LGS_ADDED)
#undef LGS_ADDED
  return all;
}

}  // namespace lgs::oracle
