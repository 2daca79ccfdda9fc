#include "oracle/page/story.h"

#include "oracle/draw/colours.h"
#include "oracle/page/excerpt.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/reference/vector.h"
#include "oracle/reference/words.h"
#include "oracle/trace/call_text.h"
#include "oracle/trace/model.h"
#include "oracle/trace/plain_edits.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

namespace lgs::oracle::paging {
namespace {

using Part = Excerpt::Part;

bool isInside(const CellRect& cells, Cell cell, std::int32_t beyond) {
  return contains({{cells.min.i - beyond, cells.min.j - beyond}, {cells.max.i + beyond, cells.max.j + beyond}}, cell);
}

// Whether a segment is an edge of a polygon, or a piece of one.
bool isOf(const OutlineSegment& s, const ScenePolygon& polygon) {
  const Point low = toWorld(polygon.cell, {0, 0});
  const Point high = toWorld(polygon.cell, {kUnitsPerCell, kUnitsPerCell});
  if (s.end.x < low.x || s.end.x > high.x || s.end.y < low.y || s.end.y > high.y) return false;
  for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
    const Point a = toWorld(polygon.cell, polygon.vertices[k]);
    const Point b = toWorld(polygon.cell, polygon.vertices[(k + 1) % polygon.vertices.size()]);
    if (isOnSegment(s.start, a, b) && isOnSegment(s.end, a, b) && dot(b - a, s.end - s.start) > 0) return true;
  }
  return false;
}

const char* nameOf(Difference::Kind kind) {
  constexpr std::array kNames{"missing", "extra", "ghost1", "ghost2", "block", "owner"};
  return kNames[static_cast<std::size_t>(kind)];
}

class Story {
 public:
  Story(const Trace& trace, const PageOptions& options)
      : trace_(trace), options_(options), excerpt_(excerptOf(trace, options.end)), edits_(editsBy(trace)) {}

  Json tell() && {
    steps_.push_back({{"edit", ""}, {"number", 0}});
    bool isBegun = false;
    for (std::size_t k = 0; k < excerpt_.parts.size(); ++k) {
      if (excerpt_.parts[k] == Part::step && !isBegun) begin();
      isBegun = isBegun || excerpt_.parts[k] == Part::step;
      play(k);
    }
    if (!isBegun) begin();
    end();
    Json data{{"title", options_.title},
              {"report", options_.report},
              {"note", note()},
              {"expectedName", options_.expectedName},
              {"actualName", options_.actualName},
              {"unitsPerCell", kUnitsPerCell},
              {"preserve", trace_.preserve.pairs()},
              {"fills", drawing::fillsOf({tables_.polygons(), {}})}};
    std::move(tables_).writeTo(data);
    data["steps"] = std::move(steps_);
    return data;
  }

 private:
  // The world in which the page begins: an empty one, but in an excerpt.
  void begin() {
    Json added = Json::array();
    for (const auto& [name, number] : placed_) added.push_back(number);
    steps_[0]["added"] = std::move(added);
    putOutlines(steps_[0], wholeOutline(), nullptr);
  }

  void play(std::size_t k) {
    const Call& edit = trace_.calls[k];
    const bool isShown = excerpt_.parts[k] == Part::step;
    if (isShown) steps_.push_back({{"edit", printCall(edit)}, {"number", k + 1}});
    Json& step = steps_.back();
    if (edit.kind == Call::Kind::commit) {
      if (isShown) commit(step, k + 1 == excerpt_.parts.size());
    } else if (edits_[k].empty() && isPlain(edit)) {
      if (isShown) step["note"] = "This edit must be refused, and change nothing.";
    } else {
      pending_ = pending_ || isShown;
      for (const Call& part : edits_[k]) make(part, isShown, step);
    }
  }

  void make(const Call& edit, bool isShown, Json& step) {
    model_.play(edit);
    const auto number = edit.kind == Call::Kind::add ? add(edit) : remove(edit.name());
    if (isShown && number) step[edit.kind == Call::Kind::add ? "added" : "removed"].push_back(*number);
  }

  std::optional<std::size_t> add(const Call& edit) {
    // Polygons just outside have a say in the outline of the cells at the rim.
    if (excerpt_.cells && !isInside(*excerpt_.cells, edit.polygon().cell, 1)) return std::nullopt;
    const std::size_t number = tables_.addPolygon(edit);
    placed_[edit.name()] = number;
    inCell_[edit.polygon().cell].push_back(number);
    return number;
  }

  std::optional<std::size_t> remove(const std::string& name) {
    const auto found = placed_.find(name);
    if (found == placed_.end()) return std::nullopt;
    const std::size_t number = found->second;
    std::erase(inCell_[tables_.polygon(number).cell], number);
    placed_.erase(found);
    return number;
  }

  void commit(Json& step, bool isLast) {
    pending_ = false;
    putOutlines(step, wholeOutline(), isLast && options_.end ? &*options_.end : nullptr);
  }

