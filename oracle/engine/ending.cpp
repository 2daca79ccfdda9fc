#include "oracle/engine/ending.h"

#include <fmt/format.h>
#include <csignal>

namespace lgs::oracle {
namespace {

// Empty for a signal that no program ends by, as a rule.
std::string nameOf(int signal) {
  switch (signal) {
    case SIGABRT:
      return "SIGABRT";
    case SIGBUS:
      return "SIGBUS";
    case SIGFPE:
      return "SIGFPE";
    case SIGILL:
      return "SIGILL";
    case SIGKILL:
      return "SIGKILL";
    case SIGPIPE:
      return "SIGPIPE";
    case SIGSEGV:
      return "SIGSEGV";
    case SIGSYS:
      return "SIGSYS";
    case SIGTERM:
      return "SIGTERM";
    case SIGTRAP:
      return "SIGTRAP";
    default:
      return "";
  }
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
