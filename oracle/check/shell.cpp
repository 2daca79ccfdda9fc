#include "oracle/check/shell.h"

#include <filesystem>
#include <system_error>

namespace lgs::oracle {

std::string shellPath(const std::string& path) { return shellWord(std::filesystem::absolute(path).string()); }

std::string thisFolder() { return shellWord(std::filesystem::current_path().string()); }

std::string thisProgram(std::string_view otherwise) {
  std::error_code none;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", none);
  return none ? shellWord(otherwise) : shellWord(program.string());
}

}  // namespace lgs::oracle
