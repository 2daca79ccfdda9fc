// Work done in a child process, so that a failed assertion, a crash or an endless loop of the engine's is a result like
// any other: it can be told, shrunk and saved. POSIX only.
#pragma once

#include <sys/mman.h>

#include <functional>
#include <new>
#include <optional>
#include <string>
#include <type_traits>

namespace lgs::oracle {

struct IsolationOptions {
  // After so much silence (see stillAlive()) the child counts as hung and is ended. Its own CPU time counts, so that a
  // busy machine is no reason; only a child that sleeps is ended by the clock on the wall.
  unsigned seconds = 60;  ///< of CPU time
  unsigned asleep = 600;  ///< seconds on the wall
  bool quiet = false;     ///< drop what the child writes to the standard error
};

/// Runs `work` in a child process and waits for it. Nothing if it came to its end; otherwise how it ended, as a phrase:
/// "crashed with SIGABRT". What it writes to memory is lost, except into Shared values; an exception is a crash.
std::optional<std::string> crashOf(const std::function<void()>& work, const IsolationOptions& options = {});

/// To be called in the child now and then by work that takes long.
void stillAlive();

/// A value that a child process shares with its parent.
template <class T>
class Shared {
  static_assert(std::is_trivially_destructible_v<T>);

 public:
  Shared() : place_(mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (place_ == MAP_FAILED) throw std::bad_alloc();
    new (place_) T();
  }
  ~Shared() { munmap(place_, sizeof(T)); }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  T& operator*() const { return *static_cast<T*>(place_); }
  T* operator->() const { return static_cast<T*>(place_); }

 private:
  void* place_;
};

}  // namespace lgs::oracle
