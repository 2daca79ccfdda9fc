// Writes the pages of cases.h into a folder, for the test in a browser.
#include "oracle/tests/page/cases.h"
#include "oracle/trace/file.h"

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  for (const auto& made : lgs::oracle::test::pageCases()) {
    const std::string path = std::string(argv[1]) + "/" + made.name + ".html";
    if (!lgs::oracle::writeFile(path, lgs::oracle::writePage(made.trace, made.options))) return 2;
    std::printf("%s\n", path.c_str());
  }
  return 0;
}