  // The end of the trace commits what is pending. And it is there, at the latest, that a mismatch shows.
  void end() {
    const bool isDue = !options_.end || options_.end->committed;
    const bool showsEnd = steps_.back().value("wrong", false);
    if (isDue && (pending_ || (options_.end && !showsEnd))) {
      const char* const note = pending_ ? "The end of the trace commits what is pending." : "The end of the trace.";
      steps_.push_back({{"edit", pending_ ? "commit" : ""}, {"number", 0}, {"note", note}});
      commit(steps_.back(), true);
    } else if (!isDue) {
      putEnd(steps_.back(), *options_.end);
    }
  }

  Outline wholeOutline() {
    Scene scene{{}, trace_.preserve};
    for (const auto& [name, number] : placed_) scene.polygons.push_back(tables_.polygon(number));
    const Outline& whole = naive_(scene).outline;
    return options_.asCompared ? options_.asCompared(whole) : whole;
  }

  void putOutlines(Json& step, Outline expected, const PageEnd* end) {
    if (end == nullptr) {
      step["expected"] = numbersOf(expected);
      return;
    }
    Outline actual = end->actual;
    if (end->polygons < model_.standing().polygons()) {  // a part was compared; the rest is as it must be
      std::erase_if(expected, [&](const OutlineSegment& s) {
        return std::ranges::any_of(end->expected, [&](auto& e) { return e.start == s.start && e.end == s.end; });
      });
      actual.insert(actual.end(), expected.begin(), expected.end());
      expected.insert(expected.end(), end->expected.begin(), end->expected.end());
    } else {
      expected = end->expected;
    }
    step["expected"] = numbersOf(expected);
    step["actual"] = numbersOf(actual);
    putEnd(step, *end);
  }

  void putEnd(Json& step, const PageEnd& end) {
    constexpr std::size_t kMost = 200;
    const auto differences = compare(end.expected, end.actual);
    const auto number = [&](const auto& s) { return s ? Json(numberOf(*s)) : Json(nullptr); };
    Json listed = Json::array();
    for (std::size_t k = 0; k < std::min(kMost, differences.size()); ++k) {
      const Difference& d = differences[k];
      listed.push_back({{"kind", nameOf(d.kind)},
                        {"text", describe(d)},
                        {"expected", number(d.expected)},
                        {"actual", number(d.actual)}});
    }
    step["wrong"] = true;
    step["differences"] = std::move(listed);
    step["more"] = differences.size() - std::min(kMost, differences.size());
    Json marked = Json::array();
    for (const OutlineSegment& s : end.marked) marked.push_back(numberOf(s));
    step["marked"] = std::move(marked);
  }

  // Sorted, because the keyboard goes through them in this order. What is outside of the excerpt is left out.
  Json numbersOf(Outline outline) {
    std::sort(outline.begin(), outline.end());
    Json numbers = Json::array();
    for (const OutlineSegment& s : outline) {
      const auto owner = ownerOf(s);
      const Cell cell = owner ? tables_.polygon(*owner).cell : cellAt(s.start);
      if (!excerpt_.cells || contains(*excerpt_.cells, cell)) numbers.push_back(tables_.segment(s, owner));
    }
    return numbers;
  }

  std::size_t numberOf(const OutlineSegment& s) { return tables_.segment(s, ownerOf(s)); }

  std::optional<std::size_t> ownerOf(const OutlineSegment& s) const {
    const Cell right = cellAt(s.start);
    const Cell left = cellAt({s.start.x - 1, s.start.y - 1});
    for (std::int32_t i = left.i; i <= right.i; ++i) {
      for (std::int32_t j = left.j; j <= right.j; ++j) {
        const auto found = inCell_.find({i, j});
        if (found == inCell_.end()) continue;
        for (const std::size_t number : found->second)
          if (isOf(s, tables_.polygon(number))) return number;
      }
    }
    return std::nullopt;
  }

  std::string note() const {
    if (!excerpt_.cells) return "";
    const auto& [low, high] = *excerpt_.cells;
    const auto early = static_cast<std::size_t>(std::ranges::count(excerpt_.parts, Part::early));
    std::string text = fmt::format("The trace is too long to show all of it ({}): here are cells ({}, {}) to ({}, {}).",
                                   counted(excerpt_.parts.size(), "line"), low.i, low.j, high.i, high.j);
    if (early > 0) text += fmt::format(" The page begins after the first {} there.", counted(early, "line"));
    return text;
  }

  const Trace& trace_;
  const PageOptions& options_;
  const Excerpt excerpt_;
  const std::vector<std::vector<Call>> edits_;
  Model model_;
  NaiveReference naive_;
  Tables tables_;
  Json steps_ = Json::array();
  std::map<std::string, std::size_t> placed_;  // names to numbers of polygons
  std::map<Cell, std::vector<std::size_t>> inCell_;
  bool pending_ = false;
};

}  // namespace

Json storyOf(const Trace& trace, const PageOptions& options) { return Story(trace, options).tell(); }

}  // namespace lgs::oracle::paging
