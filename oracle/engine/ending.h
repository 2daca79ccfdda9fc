// How a process has ended, in words.
#pragma once

#include <string>

namespace lgs::oracle {

inline constexpr const char* kEndedWell = "ended with status 0";

/// "crashed with SIGSEGV".
std::string endingOfSignal(int signal);

/// "ended with status 3". A shell's status of more than 128 tells the signal of what it has run.
std::string endingOfStatus(int status);

}  // namespace lgs::oracle
