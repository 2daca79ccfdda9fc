// Compares subjects side by side: in one process, one after the other, round by round, so that a slow moment of the
// machine hits all alike. A time counts only if the subject's boundary has the same area and the same corners as the
// engine's.
#pragma once

#include "bench/subjects/subject.h"
#include "bench/times.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace lgs::bench {

struct Row {
  std::string scenario;
  std::string subject;
  Times times;
  std::size_t cells = 0;
  std::size_t segments = 0;  ///< of this subject's boundary; some subjects merge collinear ones
};

struct ComparisonOptions {
  int rounds = 5;
  bool slow = false;  ///< run also what takes many seconds
  std::function<void(const std::string&)> progress = [](const std::string&) {};
};

class Comparison {
 public:
  explicit Comparison(ComparisonOptions options) : options_(std::move(options)) {}

  /// Times a world from nothing. Adds rows of `scenario` for computing the boundary, and of "polygons-" + scenario for
  /// making the polygons.
  void build(const std::string& scenario, const Tiles& tiles, const std::vector<std::string_view>& names);

  /// Times removing or adding one polygon, with its commit. Adds rows of "edit-" + size for edits anywhere in the
  /// world, and of "dig-" + size for edits some cells from the last one.
  void edit(const std::string& size, const Tiles& tiles, const std::vector<std::string_view>& names);

  /// An edit costs a subject that recomputes as much as the whole world. So this repeats its rows of the build `from`
  /// as rows of `to`.
  void recomputeInstead(const std::string& from, const std::string& to);

  const std::vector<Row>& rows() const { return rows_; }
  const std::vector<std::string>& notes() const { return notes_; }  ///< what was left out, and why
  bool agree() const { return agree_; }                             ///< whether all subjects agree with the engine
  std::uint64_t checksum() const { return checksum_; }              ///< of the boundaries of all scenarios

 private:
  struct Entry;
  std::vector<Entry> start(const std::string& scenario, const Tiles& tiles, const std::vector<std::string_view>& names);
  Boundary expected(const std::string& scenario, const Tiles& tiles);
  void check(Entry& entry, const Boundary& expected);
  void take(std::vector<Entry> entries);
  void note(const std::string& scenario, std::string_view subject, const std::string& text);

  ComparisonOptions options_;
  std::vector<Row> rows_;
  std::vector<std::string> notes_;
  bool agree_ = true;
  std::uint64_t checksum_ = 0;
};

}  // namespace lgs::bench
