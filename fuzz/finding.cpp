#include "fuzz/finding.h"

#include "oracle/check/failure.h"
#include "oracle/check/isolated.h"
#include "oracle/check/report.h"
#include "oracle/check/shell.h"
#include "oracle/check/shrink.h"
#include "oracle/trace/file.h"

#include <fmt/format.h>
#include <filesystem>
#include <functional>

namespace lgs::fuzz {
namespace {

using oracle::CheckStats;
using oracle::Trace;

// FNV-1a: the same input has the same name.
std::uint32_t hashOf(Bytes input) {
  std::uint32_t hash = 2'166'136'261U;
  for (const std::uint8_t byte : input) hash = (hash ^ byte) * 16'777'619U;
  return hash;
}

std::string nameOf(const Target& target, Bytes input) { return fmt::format("{}-{:08x}", target.name, hashOf(input)); }

void save(const std::string& path, std::string_view content) {
  if (oracle::writeOrComplain(path, content)) fmt::print("saved      {}\n", path);
}

// The input, and the command that runs it again.
std::string saveInput(const Target& target, Bytes input, const Where& where) {
  std::error_code ignored;  // writing will say what is wrong
  std::filesystem::create_directories(where.folder, ignored);
  const std::string path = (std::filesystem::path(where.folder) / (nameOf(target, input) + ".input")).string();
  save(path, textOf(input));
  return fmt::format("{} {}", where.again, oracle::shellPath(path));
}

// Whether `work` crashes, or hangs: too long is a finding as well.
bool dies(const std::function<void()>& work) {
  return oracle::crashOf(work, {.seconds = 10, .quiet = true}).has_value();
}

bool traceDies(const Target& target, const Trace& trace) {
  return dies([&] {
    CheckStats stats;
    target.checkTrace(trace, stats);
  });
}

}  // namespace

void report(const Target& target, Bytes input, const Finding& finding, const Where& where) {
  fmt::print("FINDING in {} ({})\n", target.name, target.about);
  const std::string again = saveInput(target, input, where);
  if (!finding.mismatch || !target.checkTrace) {
    fmt::print("{}again      {}\n", finding.text, again);
  } else {
    const auto findAgain = [&](const Trace& trace) -> std::optional<oracle::Mismatch> {
      if (traceDies(target, trace)) return std::nullopt;  // with fewer edits the same bug may end the program
      CheckStats stats;
      auto found = target.checkTrace(trace, stats);
      const bool same = found && found->mismatch && found->mismatch->kind == finding.mismatch->kind;
      return same ? std::move(found->mismatch) : std::nullopt;
    };
    oracle::reportMismatch(
        *finding.mismatch, target.traceOf(input), findAgain,
        {where.folder, nameOf(target, input), again, where.shrinkFor, oracle::shellWord(LGS_COMMAND)});
  }
}

bool crashes(const Target& target, Bytes input) {
  return dies([&] {
    CheckStats stats;
    target.check(input, stats);
  });
}

void reportCrash(const Target& target, Bytes input, const Where& where) {
  fmt::print("FINDING in {}: this input ends the program\n", target.name);
  fmt::print("again      {}\n", saveInput(target, input, where));
  const std::string base = (std::filesystem::path(where.folder) / nameOf(target, input)).string();
  Trace trace = target.checkTrace ? target.traceOf(input) : Trace();
  if (trace.calls.empty() || !traceDies(target, trace)) return;
  const auto stillDies = [&](const Trace& candidate) { return traceDies(target, candidate); };
  trace = oracle::shrink(std::move(trace), stillDies, where.shrinkFor);
  const std::string text = printTrace(trace);
  fmt::print("\n{}\n", text);
  save(base + ".trace", text);
  const std::string title = fmt::format("what is added before {} ends", target.name);
  const Trace shown = oracle::beforeCrash(trace);
  save(base + ".svg", drawWithoutEngine(shown, title));
  save(base + ".html", pageWithoutEngine(shown, title));
}

}  // namespace lgs::fuzz
