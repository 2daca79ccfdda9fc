// Commands of a shell, and folders for tests that need files.
#pragma once

#include <gtest/gtest.h>
#include <filesystem>
#include <string>

namespace lgs::test {

struct Outcome {
  int status = -1;   ///< -1: it did not end by itself
  std::string text;  ///< what it wrote to its standard output
};

Outcome outcomeOf(const std::string& command);

/// Each test has a folder of its own, which is removed when it ends.
class InAFolder : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void put(const std::string& name, const std::string& content) const;
  std::string get(const std::string& name) const;

  std::filesystem::path folder_;
};

}  // namespace lgs::test
