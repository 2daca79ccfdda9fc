#include "oracle/check/report.h"

#include "oracle/check/isolated.h"
#include "oracle/check/shell.h"
#include "oracle/check/shrink.h"
#include "oracle/generate/generator.h"
#include "oracle/reference/words.h"
#include "oracle/trace/file.h"
#include "oracle/trace/plain_edits.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace lgs::oracle {
namespace {

using FaultKind = Mismatch::Kind;

// What is needed to find a mismatch of this kind again, and no more: it is asked many times.
CheckOptions only(FaultKind kind, CheckOptions options) {
  options.afterCommit = {};
  options.advise = {};
  options.naive = options.naive && (kind == FaultKind::naive || kind == FaultKind::loops);
  if (kind == FaultKind::reading) options.questions = 40;
  options.cgal = options.cgal && (kind == FaultKind::cgal || kind == FaultKind::loops || kind == FaultKind::rounding);
  return options;
}

Trace shrunk(const Mismatch& found, Trace trace, const FindAgain& findAgain, std::chrono::milliseconds budget) {
  trace.calls.resize(found.edits);
  const auto stillFails = [&](const Trace& candidate) {
    stillAlive();
    return findAgain(candidate).has_value();
  };
  if (!stillFails(trace)) return trace;
  return shrink(std::move(trace), stillFails, budget);
}

// Writes trace, picture and page, and says where they are and how to come by them again.
void save(const Trace& trace, const Views& views, const ReportOptions& report, bool replays) {
  std::error_code ignored;  // writing will say what is wrong
  std::filesystem::create_directories(report.folder, ignored);
  const std::string text = printTrace(trace, report.reproduce);
  const std::string base = freePlace((std::filesystem::path(report.folder) / report.name).string(), text);
  const bool traceWritten = writeOrComplain(base + ".trace", text);
  const bool pageWritten = writeOrComplain(base + ".html", views.page);
  const bool written = writeOrComplain(base + ".svg", views.picture) && pageWritten && traceWritten;
  if (written) fmt::print("\ntrace      {0}.trace\npicture    {0}.svg\npage       {0}.html\n", base);
  if (const std::string link = linkTo(report.site, trace); !link.empty()) fmt::print("link       {}\n", link);
  fmt::print("again      {}\n", report.reproduce);
  if (written && replays) {
    const std::string cd = report.engine.empty() ? "" : fmt::format("cd {} && ", thisFolder());
    fmt::print("look at it {}{} replay {} --check{}{} --svg {}\n", cd, report.lgs, shellPath(base + ".trace"),
               report.engine, report.views ? " --views" : "", shellPath(base + ".svg"));
  }
}

void print(const Trace& trace, const std::string& what) {
  constexpr std::size_t kPrinted = 40;
  if (trace.calls.size() <= kPrinted) {
    fmt::print("\n{}\n{}", printTrace(trace), what);
  } else {
    fmt::print("\n{} edits are left, too many to print here\n{}", trace.calls.size(), what);
  }
}

}  // namespace

Trace shrinkWithEngine(const Mismatch& found, const Trace& trace, Engine& engine, const FindAgain& findAgain,
                       std::chrono::milliseconds budget) {
  const auto findAfresh = [&](const Trace& candidate) {
    engine.restart();
    return findAgain(candidate);
  };
  const bool isHang = found.kind == FaultKind::hang;
  constexpr double kTimeouts = 3;  // a hang costs a few of them; whoever has more patience waits that much longer
  if (isHang && kTimeouts * engine.timeout() < budget)
    budget = std::chrono::duration_cast<std::chrono::milliseconds>(kTimeouts * engine.timeout());
  engine.hurry(isHang ? Engine::Haste::much : Engine::Haste::none);
  Trace small = shrunk(found, trace, findAgain, budget);
  engine.hurry(Engine::Haste::none);
  if (findAfresh(small)) return small;
  if (!isHang) return shrunk(found, trace, findAfresh, budget);
  const auto hangs = [&](const Trace& candidate) { return stillAlive(), findAfresh(candidate).has_value(); };
  Trace few = builtAtOnce(untilFound(trace, found));  // it is slow: of much that stands, little else can go
  return hangs(few) ? shrink(std::move(few), hangs, budget) : untilFound(trace, found);
}

FindAgain sameKind(FaultKind kind, const CheckOptions& options) {
  return [kind, narrow = only(kind, options)](const Trace& candidate) -> std::optional<Mismatch> {
    if (narrow.engine != nullptr && !whyNot(candidate, narrow.engine->can()).empty()) return std::nullopt;
    auto again = findMismatch(candidate, narrow);
    return again && again->kind == kind ? std::move(again) : std::nullopt;
  };
}

