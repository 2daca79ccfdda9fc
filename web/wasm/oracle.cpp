// The naive reference for pages: what the command `lgs` says with `--oracle naive`. It is made of the harness's own
// parts, and has an engine of its own, which it checks. Texts come through the input, and go through the answer.
#include "bridge.h"

#include "oracle/check/answers.h"
#include "oracle/check/failure.h"
#include "oracle/check/reference_engine.h"
#include "oracle/check/window.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"

#include <lgs/world.h>
#include <algorithm>
#include <exception>
#include <string>
#include <string_view>

using namespace lgs::oracle;

/// 0 if all is right, 1 if it is wrong. A trace is bad: -1, and less by its line.
using Said = std::int32_t;
constexpr Said kRight = 0, kWrong = 1;

namespace {

std::string in, out;

std::string_view text(std::size_t from, std::size_t bytes) { return std::string_view(in).substr(from, bytes); }

Said complain(const TraceError& error, std::string_view name) {
  out = message(error, name);
  return -1 - static_cast<Said>(error.line);
}

/// Does what is to be done with a trace that can be read.
template <class Use>
Said withTrace(std::size_t nameBytes, std::size_t bytes, const Use& use) {
  const std::string name(text(0, nameBytes));
  const ParsedTrace parsed = parseTrace(text(nameBytes, bytes));
  return parsed.error ? complain(*parsed.error, name) : use(parsed.trace, name);
}

/// Checks a trace, and goes on with the first mismatch, if there is one.
template <class Use>
Said afterCheck(std::size_t nameBytes, std::size_t bytes, const Use& use) {
  return withTrace(nameBytes, bytes, [&](const Trace& trace, const std::string& name) {
    CheckOptions options;
    options.cgal = false;
    CheckStats stats;
    const auto mismatch = checkTrace(trace, options, stats);
    return mismatch ? use(trace, name, *mismatch, stats) : complain(mismatch.error(), name);
  });
}

}  // namespace

// What a library calls where it would throw, and where its stack is broken.
namespace boost {
struct source_location;
void throw_exception(const std::exception&, const source_location&) { __builtin_trap(); }
}  // namespace boost
extern "C" {
void* __stack_chk_guard = nullptr;                          // NOLINT: the names are the compiler's
[[noreturn]] void __stack_chk_fail() { __builtin_trap(); }  // NOLINT
}

/// Where so many bytes go: a name for the text, and the text.
LGS_EXPORT("input") char* input(std::size_t bytes) {
  in.resize(bytes);
  return in.data();
}

LGS_EXPORT("output") const char* output() { return out.data(); }
LGS_EXPORT("outputBytes") std::size_t outputBytes() { return out.size(); }

/// `lgs oracle`: a good engine's answers to the lines.
LGS_EXPORT("answer") Said answer(std::size_t nameBytes, std::size_t bytes) {
  ReferenceEngine engine(true, false);
  Answers answers(engine);
  out.clear();
  Said said = kRight;
  for (std::string_view rest = text(nameBytes, bytes); !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const Answer answer = answers.take(rest.substr(0, end));
    if (answer.isOfBadLine) said = kWrong;
    out += answer.text;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return said;
}

/// The outline that the laws demand at the end of a trace, as a dump: of what is in memory.
LGS_EXPORT("outline") Said outline(std::size_t nameBytes, std::size_t bytes) {
  return withTrace(nameBytes, bytes, [](const Trace& trace, const std::string& name) {
    Player player(trace.preserve);
    if (const auto done = play(trace, player); !done) return complain(done.error(), name);
    Outline whole = naiveOutline(player.scene());
    std::erase_if(whole, [&](const OutlineSegment& s) { return !player.model().isLoaded(cellOf(s)); });
    out = dump(whole);
    return kRight;
  });
}

/// `lgs replay --check`: what it says.
LGS_EXPORT("check") Said check(std::size_t nameBytes, std::size_t bytes) {
  return afterCheck(nameBytes, bytes,
                    [](const Trace& trace, const std::string& name, const auto& mismatch, const CheckStats& stats) {
                      if (mismatch) {
                        out = "MISMATCH " + name + ": " + describe(*mismatch, trace);
                        return kWrong;
                      }
                      Player player(trace.preserve);
                      if (const auto done = play(trace, player); !done) return complain(done.error(), name);
                      out = inWords(stats) + inWords(trace, player.world(), outlineOf(player.world()));
                      return kRight;
                    });
}

/// `lgs replay --check --html`: a page that steps through the trace.
LGS_EXPORT("page") Said page(std::size_t nameBytes, std::size_t bytes) {
  return afterCheck(nameBytes, bytes,
                    [](const Trace& trace, const std::string& name, const auto& mismatch, const CheckStats&) {
                      out = mismatch ? lgs::oracle::page(*mismatch, trace) : lgs::oracle::page(trace, name);
                      return mismatch ? kWrong : kRight;
                    });
}
