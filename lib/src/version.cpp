#include <lgs/version.h>

namespace lgs {

Version version() { return kVersion; }

}  // namespace lgs
