// A subject is what is measured: it takes a world of tiles and computes its boundary.
//
// It does so in three steps, so that they can be timed apart. prepare() puts the polygons into the subject's own types
// (the article's "buildPolys"), build() computes the boundary from nothing ("initSegs"), and edges() reads it, so that
// it can be checked.
#pragma once

#include "bench/boundary.h"
#include "bench/tiles.h"
#include "bench/times.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::bench {

class Subject {
 public:
  Subject() = default;
  virtual ~Subject() = default;
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;

  virtual void prepare(const Tiles& tiles) = 0;  ///< called once; the tiles must outlive the subject

  /// Called after prepare(). A subject that recomputes may be called again. False if it refuses the input.
  virtual bool build() = 0;

  virtual Edges edges() const = 0;  ///< called only if build() was true

  /// By its own clock, what the last build or edit took: instead of what is measured from outside.
  virtual std::optional<Nanoseconds> ownTime() const { return std::nullopt; }
};

/// A subject that keeps its boundary up to date. Every edit ends with its commit. Cells are numbered as in Tiles.
class Incremental : public Subject {
 public:
  /// Looks up the handle of a cell's content. This is not timed, because a game has it in hand when it edits.
  virtual void find(std::size_t cell) = 0;
  virtual void remove(std::size_t cell) = 0;
  virtual void add(std::size_t cell, std::size_t kind) = 0;
};

struct SubjectInfo {
  std::string_view name;
  bool isIncremental;
  bool isOther = false;  ///< an engine of others, which may be slow: few edits are made
};

/// In the order of tables: the published port and the engine first, then those that recompute the world.
std::vector<SubjectInfo> subjects();

/// Adds an incremental one at the end, an engine of others. The name must outlive all subjects.
void addSubject(std::string_view name, std::function<std::unique_ptr<Subject>()> make);

/// A new subject, or the reason why there is none.
tl::expected<std::unique_ptr<Subject>, std::string> makeSubject(std::string_view name);

}  // namespace lgs::bench
