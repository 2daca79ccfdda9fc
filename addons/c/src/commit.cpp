// Commits, roll-back and redo.
#include "inside.h"

using namespace lgs::c;

namespace {

/// Keeps the lists, and tells where they are.
lgs_changes keep(const lgs::Changes& changes, std::vector<lgs_segment_id>& kept) {
  const std::size_t count = changes.removed.size() + changes.added.size() + changes.relinked.size();
  if (kept.size() < count) kept.resize(count);
  lgs_segment_id* to = kept.data();
  const auto copy = [&to](const std::vector<lgs::SegmentId>& list) {
    const lgs_segment_id* const first = to;
    for (const lgs::SegmentId id : list) *to++ = toC(id);
    return first;
  };
  lgs_changes out;
  out.removed = copy(changes.removed);
  out.added = copy(changes.added);
  out.relinked = copy(changes.relinked);
  out.removed_count = changes.removed.size();
  out.added_count = changes.added.size();
  out.relinked_count = changes.relinked.size();
  out.before = changes.before;
  out.after = changes.after;
  return out;
}

}  // namespace

lgs_status lgs_commit(lgs_world* world, lgs_changes* changes) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  const lgs::Changes& made = world->world.commit();
  if (changes) *changes = keep(made, world->changed);
  return LGS_OK;
}

lgs_status lgs_commit_with(lgs_world* world, lgs_executor_fn executor, void* user, lgs_changes* changes) noexcept {
  if (!world || !executor) return LGS_BAD_ARGUMENT;
  using Job = std::function<void(std::size_t)>;
  const lgs::Changes& made = world->world.commit([&](std::size_t count, const Job& job) {
    Job copy = job;
    executor(
        user, count, [](void* work, size_t index) noexcept { (*static_cast<Job*>(work))(index); }, &copy);
  });
  if (changes) *changes = keep(made, world->changed);
  return LGS_OK;
}

lgs_status lgs_set_mark(lgs_world* world, lgs_mark* mark) noexcept {
  if (!world || !mark) return LGS_BAD_ARGUMENT;
  *mark = {world->world.mark().value};
  return LGS_OK;
}

lgs_status lgs_roll_back(lgs_world* world, lgs_mark mark, lgs_changes* changes, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  if (const auto done = world->world.rollBack(fromC(mark)); !done) return refuse(done.error(), error);
  if (changes) *changes = keep(world->world.changesOfRollBack(), world->changed);
  return LGS_OK;
}

lgs_status lgs_roll_back_keeping(lgs_world* world, lgs_mark mark, lgs_changes* changes, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  if (const auto done = world->world.rollBack(fromC(mark), lgs::Undone::keep); !done)
    return refuse(done.error(), error);
  if (changes) *changes = keep(world->world.changesOfRollBack(), world->changed);
  return LGS_OK;
}

lgs_status lgs_redo(lgs_world* world, lgs_mark mark, lgs_changes* changes, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  if (const auto done = world->world.redo(fromC(mark)); !done) return refuse(done.error(), error);
  if (changes) *changes = keep(world->world.changesOfRollBack(), world->changed);
  return LGS_OK;
}

lgs_status lgs_forget(lgs_world* world, lgs_mark mark, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  const auto done = world->world.forget(fromC(mark));
  return done ? LGS_OK : refuse(done.error(), error);
}
