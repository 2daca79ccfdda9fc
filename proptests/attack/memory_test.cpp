// Allocation n of each door fails, and all after it, in a process of its own: the program ends. Where the door itself
// asks for memory in vain, before or after the call, the game goes on, and what it has must be whole.
#include "door.h"
#include "followed.h"

#include "oracle/trace/dump.h"
#include "proptests/laws/allocations.h"
#include "proptests/support/outline_by_laws.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <new>

namespace lgs::test {
namespace {

enum class End : std::uint8_t { done, aborted, wentOn, broken };

bool isWhole(Scene& scene) {
  for (World* world : {&scene.world, &scene.other}) {
    world->commit();
    if (oracle::outlineOf(*world) != outlineByLaws(*world, {})) return false;
  }
  return lgs_commit(scene.c.get(), nullptr) == LGS_OK && seenOf(scene.c.get()).chunks > 0;
}

End endOf(const Door& door, Scene& scene, std::uint64_t number) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGABRT, SIG_DFL);
    static_cast<void>(std::freopen("/dev/null", "w", stderr));  // what std::terminate() says
    End end = End::done;
    memoryRunsOutAfter(number);
    try {
      static_cast<void>(door.isRefused(scene, {}));
    } catch (const std::bad_alloc&) {
      end = End::wentOn;
    }
    memoryRunsOutAfter(std::uint64_t{1} << 40);
    if (end == End::wentOn && !isWhole(scene)) end = End::broken;
    _exit(static_cast<int>(end));
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status)) return static_cast<End>(WEXITSTATUS(status));
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT ? End::aborted : End::broken;
}

TEST(Attack, MemoryThatRunsOut) {
  std::size_t cases = 0;
  for (const Door& door : doors()) {
    Scene scene;
    // What the door asks for itself is there beforehand, as far as it can be.
    for (const Kind& kind : door.arguments) static_cast<void>(kind.count(scene));
    static_cast<void>(followedBy(scene));
    static_cast<void>(followedInCBy(scene));
    if (door.name.starts_with("box2d::")) static_cast<void>(door.isRefused(scene, {}));
    scene.refresh();
    End end = End::aborted;
    // Of many the later ones more and more sparsely.
    for (std::uint64_t number = 0; end != End::done; number += 1 + number / 8) {
      end = endOf(door, scene, number);
      ++cases;
      EXPECT_NE(end, End::broken) << door.name << ", allocation " << number << ", case " << cases;
      if (end == End::broken) break;
    }
  }
  RecordProperty("cases", static_cast<int>(cases));
}

}  // namespace
}  // namespace lgs::test
