#include "oracle/engine/ending.h"

#include <fmt/format.h>
#include <array>
#include <csignal>
#include <utility>

namespace lgs::oracle {
namespace {

// Empty for a signal that no program ends by, as a rule.
std::string nameOf(int signal) {
  constexpr std::array<std::pair<int, const char*>, 10> kNames{{{SIGABRT, "SIGABRT"},
                                                                {SIGBUS, "SIGBUS"},
                                                                {SIGFPE, "SIGFPE"},
                                                                {SIGILL, "SIGILL"},
                                                                {SIGKILL, "SIGKILL"},
                                                                {SIGPIPE, "SIGPIPE"},
                                                                {SIGSEGV, "SIGSEGV"},
                                                                {SIGSYS, "SIGSYS"},
                                                                {SIGTERM, "SIGTERM"},
                                                                {SIGTRAP, "SIGTRAP"}}};
  for (const auto& [number, name] : kNames)
    if (number == signal) return name;
  return "";
}

}  // namespace

std::string endingOfSignal(int signal) {
  const std::string name = nameOf(signal);
  return "crashed with " + (name.empty() ? fmt::format("signal {}", signal) : name);
}

std::string endingOfStatus(int status) {
  if (status == 0) return kEndedWell;
  constexpr int kShell = 128;
  if (status > kShell && !nameOf(status - kShell).empty()) return endingOfSignal(status - kShell);
  return fmt::format("ended with status {}", status);
}

}  // namespace lgs::oracle
