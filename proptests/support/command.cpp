#include "proptests/support/command.h"

#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace lgs::test {

Outcome outcomeOf(const std::string& command) {
  Outcome outcome;
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) outcome.text.append(buffer.data(), n);
  const int ended = ::pclose(pipe);
  outcome.status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
  return outcome;
}

void InAFolder::SetUp() {
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  folder_ = std::filesystem::temp_directory_path() / ("lgs-" + name + "-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder_);
}

void InAFolder::put(const std::string& name, const std::string& content) const {
  std::ofstream(folder_ / name, std::ios::binary) << content;
}

std::string InAFolder::get(const std::string& name) const {
  std::ostringstream content;
  content << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
  return content.str();
}

}  // namespace lgs::test
