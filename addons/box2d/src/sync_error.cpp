#include <lgs/box2d/sync_error.h>

namespace lgs::box2d {

const char* message(SyncError error) {
  switch (error) {
    case SyncError::notTheLast:
      return "these changes are not the last ones of this world: they are older, or another world's";
    case SyncError::shownAlready:
      return "these changes are shown already";
    case SyncError::leftOut:
      return "changes before these were left out, or the world was assigned to; resync()";
  }
  return "unknown error";
}

}  // namespace lgs::box2d
