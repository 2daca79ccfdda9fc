// A shared object that does something bad at its first commit with a polygon. LGS_BAD in the environment says what.
#include <lgs/lgs_engine.h>

#include <unistd.h>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace {

int polygons = 0;

void* create() { return &polygons; }

void nothing(void*) {}

void reset(void*) { polygons = 0; }

void preserve(void*, std::uint32_t, std::uint32_t) {}

void add(void*, const char*, std::int32_t, std::int32_t, std::uint32_t, const std::int32_t*, std::size_t) {
  ++polygons;
}

void remove(void*, const char*) { --polygons; }

void commit(void*, const lgs_engine_answer*) {
  const char* const bad = std::getenv("LGS_BAD");
  const std::string_view what = bad == nullptr ? "" : bad;
  if (polygons == 0) return;
  std::printf("now it goes wrong\n");
  std::fflush(stdout);
  if (what == "crash") std::abort();
  if (what == "throw") throw std::runtime_error("thrown");
  if (what == "exit") std::_Exit(3);
  if (what == "sleep") sleep(1000);
  for (volatile bool goesOn = what == "hang"; goesOn;) {
  }
}

}  // namespace

extern "C" const lgs_engine_table* lgs_engine() {
  static const lgs_engine_table kTable{LGS_ENGINE_VERSION, "bad", "several", create, nothing, reset,
                                       preserve,           add,   remove,    commit};
  return &kTable;
}
