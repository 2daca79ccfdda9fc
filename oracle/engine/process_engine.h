// An engine that is a process and speaks the protocol: edits as the lines of the trace format, answers as those of the
// dump format, over its standard input and output.
#pragma once

#include "oracle/engine/child.h"
#include "oracle/engine/engine.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace lgs::oracle {

/// A command for /bin/sh.
Guard::Program shell(std::string command);

struct ProcessOptions {
  Guard::Program program;  ///< shell(), or serving() of serve.h
  std::chrono::duration<double> timeout{10};
  bool verbose = false;  ///< show its comments and its log
};

class ProcessEngine : public Engine {
 public:
  /// Starts the process and asks what it can.
  static tl::expected<std::unique_ptr<ProcessEngine>, Failure> start(const ProcessOptions& options);

  void reset(const PreservePairs& preserve) override;
  void add(const std::string& name, const ScenePolygon& polygon) override;
  void remove(const std::string& name) override;
  void stroke(const BrushEdit& brush) override;
  Refusals commit() override;
  Outline outline() const override { return can().delta ? delta_.outline() : outline_; }
  NamedIslands islands() const override { return islands_; }
  const Delta* delta() const override { return can().delta ? &delta_ : nullptr; }
  std::optional<std::chrono::nanoseconds> time() const override { return time_; }
  void restart() override { child_.reset(); }
  void hurry(Haste haste) override { haste_ = haste; }
  std::chrono::duration<double> timeout() const override { return options_.timeout; }
  std::optional<Failure> finish() override;

 private:
  using Clock = Child::Clock;

  explicit ProcessEngine(const ProcessOptions& options) : options_(options) {}
  std::optional<Failure> begin();
  std::optional<Failure> ask(std::string_view text, const Child::Take& take, Clock::duration patience);
  Clock::duration patience() const;

  ProcessOptions options_;
  std::optional<Child> child_;
  std::optional<Failure> failure_;  // to start
  std::string unsent_;
  Outline outline_;
  NamedIslands islands_;
  Delta delta_;
  std::optional<std::chrono::nanoseconds> time_;
  Haste haste_ = Haste::none;
  Clock::duration slowest_{};  // answer to a commit
};

}  // namespace lgs::oracle
