// The engine that `lgs check` and `lgs replay --check` are told to check: its options, and starting it.
#pragma once

#include "cli/command.h"
#include "oracle/engine/engine.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

namespace lgs::cli {

struct EngineArguments {
  std::string command;            ///< of a process; or empty
  std::string file;               ///< of a shared object; both empty: this library's engine
  std::optional<double> timeout;  ///< seconds
  std::optional<oracle::Capabilities> assumed;
  bool verbose = false;
  std::shared_ptr<oracle::Engine> loaded;  ///< from the file, by prepare()

  bool isGiven() const { return !command.empty() || !file.empty(); }
  double patience() const { return timeout.value_or(10); }
  void prepare();             ///< loads the file; throws a CLI::ParseError if that or what is said of the engine is bad
  std::string print() const;  ///< as options, with a blank before each; empty for this library's engine
};

/// Adds --engine, --engine-so and what belongs to them. `needed` is the option that they need, if there is one.
void addEngineOptions(CLI::App& command, EngineArguments& arguments, CLI::Option* needed = nullptr);

/// Starts the engine in a process of its own, where it may crash and hang; a shared object, too. Without a greeting there
/// is no engine to check: complains, and returns nothing.
std::unique_ptr<oracle::Engine> startEngine(const EngineArguments& arguments);

/// Says what the engine is, what is compared, and in which worlds.
void introduce(const oracle::Engine& engine, std::FILE* out);

/// Says what an engine did. That is a mismatch.
Status tell(const oracle::Failure& failure, std::FILE* out);

/// Lets the engine end. If that is wrong, says so, and a good status becomes a mismatch.
Status finishEngine(oracle::Engine& engine, Status status, std::FILE* out);

/// For the help of a command.
extern const char* const kEngineHelp;

}  // namespace lgs::cli
