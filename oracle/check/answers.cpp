#include "oracle/check/answers.h"

#include "oracle/engine/capabilities.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/line.h"
#include "oracle/trace/trace.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

namespace lgs::oracle {

Answers::Answers(Engine& engine) : engine_(engine) { reset(); }

Answer Answers::take(std::string_view line) {
  ++lines_;
  if (line.ends_with('\r')) line.remove_suffix(1);
  Answer answer;
  if (const std::string wrong = fault(line, answer); !wrong.empty())
    answer = {.text = fmt::format("error {}: {}\n", lines_, wrong), .isOfBadLine = true};
  return answer;
}

// Does what a line says. Returns what is wrong with it, and what to do; then nothing has changed. Empty if it is good.
std::string Answers::fault(std::string_view line, Answer& answer) {
  constexpr std::array<std::string_view, 4> kOfTraces{"preserve", "add", "remove", "commit"};
  const auto words = splitWords(line);
  if (words.empty()) return "";
  if (words[0] == "lgs-engine") {
    if (words.size() != 2 || words[1] != "1")
      return "the greeting is 'lgs-engine 1'; this is the only version there is";
    answer.text = fmt::format("lgs-engine 1 {} {}\n", engine_.name(), print(engine_.can()));
    return "";
  }
  if (words[0] == "reset") return words.size() == 1 ? reset() : "reset stands alone on its line";
  if (std::ranges::find(kOfTraces, words[0]) == kOfTraces.end())
    return "unknown word; a line starts with lgs-engine, reset, preserve, add, remove, commit or #";
  const ParsedTrace parsed = parseTrace(fmt::format("lgs-trace 1\n{}", line));
  if (parsed.error) return parsed.error->text;
  if (words[0] == "preserve") return preserve(parsed.trace.preserve);
  hasEdits_ = true;
  for (const Call& edit : parsed.trace.calls) {
    if (edit.kind == Call::Kind::add)
      engine_.add(edit.name(), edit.polygon());
    else if (edit.kind == Call::Kind::remove)
      engine_.remove(edit.name());
    else
      commit(answer);
  }
  return "";
}

std::string Answers::reset() {
  preserve_ = {};
  hasEdits_ = false;
  engine_.reset(preserve_);
  return "";
}

std::string Answers::preserve(const PreservePairs& more) {
  if (!engine_.can().preserve)
    return "CGAL alone can not judge a preserve relation; start lgs oracle with --oracle both or naive";
  if (hasEdits_) return "preserve must stand before the first edit; reset begins a new world";
  for (const auto& [a, b] : more.pairs()) preserve_.add(a, b);
  engine_.reset(preserve_);
  return "";
}

void Answers::commit(Answer& answer) {
  const auto refusals = engine_.commit();
  if (!refusals) {
    answer.failure = refusals.error();
    return;
  }
  for (const auto& [name, reason] : *refusals) answer.text += fmt::format("refused {} {}\n", name, reason);
  answer.text += dump(engine_.outline()) + "end\n";
}

}  // namespace lgs::oracle
