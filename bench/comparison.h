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

  /// A world from nothing. Rows of `scenario`: computing the boundary; of "polygons-" + scenario: making the polygons.
  void build(const std::string& scenario, const Tiles& tiles, const std::vector<std::string_view>& names);

  /// One polygon removed, or added, and committed. Rows of "edit-" + size: anywhere in the world; of "dig-" + size:
  /// each some cells from the last one.
  void edit(const std::string& size, const Tiles& tiles, const std::vector<std::string_view>& names);

  /// What an edit costs those that recompute: the world again. Their rows of the build `from` once more, as `to`.
  void recomputeInstead(const std::string& from, const std::string& to);

  const std::vector<Row>& rows() const { return rows_; }
  const std::vector<std::string>& notes() const { return notes_; }  ///< what was left out, and why
  bool agree() const { return agree_; }                             ///< every subject with the first
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
