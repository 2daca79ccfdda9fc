#include "oracle/tests/engines/workbench.h"

#include "oracle/check/shell.h"
#include "oracle/trace/file.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace lgs::test {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

/// As much as there is: a process may be gone while its folder in /proc is read, which an iterator would throw for.
std::string contentOf(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return std::move(text).str();
}

}  // namespace

void Workbench::TearDown() {
  EXPECT_FALSE(isAnyoneLeft());
  InAFolder::TearDown();
}

std::string Workbench::naiveWith(const std::string& piece, const std::string& instead) const {
  return naiveWith({{piece, instead}});
}

std::string Workbench::exampleWith(const std::string& example, const Pieces& replaced) const {
  std::string text = contentOf(LGS_SOURCE_DIR "/examples/engines/" + example);
  for (const auto& [piece, instead] : replaced) {
    const std::size_t at = text.find(piece);
    EXPECT_NE(at, std::string::npos) << piece;
    if (at != std::string::npos) text.replace(at, piece.size(), instead);
    EXPECT_EQ(text.find(piece, at + instead.size()), std::string::npos) << piece << " is there twice";
  }
  put("engine.py", text);
  return "exec " LGS_PYTHON " -S " + oracle::shellWord(path("engine.py"));
}

std::string Workbench::naiveThat(const std::string& statement) const {
  const std::string line = "        elif word == \"commit\":\n";
  return naiveWith(line, line + "            import os, signal, time\n            " + statement + "\n");
}

Workbench::Outcome Workbench::sh(const std::string& line) const {
  const auto begin = std::chrono::steady_clock::now();
  const char* const given = std::getenv("LGS_COMMAND");  // by whoever plants bugs in copies of it
  const std::string all = "cd " + oracle::shellWord(folder_.string()) + " && lgs() { " +
                          oracle::shellWord(given != nullptr ? given : LGS_COMMAND) + " \"$@\"; }; { " + line +
                          "; } 2>&1";
  Outcome outcome{outcomeOf(all)};
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

Workbench::Outcome Workbench::check(const std::string& engine, const std::string& arguments, int timeout) const {
  return sh("lgs check --engine " + oracle::shellWord(engine) + " --engine-timeout " + std::to_string(timeout) + " " +
            arguments);
}

bool Workbench::isAnyoneLeft() const {
  const auto isThere = [&] {
    std::error_code gone;
    for (const auto& entry : fs::directory_iterator("/proc", gone))
      if (contentOf(entry.path() / "cmdline").find(folder_.string() + "/engine.py") != std::string::npos) return true;
    return false;
  };
  for (int k = 0; k < 100; ++k, std::this_thread::sleep_for(20ms))
    if (!isThere()) return false;
  return true;
}

std::string Workbench::afterWord(const std::string& text, const std::string& word) {
  const std::size_t at = ("\n" + text).find("\n" + word);
  EXPECT_NE(at, std::string::npos) << word << " is not in\n" << text;
  if (at == std::string::npos) return "false";
  const std::size_t begin = at + word.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

std::size_t Workbench::editsOfMismatch() const {
  for (const auto& entry : fs::directory_iterator(folder_ / "out")) {
    if (entry.path().extension() != ".trace") continue;
    const auto parsed = oracle::parseTrace(contentOf(entry.path()));
    EXPECT_FALSE(parsed.error);
    return oracle::editCount(parsed.trace);
  }
  ADD_FAILURE() << "no mismatch was saved";
  return 0;
}

}  // namespace lgs::test
