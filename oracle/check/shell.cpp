#include "oracle/check/shell.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace lgs::oracle {

std::string shellWord(std::string_view word) {
  const auto isPlain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           std::string_view("_-./,:=+@%").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), isPlain)) return std::string(word);
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string shellPath(const std::string& path) { return shellWord(std::filesystem::absolute(path).string()); }

std::string thisFolder() { return shellWord(std::filesystem::current_path().string()); }

std::string thisProgram(std::string_view otherwise) {
  std::error_code none;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", none);
  return none ? shellWord(otherwise) : shellWord(program.string());
}

}  // namespace lgs::oracle
