// What a person gets to see of a finding: as everywhere, what differs, a shrunk trace and its picture, both saved.
#pragma once

#include "fuzz/target.h"

#include <chrono>

namespace lgs::fuzz {

struct Where {
  std::string folder = ".";  ///< trace, picture and input go here
  std::chrono::milliseconds shrinkFor{};
  std::string again;  ///< the command that runs an input again; its path follows
};

/// Prints the finding, shrinks its edits as long as the target finds the same kind of mismatch, saves them, a
/// picture, and the input.
void report(const Target& target, Bytes input, const Finding& finding, const Where& where);

/// The same for an input that ends the process: a failed assertion, a sanitizer's complaint, a crash. Every candidate
/// runs in a process of its own.
void reportCrash(const Target& target, Bytes input, const Where& where);

/// Whether an input, or edits, end the process.
bool crashes(const Target& target, Bytes input);

}  // namespace lgs::fuzz
