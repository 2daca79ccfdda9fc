// The engine that `lgs check` and `lgs replay --check` are told to check: its options, and starting it.
#pragma once

#include "cli/command.h"
#include "oracle/engine/engine.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

namespace lgs::cli {

struct EngineArguments {
  std::string command;            ///< of a process; or empty
  std::string file;               ///< of a shared object; both empty: this library's engine
  std::optional<double> timeout;  ///< seconds
  std::optional<oracle::Capabilities> assumed;
  bool verbose = false;

  bool isGiven() const { return isProcess() || !file.empty(); }
  bool isProcess() const { return !command.empty(); }
  double patience() const { return timeout.value_or(10); }
  void checkUse() const;      ///< throws CLI::RequiredError if something is said of an engine, and no engine is given
  std::string print() const;  ///< as options, with a blank before each; empty for this library's engine
};

/// Adds --engine, --engine-so and what belongs to them. `needed` is the option that they need, if there is one.
void addEngineOptions(CLI::App& command, EngineArguments& arguments, CLI::Option* needed = nullptr);

/// Starts the engine. Says what it is, what is compared, and in which worlds. If it does not start, says why: then there
/// is none.
std::unique_ptr<oracle::Engine> startEngine(const EngineArguments& arguments, std::FILE* out);

/// Lets the engine end. If that is wrong, says so, and a good status becomes a mismatch.
Status finishEngine(oracle::Engine& engine, Status status, std::FILE* out);

/// For the help of a command.
extern const char* const kEngineHelp;

}  // namespace lgs::cli
