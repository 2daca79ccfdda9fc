// An engine: what the harness checks. A world's edits go in; refusals and the outline come out. This library's engine
// is one (oracle/check/library_engine.h), a process that speaks the protocol another, a shared object a third.
#pragma once

#include "oracle/engine/capabilities.h"
#include "oracle/engine/delta.h"
#include "oracle/reference/brush_edit.h"
#include "oracle/reference/island.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace lgs::oracle {

/// An edit that an engine refused.
struct RefusedEdit {
  std::string name;
  std::string reason;
};

/// Why an engine gave no answer.
struct Failure {
  enum class Kind {
    crash,     ///< it ended
    hang,      ///< no answer in time
    protocol,  ///< an answer that is none
  };
  Kind kind{};
  std::string text;      ///< what it did: "crashed with SIGSEGV"
  std::string log = {};  ///< the last lines of its own log
};

class Engine {
 public:
  using Refusals = tl::expected<std::vector<RefusedEdit>, Failure>;

  Engine() = default;
  virtual ~Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  const std::string& name() const { return name_; }
  const Capabilities& can() const { return can_; }
  void assume(const Capabilities& can) { can_ = can; }  ///< whatever it says

  /// Forgets everything: a new, empty world. Heals an engine that has failed, where that is possible.
  virtual void reset(const PreservePairs& preserve) = 0;
  virtual void add(const std::string& name, const ScenePolygon& polygon) = 0;
  virtual void remove(const std::string& name) = 0;
  virtual void stroke(const BrushEdit& /*brush*/) {}  ///< if it takes regions

  /// Makes the edits since the last commit. Returns those that were refused, in their order; or why there is no answer.
  /// After a failure nothing but reset() and outline() may be called.
  virtual Refusals commit() = 0;

  /// The output of the last commit that was answered, sorted.
  virtual Outline outline() const = 0;

  /// The islands of that commit, sorted, if it can put them out.
  virtual NamedIslands islands() const { return {}; }

  /// What it told of that commit, if it tells what changed; outline() is the copy then.
  virtual const Delta* delta() const { return nullptr; }

  /// By its own clock, how long that commit took and the edits before it, if it says so.
  virtual std::optional<std::chrono::nanoseconds> time() const { return std::nullopt; }

  /// Begins anew: more than reset() does, which may forget to forget something.
  virtual void restart() {}

  /// In haste the engine gets less time for an answer, as a hang is looked for again and again: some more than it has
  /// needed so far; or a part of its time-out at most, and then one that is slow looks like one that hangs.
  enum class Haste : std::uint8_t { none, some, much };
  virtual void hurry(Haste /*haste*/) {}

  /// What an answer may take, if anybody looks at the clock.
  virtual std::chrono::duration<double> timeout() const { return std::chrono::duration<double>::max(); }

  /// Ends the engine. What goes wrong then, if anything does.
  virtual std::optional<Failure> finish() { return std::nullopt; }

 protected:
  /// Says what it is, before it is asked.
  void introduce(std::string name, const Capabilities& can) {
    name_ = std::move(name);
    can_ = can;
  }

 private:
  std::string name_;
  Capabilities can_;
};

}  // namespace lgs::oracle
