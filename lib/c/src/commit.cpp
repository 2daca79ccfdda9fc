// Commits and going back.
#include "inside.h"

using namespace lgs::c;

namespace {

/// Keeps the lists, and tells where they are.
lgs_changes keep(const lgs::Changes& changes, lgs_change_lists& lists) {
  copyBytes(changes.removed.data(), changes.removed.size(), lists.removed);
  copyBytes(changes.added.data(), changes.added.size(), lists.added);
  copyBytes(changes.relinked.data(), changes.relinked.size(), lists.relinked);
  return {lists.removed.data(), lists.added.data(),    lists.relinked.data(), lists.removed.size(),
          lists.added.size(),   lists.relinked.size(), changes.before,        changes.after};
}

}  // namespace

lgs_status lgs_commit(lgs_world* world, lgs_changes* changes) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  const lgs::Changes& made = world->world.commit();
  put(changes, keep(made, world->lists));
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
  put(changes, keep(made, world->lists));
  return LGS_OK;
}

lgs_status lgs_checkpoint(lgs_world* world, lgs_mark* mark) noexcept {
  if (!world || !mark) return LGS_BAD_ARGUMENT;
  *mark = {world->world.checkpoint().value};
  return LGS_OK;
}

lgs_status lgs_roll_back(lgs_world* world, lgs_mark mark, lgs_changes* changes, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  if (const auto done = world->world.rollBack(fromC(mark)); !done) return refuse(done.error(), error);
  put(changes, keep(world->world.changesOfRollBack(), world->lists));
  return LGS_OK;
}

lgs_status lgs_forget(lgs_world* world, lgs_mark mark, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  const auto done = world->world.forget(fromC(mark));
  return done ? LGS_OK : refuse(done.error(), error);
}
