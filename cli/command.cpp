#include "cli/command.h"

#include "oracle/trace/file.h"

#include <fmt/format.h>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <vector>

namespace lgs::cli {

Status complain(std::string_view text) {
  fmt::print(stderr, "{}\n", text);
  return Status::badInput;
}

Status write(const std::string& path, std::string_view content) {
  const auto done = oracle::writeFile(path, content);
  return done ? Status::fine : complain(message(done.error(), path == "-" ? "standard output" : path));
}

Status flushed(Status status) {
  errno = 0;
  const bool lost = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
  if (!lost || status == Status::badInput) return status;  // bad input has had its complaint
  const std::string why = errno == 0 ? "" : ": " + std::generic_category().message(errno);
  const Status bad = complain("standard output: cannot write" + why);
  return status == Status::fine ? bad : status;
}

Status tryOutputs(std::initializer_list<std::string> paths) {
  if (std::count(paths.begin(), paths.end(), "-") > 1) {
    return complain("only one output can go to the standard output; name a file for the others");
  }
  for (const std::string& path : paths) {
    if (path.empty()) continue;
    if (const auto done = oracle::tryToWrite(path); !done) return complain(message(done.error(), path));
  }
  return Status::fine;
}

CLI::Option* addWholeNumber(CLI::App& command, const std::string& name, std::function<void(std::uint64_t)> set,
                            WholeRange range, const std::string& description) {
  const auto read = [name, set = std::move(set), range](const std::string& text) {
    std::uint64_t number = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (status != std::errc() || end != text.data() + text.size() || number < range.min || number > range.max) {
      throw CLI::ValidationError(name,
                                 fmt::format("'{}' is not a whole number from {} to {}", text, range.min, range.max));
    }
    set(number);
  };
  return command.add_option_function<std::string>(name, read, description);
}

double readReal(const std::string& name, const std::string& text, RealRange range) {
  double number = 0;
  const auto [end, status] =
      std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::general);
  const bool isNumber = status == std::errc() && end == text.data() + text.size();
  if (!isNumber || !(number >= range.min && number <= range.max)) {  // false for nan
    throw CLI::ValidationError(name, fmt::format("'{}' is not a number from {} to {}", text, range.min, range.max));
  }
  return number;
}

CLI::Option* addReal(CLI::App& command, const std::string& name, std::function<void(double)> set, RealRange range,
                     const std::string& description) {
  const auto read = [name, set = std::move(set), range](const std::string& text) { set(readReal(name, text, range)); };
  return command.add_option_function<std::string>(name, read, description);
}

namespace {

namespace fs = std::filesystem;

/// The folder of the program that runs; empty if the system does not say.
fs::path ownFolder() {
  std::error_code none;
  return fs::read_symlink("/proc/self/exe", none).parent_path();
}

}  // namespace

tl::expected<std::string, std::string> programBeside(std::string_view name) {
  const std::string program = fmt::format("lgs-{}", name);
  std::vector<fs::path> folders{ownFolder()};
  const char* const path = std::getenv("PATH");
  std::istringstream rest(path == nullptr ? "" : path);
  for (std::string folder; std::getline(rest, folder, ':');) folders.emplace_back(folder);
  for (const fs::path& folder : folders) {
    std::error_code none;
    if (!folder.empty() && fs::is_regular_file(folder / program, none)) return (folder / program).string();
  }
  return tl::unexpected(
      fmt::format("{} is not beside lgs, in {}, nor in a folder of PATH. To build it in a checkout:\n"
                  "  cmake --preset release && cmake --build --preset release --target {}",
                  program, ownFolder().string(), program));
}

int runCommand(CLI::App& app, const Action& chosen, int argc, const char* const* argv) {
  const auto run = [&] {
    try {
      app.parse(argc, argv);
      return chosen();
    } catch (const CLI::ParseError& error) {
      // CLI11 has a status of its own for each kind of bad usage. Help and version have 0.
      return app.exit(error) == 0 ? Status::fine : Status::badInput;
    } catch (const std::exception& error) {
      return complain(fmt::format("lgs: {}", error.what()));
    }
  };
  return static_cast<int>(flushed(run()));
}

int runProgram(int argc, const char* const* argv, void (*add)(CLI::App& app, Action& chosen)) {
  CLI::App app("", "lgs");
  app.get_formatter()->column_width(34);
  Action chosen;
  add(app, chosen);
  app.require_subcommand(1);
  const std::string name = app.get_subcommands([](const CLI::App*) { return true; }).front()->get_name();
  std::vector<const char*> arguments{"lgs", name.c_str()};
  arguments.insert(arguments.end(), argv + std::min(argc, 1), argv + argc);
  return runCommand(app, chosen, static_cast<int>(arguments.size()), arguments.data());
}

}  // namespace lgs::cli
