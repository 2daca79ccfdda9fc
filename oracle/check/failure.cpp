#include "oracle/check/failure.h"

#include "oracle/check/comparable.h"
#include "oracle/draw/draw.h"
#include "oracle/page/page.h"
#include "oracle/reference/naive.h"
#include "oracle/reference/words.h"
#include "oracle/trace/plain_edits.h"

#include <fmt/format.h>
#include <utility>

namespace lgs::oracle {
namespace {

// Who says what is expected; nothing where no outline differs.
const char* nameOfExpected(const Mismatch& mismatch) {
  switch (mismatch.kind) {
    case Mismatch::Kind::rounding:
      return mismatch.expected == mismatch.actual ? nullptr : "CGAL, rounded";
    case Mismatch::Kind::naive:
      return "naive reference";
    case Mismatch::Kind::cgal:
      return "CGAL";
    case Mismatch::Kind::history:
      return "built at once";
    default:
      return nullptr;
  }
}

std::pair<Point, Point> endsOf(const OutlineSegment& s) { return {s.start, s.end}; }

// An outline without most of what the other one has not. Counts what is left out.
Outline withFew(const Outline& outline, const Outline& other, std::size_t& leftOut) {
  constexpr std::size_t kMost = 2'000;
  Outline few;
  std::size_t different = 0;
  auto at = other.begin();
  for (const OutlineSegment& s : outline) {
    while (at != other.end() && endsOf(*at) < endsOf(s)) ++at;
    const bool isInBoth = at != other.end() && endsOf(*at) == endsOf(s);
    if (isInBoth) ++at;
    if (isInBoth || ++different <= kMost) few.push_back(s);
  }
  leftOut += outline.size() - few.size();
  return few;
}

// An engine may put out anything, hundreds of thousands of segments. Some thousand differences show as much as all.
struct Shown {
  explicit Shown(const Mismatch& mismatch) : title(describe(mismatch.kind)) {
    std::size_t leftOut = 0;
    expected = withFew(mismatch.expected, mismatch.actual, leftOut);
    actual = withFew(mismatch.actual, mismatch.expected, leftOut);
    if (leftOut > 0) title += fmt::format(" ({} more that differ are left out)", counted(leftOut, "segment"));
  }
  std::string title;
  Outline expected, actual;
};

}  // namespace

std::string describe(const Mismatch& mismatch, const Trace& trace) {
  std::string where = fmt::format("after edit {}", mismatch.edits);
  if (mismatch.edits > 0 && trace.calls[mismatch.edits - 1].line != 0) {
    where += fmt::format(", line {}", trace.calls[mismatch.edits - 1].line);
  }
  return fmt::format("{} ({}): {}:\n{}", where, counted(mismatch.commit, "commit"), describe(mismatch.kind),
                     mismatch.text);
}

std::string inWords(const Failure& failure, std::string_view when) {
  return fmt::format("the engine {}{}\n", failure.text, when) +
         (failure.log.empty() ? "" : fmt::format("its log ends:\n{}\n", failure.log));
}

std::string inWords(const CheckStats& stats) {
  return fmt::format("checked {}, {} with CGAL, {} with the naive reference: no mismatch\n",
                     counted(stats.commits, "commit"), counted(stats.cgal, "time"), stats.naive);
}

std::string inWords(const Trace& trace, const World& world, const Outline& outline) {
  const Stats stats = world.stats();
  return fmt::format("{}: {} in {}, {}, {}\n", counted(editCount(trace), "edit"), counted(stats.polygons, "polygon"),
                     counted(stats.cells, "cell"), counted(outline.size(), "segment"),
                     counted(world.loops().size(), "loop"));
}

std::string draw(const Mismatch& mismatch) {
  MismatchOptions options;
  const Shown shown(mismatch);
  options.title = shown.title;
  options.edited = mismatch.edited;
  const char* const expectedName = nameOfExpected(mismatch);
  if (expectedName == nullptr) {  // perhaps some segments are to blame
    options.marked = mismatch.marked;
    return drawWorld(mismatch.scene, shown.actual, options);
  }
  options.expectedName = expectedName;
  options.actualName = "engine";
  return drawMismatch(mismatch.scene, shown.expected, shown.actual, options);
}

std::string page(const Mismatch& mismatch, const Trace& trace) {
  const char* const expectedName = nameOfExpected(mismatch);
  const Shown shown(mismatch);
  PageOptions options{shown.title, describe(mismatch, trace), "engine", "", {}};
  if (expectedName != nullptr) {
    options.expectedName = expectedName;
    options.actualName = "engine";
  }
  const bool committed = mismatch.kind != Mismatch::Kind::verdict && mismatch.kind != Mismatch::Kind::refusal;
  options.end =
      PageEnd{mismatch.edits, committed, mismatch.scene.polygons.size(), shown.expected, shown.actual, mismatch.marked};
  if (!mismatch.can.putsOutAll())
    options.asCompared = [can = mismatch.can](Outline outline) { return comparable(std::move(outline), can); };
  return writePage(trace, options);
}

std::string page(const Trace& trace, const std::string& title) {
  return writePage(trace, {title, "", "naive reference", "engine", {}});
}

std::string pageWithoutEngine(const Trace& trace, const std::string& title) {
  return writePage(trace, {title, "", "naive reference", "", {}});
}

std::string drawWithoutEngine(const Trace& trace, const std::string& title) {
  const Scene scene = sceneOf(trace);
  DrawOptions options;
  options.title = title;
  return drawWorld(scene, naiveOutline(scene), options);
}

std::string printTrace(const Trace& trace, std::string_view comment) {
  const std::string text = printTrace(trace);
  const std::size_t secondLine = text.find('\n') + 1;
  std::string lines;
  for (std::size_t begin = 0; begin < comment.size();) {
    const std::size_t end = std::min(comment.find('\n', begin), comment.size());
    lines += fmt::format("# {}\n", comment.substr(begin, end - begin));
    begin = end + 1;
  }
  return text.substr(0, secondLine) + lines + text.substr(secondLine);
}

std::string linkTo(const std::string& site, const Trace& trace) {
  constexpr std::size_t kLongest = 4'000;
  const std::string text = printTrace(trace);
  if (site.empty() || trace.calls.empty() || text.size() > kLongest) return "";
  std::string link = site + "#plain=";
  for (const char c : text) {
    const bool isPlain =
        ('0' <= c && c <= '9') || ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '-' || c == '.';
    link += isPlain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return link;
}

std::optional<Mismatch> findMismatch(const Trace& trace, const CheckOptions& options) {
  CheckStats stats;
  auto result = checkTrace(trace, options, stats);
  return result ? std::move(*result) : std::nullopt;
}

}  // namespace lgs::oracle
