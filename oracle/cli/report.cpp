#include "oracle/cli/report.h"

#include "oracle/check/shrink.h"
#include "oracle/draw/counted.h"
#include "oracle/draw/draw.h"

#include <fmt/format.h>
#include <cstdio>
#include <filesystem>

namespace lgs::oracle {
namespace {

using Kind = Mismatch::Kind;

// What is needed to find a mismatch of this kind again, and no more: shrinking asks many times.
CheckOptions only(Kind kind, CheckOptions options) {
  options.afterCommit = {};
  options.naive = options.naive && (kind == Kind::naive || kind == Kind::loops);
  options.cgal = options.cgal && (kind == Kind::cgal || kind == Kind::loops);
  return options;
}

std::optional<Mismatch> checkAgain(const Trace& trace, const CheckOptions& options) {
  CheckStats stats;
  auto result = checkTrace(trace, options, stats);
  return result ? std::move(*result) : std::nullopt;
}

Trace shrunk(const Mismatch& found, Trace trace, const CheckOptions& options, std::chrono::milliseconds budget) {
  trace.edits.resize(found.edits);
  const auto stillFails = [&](const Trace& candidate) {
    const auto again = checkAgain(candidate, options);
    return again && again->kind == found.kind;
  };
  if (!stillFails(trace)) return trace;
  return shrink(std::move(trace), stillFails, budget);
}

std::string withComment(const std::string& trace, const std::string& comment) {
  const std::size_t secondLine = trace.find('\n') + 1;
  return trace.substr(0, secondLine) + "# " + comment + "\n" + trace.substr(secondLine);
}

}  // namespace

std::string describe(const Mismatch& mismatch, const Trace& trace) {
  std::string where = fmt::format("after edit {}", mismatch.edits);
  if (mismatch.edits > 0 && trace.edits[mismatch.edits - 1].line != 0) {
    where += fmt::format(", line {}", trace.edits[mismatch.edits - 1].line);
  }
  return fmt::format("{} ({}): {}:\n{}", where, counted(mismatch.commit, "commit"), describe(mismatch.kind),
                     mismatch.text);
}

std::string draw(const Mismatch& mismatch) {
  MismatchOptions options;
  options.title = describe(mismatch.kind);
  options.edited = mismatch.edited;
  switch (mismatch.kind) {
    case Kind::naive:
      options.expectedName = "naive reference";
      break;
    case Kind::cgal:
      options.expectedName = "CGAL";
      break;
    case Kind::history:
      options.expectedName = "built at once";
      break;
    default:  // no outline is to blame
      return drawWorld(mismatch.scene, mismatch.actual, options);
  }
  options.actualName = "engine";
  return drawMismatch(mismatch.scene, mismatch.expected, mismatch.actual, options);
}

Status reportMismatch(const Mismatch& found, const Trace& trace, const CheckOptions& options,
                      const ReportOptions& report) {
  fmt::print("MISMATCH {}", describe(found, trace));
  if (report.shrinkFor.count() > 0) fmt::print("shrinking the trace of {} …\n", counted(found.edits, "line"));
  std::fflush(stdout);

  const CheckOptions narrow = only(found.kind, options);
  const Trace small = shrunk(found, trace, narrow, report.shrinkFor);
  const auto again = checkAgain(small, narrow);
  const Mismatch& shown = again ? *again : found;
  const std::string text = printTrace(small);
  constexpr std::size_t kPrinted = 40;
  if (small.edits.size() <= kPrinted) {
    fmt::print("\n{}\n{}", text, describe(shown, small));
  } else {
    fmt::print("\n{} edits are left, too many to print here\n{}", small.edits.size(), describe(shown, small));
  }

  std::error_code ignored;  // writing will say what is wrong
  std::filesystem::create_directories(report.folder, ignored);
  const std::string base = (std::filesystem::path(report.folder) / report.name).string();
  const Status written =
      worst(write(base + ".trace", withComment(text, report.reproduce)), write(base + ".svg", draw(shown)));
  if (written == Status::fine) fmt::print("\ntrace      {0}.trace\npicture    {0}.svg\n", base);
  fmt::print("again      {}\n", report.reproduce);
  CheckOptions strict = narrow;
  strict.skipRefused = false;
  strict.wholeEvery = 1;
  if (written == Status::fine && checkAgain(small, strict)) {
    fmt::print("the trace  lgs replay {0}.trace --check --svg {0}.svg\n", base);
  }
  return Status::mismatch;
}

}  // namespace lgs::oracle
