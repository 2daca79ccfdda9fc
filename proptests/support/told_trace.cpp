// What a person gets to see of a trace that breaks a law.
#include "oracle/check/failure.h"
#include "oracle/check/isolated.h"
#include "oracle/check/shell.h"
#include "oracle/trace/file.h"
#include "oracle/trace/model.h"
#include "proptests/support/law.h"
#include "proptests/support/traces.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ostream>

namespace lgs::oracle {
namespace {

/// What `lgs replay --check` comes to.
bool replayShows(const Trace& trace) {
  const Shared<bool> shows;
  const auto crash = crashOf([&] { *shows = findMismatch(trace, {}).has_value(); }, {.seconds = 20, .quiet = true});
  return crash || *shows;
}

/// Draws the mismatch that the checker finds in a trace, as a picture and as a page; the world alone where it finds
/// none, or crashes.
bool draw(const Trace& trace, const std::string& base) {
  const Shared<bool> drawn;
  CheckOptions options;
  options.skipRefused = true;
  const auto write = [&](const std::string& svg, const std::string& html) {
    const bool isDrawn = writeFile(base + ".svg", svg).has_value();
    *drawn = writeFile(base + ".html", html).has_value() && isDrawn;
  };
  static_cast<void>(crashOf(
      [&] {
        if (const auto mismatch = findMismatch(trace, options)) write(draw(*mismatch), page(*mismatch, trace));
      },
      {.quiet = true}));
  constexpr const char* kTitle = "the world at the end of the trace";
  if (!*drawn) write(drawWithoutEngine(trace, kTitle), pageWithoutEngine(trace, kTitle));
  return *drawn;
}

/// Saves a trace, its picture and its page, and says where.
std::string save(const Trace& trace, const std::string& base) {
  const bool written = writeFile(base + ".trace", printTrace(trace, test::told().why)).has_value();
  const bool isDrawn = draw(trace, base);
  constexpr const char* kNot = " (could not be written)";
  return fmt::format("{0}\ntrace      {1}.trace{2}\npicture    {1}.svg{3}\npage       {1}.html{3}\n", printTrace(trace),
                     base, written ? "" : kNot, isDrawn ? "" : kNot);
}

std::string lookAt(const std::string& base) {
  return fmt::format("look at it {} replay {} --check --svg {}\n", oracle::shellWord(LGS_COMMAND),
                     oracle::shellWord(base + ".trace"), oracle::shellWord(base + ".replay.svg"));
}

}  // namespace

void showValue(const Trace& trace, std::ostream& out) {
  testing::Test::RecordProperty("shrunk_edits", std::to_string(editCount(trace)));  // for a report, as in law.cpp
  const std::string base = test::fileBase();
  out << save(trace, base);
  if (replayShows(trace)) {
    out << lookAt(base);
    return;
  }
  std::vector<Trace> others{withoutRefused(trace)};  // a replay stops at an edit that must be refused
  for (const std::string& text : test::told().kept)
    if (ParsedTrace kept = parseTrace(text); !kept.error) others.push_back(std::move(kept.trace));
  for (const Trace& other : others) {
    if (!replayShows(other)) continue;
    out << "A replay of it shows nothing wrong; of this one, which is made of it, it does:\n"
        << save(other, base + "-2") << lookAt(base + "-2");
    return;
  }
  out << "A replay of it shows nothing wrong: it takes the test itself.\n";
}

}  // namespace lgs::oracle