std::string freePlace(const std::string& first, const std::string& text) {
  constexpr int kMost = 1'000;
  std::string base = first;
  for (int k = 2; k < kMost; ++k) {
    const auto there = readFile(base + ".trace");
    if (!there || *there == text) break;
    base = fmt::format("{}.{}", first, k);
  }
  return base;
}

bool writeOrComplain(const std::string& path, std::string_view content) {
  const auto done = writeFile(path, content);
  if (!done) fmt::print(stderr, "{}\n", message(done.error(), path));
  return done.has_value();
}

Trace untilFound(Trace trace, const Mismatch& found) {
  trace.calls.resize(std::min(trace.calls.size(), found.edits));
  return trace;
}

namespace {

using Shrink = std::function<Trace(const Trace&)>;

void report(const Mismatch& found, const Trace& trace, const Shrink& makeSmall, const FindAgain& findAgain,
            const Engine* engine, const ReportOptions& report) {
  fmt::print("MISMATCH {}", describe(found, trace));
  if (report.shrinkFor.count() > 0) fmt::print("shrinking the trace of {} …\n", counted(found.edits, "line"));
  std::fflush(stdout);

  Trace small = makeSmall(trace);
  const auto again = findAgain(small);
  if (!again) small = untilFound(trace, found);
  const Mismatch& shown = again ? *again : found;
  print(small, describe(shown, small));
  if (!again && engine != nullptr) {
    fmt::print("but not again: the engine does not always do the same, or keeps something when it is reset\n");
  }
  save(small, {draw(shown), page(shown, small)}, report,
       engine != nullptr || findMismatch(small, CheckOptions()).has_value());
}

}  // namespace

void reportMismatch(const Mismatch& found, const Trace& trace, const FindAgain& findAgain,
                    const ReportOptions& options) {
  const auto makeSmall = [&](const Trace& t) { return shrunk(found, t, findAgain, options.shrinkFor); };
  report(found, trace, makeSmall, findAgain, nullptr, options);
}

void reportMismatch(const Mismatch& found, const Trace& trace, const CheckOptions& options,
                    const ReportOptions& reporting) {
  CheckOptions looking = options;
  if (options.engine == nullptr) looking.law = found.law;
  const FindAgain findAgain = sameKind(found.kind, looking);
  if (options.engine == nullptr) return reportMismatch(found, trace, findAgain, reporting);
  const auto makeSmall = [&](const Trace& t) {
    return shrinkWithEngine(found, t, *options.engine, findAgain, reporting.shrinkFor);
  };
  report(found, trace, makeSmall, findAgain, options.engine, reporting);
}

Trace beforeCrash(Trace trace) {
  const auto crashes = [&] {
    return crashOf([&] { static_cast<void>(inPlainEdits(trace)); }, {.seconds = 10, .quiet = true}).has_value();
  };
  while (!isPlain(trace) && crashes()) trace.calls.pop_back();
  return trace;
}

void reportCrash(const std::string& how, const Trace& trace, const CheckOptions& options, const ReportOptions& report) {
  fmt::print("MISMATCH the engine {}\n", how);
  if (report.shrinkFor.count() > 0) fmt::print("shrinking the trace of {} …\n", counted(trace.calls.size(), "line"));
  std::fflush(stdout);

  CheckOptions alone = options;
  alone.afterCommit = {};
  alone.naive = alone.cgal = false;
  alone.law = -1;
  const auto crash = [&](const Trace& candidate) {
    return crashOf([&] { static_cast<void>(findMismatch(candidate, alone)); }, {.seconds = 10, .quiet = true});
  };
  // Where the calls alone do not crash, a law does, or a reference.
  if (!crash(trace)) alone.law.reset();
  if (!crash(trace)) alone = options;
  const auto stillCrashes = [&](const Trace& candidate) { return crash(candidate).has_value(); };
  const Trace small = stillCrashes(trace) ? shrink(trace, stillCrashes, report.shrinkFor) : trace;
  const auto again = crash(small);
  print(small, fmt::format("the engine {}\n", again.value_or(how + ", but not again")));
  alone.skipRefused = false;
  const std::string title = "the engine " + how;
  const Trace shown = beforeCrash(small);
  save(small, {drawWithoutEngine(shown, title), pageWithoutEngine(shown, title)}, report, stillCrashes(small));
}

}  // namespace lgs::oracle
