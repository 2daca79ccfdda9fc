#include "oracle/engine/serve.h"

#include "oracle/trace/dump.h"
#include "oracle/trace/trace.h"

#include <fmt/format.h>
#include <unistd.h>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace lgs::oracle {
namespace {

constexpr std::string_view kNothing = "lgs-trace 2\n";

// Whether there is one more line. Its end stays with it.
bool readLine(std::FILE* input, std::string& line) {
  std::array<char, 4096> piece{};
  line.clear();
  while (std::fgets(piece.data(), static_cast<int>(piece.size()), input) != nullptr) {
    line += piece.data();
    if (line.ends_with('\n')) return true;
  }
  return false;
}

// Edits are lines of a trace, so the lines between two commits are read as one.
std::string answerTo(const Trace& edits, Engine& engine) {
  for (const Call& edit : edits.calls) {
    if (edit.kind == Call::Kind::brush)
      engine.stroke(edit.brush);
    else
      edit.kind == Call::Kind::add ? engine.add(edit.name(), edit.polygon()) : engine.remove(edit.name());
  }
  const auto refusals = engine.commit();
  if (!refusals) return refusals.error().text + "\n";  // no line of an answer: so the harness tells it
  std::string text;
  for (const auto& [name, reason] : *refusals) text += fmt::format("refused {} {}\n", name, reason);
  if (const Delta* const delta = engine.delta(); delta == nullptr) {
    text += dump(engine.outline());
  } else {
    for (const auto& [sign, id, segment] : delta->changes())
      text += sign == '-' ? fmt::format("- {}\n", id) : fmt::format("{} {} {}", sign, id, dump({segment}));
  }
  if (engine.can().islands)
    for (const auto& [west, doubleArea] : engine.islands())
      text += fmt::format("island {} {} {}\n", west.x, west.y, doubleArea);
  return text + "end\n";
}

}  // namespace

// An exception must not go on to whoever had called when the process was forked.
void serve(Engine& engine, std::FILE* input, std::FILE* output) noexcept {
  std::string edits(kNothing);
  bool isNew = false;
  for (std::string asked; readLine(input, asked);) {
    if (asked == "lgs-engine 1\n") {
      fmt::print(output, "lgs-engine 1 {} {}\n", engine.name(), print(engine.can()));
    } else if (asked == "reset\n") {
      edits = kNothing;
      isNew = true;
    } else if (asked == "commit\n") {
      const Trace trace = parseTrace(std::exchange(edits, std::string(kNothing))).trace;
      if (std::exchange(isNew, false)) engine.reset(trace.preserve);
      fmt::print(output, "{}", answerTo(trace, engine));
    } else {
      edits += asked;
    }
    std::fflush(output);
  }
}

Guard::Program serving(std::shared_ptr<Engine> engine) {
  return [engine = std::move(engine)] {
    constexpr int kAnswers = 3;
    dup2(STDOUT_FILENO, kAnswers);
    dup2(STDERR_FILENO, STDOUT_FILENO);
    closeFrom(kAnswers + 1);  // whoever waits for the end of a pipe waits for all of its copies
    serve(*engine, fdopen(STDIN_FILENO, "r"), fdopen(kAnswers, "w"));
    std::fflush(stdout);
    _exit(0);
  };
}

}  // namespace lgs::oracle
