// Prints a hash of all that the library gives out, part by part, for random edits that are the same everywhere. So are
// the hashes: expected.txt has them, and docs/platforms.md says where they were seen.
//
//   lgs_platform          all parts, a line for each, and a hash of all
//   lgs_platform PART     one part, step by step: the first line that differs between two machines says where
#include "parts.h"

#include <array>
#include <cstdio>
#include <string_view>

namespace {

struct Part {
  const char* name;
  void (*run)(platform::Hash& hash);
};

constexpr std::array<Part, 11> kParts{{
    {"edits", platform::edits},
    {"relations", platform::relations},
    {"executor", platform::executor},
    {"roll-back", platform::rollBack},
    {"saves", platform::saves},
    {"unloading", platform::unloading},
    {"brushes", platform::brushes},
    {"views", platform::views},
    {"questions", platform::questions},
    {"radial", platform::radial},
    {"answers", platform::answers},
}};

void printAll() {
  platform::Hash all("all", false);
  for (const Part& part : kParts) {
    platform::Hash hash(part.name, false);
    part.run(hash);
    std::printf("%s %s\n", part.name, hash.text().data);
    all.number(hash.value());
  }
  std::printf("all %s\n", all.text().data);
}

bool printSteps(std::string_view name) {
  for (const Part& part : kParts) {
    if (name != part.name) continue;
    platform::Hash hash(part.name, true);
    part.run(hash);
    return true;
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 1) {
    printAll();
  } else if (argc != 2 || !printSteps(argv[1])) {
    std::fputs("usage: lgs_platform [PART]\nparts:", stderr);
    for (const Part& part : kParts) std::fprintf(stderr, " %s", part.name);
    std::fputs("\n", stderr);
    return 2;
  }
}
