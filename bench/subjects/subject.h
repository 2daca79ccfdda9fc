// What is measured, all in one form: something that takes a world of tiles and comes to its boundary.
//
// Its three steps are timed apart: prepare() puts the polygons into the subject's own types (the article's "buildPolys"),
// build() computes the boundary from nothing ("initSegs"), and edges() reads it, to be checked.
#pragma once

#include "bench/boundary.h"
#include "bench/tiles.h"

#include <cstddef>
#include <cstdint>
#include <memory>
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

  virtual void prepare(const Tiles& tiles) = 0;  ///< to be called once; the tiles must outlive the subject

  /// False where the subject refuses the input. After prepare(); one that only recomputes may be called again.
  virtual bool build() = 0;

  virtual Edges edges() const = 0;  ///< of a subject that did not refuse
};

/// One that keeps its boundary up to date. Every edit ends with its commit. Cells are numbered as in Tiles.
class Incremental : public Subject {
 public:
  /// Finds what is needed to name a cell's content: not timed, since a game has it in hand when it edits.
  virtual void find(std::size_t cell) = 0;
  virtual void remove(std::size_t cell) = 0;
  virtual void add(std::size_t cell, std::size_t kind) = 0;
  virtual void replace(std::size_t cell, std::size_t kind) = 0;
};

struct SubjectInfo {
  std::string_view name;
  bool isIncremental;
};

/// In the order of tables: the published port and the engine first, then those that recompute the world.
const std::vector<SubjectInfo>& subjects();

/// A fresh one; or why there is none here.
tl::expected<std::unique_ptr<Subject>, std::string> makeSubject(std::string_view name);

/// The same for one that isIncremental.
tl::expected<std::unique_ptr<Incremental>, std::string> makeIncremental(std::string_view name);

}  // namespace lgs::bench
