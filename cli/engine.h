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
  std::string command;  ///< of a process; empty: this library's engine
  double timeout = 10;  ///< seconds
  std::optional<oracle::Capabilities> assumed;
  bool verbose = false;

  bool isGiven() const { return !command.empty(); }
  std::string print() const;  ///< as options, with a blank before each; empty for this library's engine
};

/// Adds --engine and what belongs to it.
CLI::Option* addEngineOptions(CLI::App& command, EngineArguments& arguments);

/// Starts the engine. Says what it is, what is compared, and in which worlds. If it does not start, says why: then there
/// is none.
std::unique_ptr<oracle::Engine> startEngine(const EngineArguments& arguments, std::FILE* out);

/// Lets the engine end. If that is wrong, says so, and a good status becomes a mismatch.
Status finishEngine(oracle::Engine& engine, Status status, std::FILE* out);

/// For the help of a command.
extern const char* const kEngineHelp;

}  // namespace lgs::cli
