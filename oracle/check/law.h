// A law as a body: what it looks at around a call, after a commit, now and then, and at the end of a trace. A law is a
// file in laws/ and a line in laws/list.h. With that it is held wherever traces are checked: by `lgs check` and
// `lgs replay --check`, the laws of RapidCheck, the fuzz targets, the regressions and the bulk runs.
#pragma once

#include "oracle/check/checker.h"
#include "oracle/check/library_engine.h"
#include "oracle/check/window.h"
#include "oracle/engine/engine.h"
#include "oracle/reference/naive.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace lgs::oracle {

using Found = std::optional<Mismatch>;

/// What laws see: the engine, and what must stand in it.
class Seen {
 public:
  Seen(const Trace& checked, const CheckOptions& by, CheckStats& counts);
  Seen(const Seen&) = delete;
  Seen& operator=(const Seen&) = delete;

  const Trace& trace;
  const CheckOptions& options;
  CheckStats& stats;
  LibraryEngine own;
  LibraryEngine* const library;  ///< null, if another engine is checked
  Engine& engine;
  Model placed;                         ///< in another engine
  std::set<std::string> added;          ///< to another engine since the last commit, and still there
  std::vector<BrushEdit> strokes = {};  ///< that another engine has made
  CellSet edited;                       ///< since the last commit, by calls that are edits
  bool isAnywhere = false;              ///< other cells may have changed since, too
  std::size_t edits = 0;                ///< calls of the trace that were played
  std::size_t commits = 0;
  bool isWhole = false;  ///< after this commit the whole world is compared
  bool wasAway = false;  ///< some chunks are not in memory, or were not
  NaiveReference naive;

  const Model& model() const { return library != nullptr ? library->model() : placed; }
  Scene scene() const;  ///< of regions, what this library's brushes make of them: for a picture
  World& world() { return library->player().world(); }
  /// The outline of all there is, by the naive reference; and the engine's. Each is worked out once for each state.
  const Outline& whole() {
    if (!whole_) whole_ = naive(scene()).outline;
    return *whole_;
  }
  const Outline& shown() {
    if (!shown_) shown_ = engine.outline();
    return *shown_;
  }
  void willChange() {
    whole_.reset();
    shown_.reset();
  }
  bool isPending() const { return library != nullptr && library->player().pending(); }

  Mismatch mismatch(Mismatch::Kind kind, std::string text, Outline marked = {}) const;

  /// What an engine of lists of changes has told of the last commit, as lines; empty of others.
  std::string told() const;

  /// Of an engine that gave no answer: its outline is an old one. The picture shows what it should have answered.
  Mismatch noAnswer(const Failure& failure);

  /// What differs, in what the engine can do, or what may be asked of it here.
  Found differing(Mismatch::Kind kind, const Scene& scene, const Outline& expected, const Outline& actual,
                  const Capabilities& can) const;
  Found differing(Mismatch::Kind kind, const Scene& scene, const Outline& expected, const Outline& actual) const {
    return differing(kind, scene, expected, actual, engine.can());
  }

 private:
  std::optional<Outline> whole_, shown_;
};

class Law {
 public:
  Law() = default;
  virtual ~Law() = default;
  Law(const Law&) = delete;
  Law& operator=(const Law&) = delete;

  int number = -1;  ///< its place in the list

  /// The engine has a new, empty world.
  virtual void begin(Seen&) {}
  /// A call that is no commit, of this library's engine: before it, with what must come of it; and after it.
  virtual void before(Seen&, const Judged&) {}
  virtual Found after(Seen&, const Judged&, bool /*isRefused*/) { return std::nullopt; }
  /// After a roll-back or redo: Seen::library->changes() says what that did to the segments.
  virtual Found afterTravel(Seen&) { return std::nullopt; }
  virtual Found afterCommit(Seen&) { return std::nullopt; }
  /// After some commits, and at the end: what takes long.
  virtual Found nowAndThen(Seen&) { return std::nullopt; }
  virtual Found atEnd(Seen&) { return std::nullopt; }
};

using Laws = std::vector<std::unique_ptr<Law>>;

/// Those that can be held of an engine, in the order in which they are looked at.
Laws lawsOf(const Seen& seen);

}  // namespace lgs::oracle
