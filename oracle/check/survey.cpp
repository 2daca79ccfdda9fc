#include "oracle/check/survey.h"

#include "oracle/check/finding.h"
#include "oracle/check/levels.h"
#include "oracle/generate/generator.h"
#include "oracle/page/page.h"
#include "oracle/reference/words.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <filesystem>

namespace lgs::oracle {
namespace {

// A block of code in Markdown: whatever stands in the text, it can not end the block.
std::string indented(const std::string& text) {
  std::string out = "    ";
  for (const char c : text) out += c == '\n' ? std::string("\n    ") : std::string(1, c);
  return out;
}

// Text in Markdown that means nothing there: no HTML, no link, no picture.
std::string inMarkdown(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>&|!").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

// Fewer edits first, then less to read: cells near the origin, round coordinates.
std::pair<std::size_t, std::size_t> sizeOf(const Trace& trace) { return {editCount(trace), printTrace(trace).size()}; }

}  // namespace

std::string Survey::fileOf(std::string kind) {
  std::ranges::replace(kind, ' ', '-');
  return kind;
}

Survey::Survey(CheckOptions options, SurveyOptions how) : options_(std::move(options)), how_(std::move(how)) {
  for (const KnownMismatch& one : how_.known) known_.insert(identityOf(one));
}

void Survey::add(const Mismatch& found, const Trace& trace, const CheckStats& stats) {
  constexpr std::uint64_t kHangs = 3;
  const bool isHang = found.kind == Mismatch::Kind::hang;
  const std::string kind = kindOfFinding(found, *options_.engine);
  Entry& entry = kinds_[kind];
  ++entry.count;
  std::uint64_t& few = isAdvice(found, options_.recommended) ? entry.advice : entry.faults;
  if (few < (isHang ? std::min(kHangs, how_.shrunk) : how_.shrunk)) {
    ++entry.looked;
    const State state = shrink(kind, entry, found, trace);
    few += state == State::known && !isHang ? 0 : 1;  // however many are known, a new one does not hide behind them
  }
  if (isHang && entry.count >= kHangs) options_.engine->hurry(Engine::Haste::some);
  write(stats);
}

void Survey::lookAnew() {
  for (auto& [kind, entry] : kinds_) entry.faults = entry.advice = 0;
}

void Survey::add(const Failure& failure) {
  constexpr std::array kKinds{"crash", "hang", "protocol"};
  const std::string kind = kKinds[static_cast<std::size_t>(failure.kind)];
  Entry& entry = kinds_[kind];
  ++entry.count;
  ++entry.looked;
  if (std::ranges::any_of(entry.findings, [](const Finding& one) { return one.trace.calls.empty(); })) return;
  entry.findings.emplace_back().text = inWords(failure);
  if (entry.findings.size() == 1) keep(kind, {}, {drawWithoutEngine({}, kind), pageWithoutEngine({}, kind)});
}

Survey::State Survey::shrink(const std::string& kind, Entry& entry, const Mismatch& found, const Trace& trace) {
  Engine& engine = *options_.engine;
  CheckOptions looking = options_;  // other recommendations must not come before this one
  const bool isOne = isAdvice(found, options_.recommended);
  if (isOne) looking.recommended &= ~brokenBy(found);
  const auto findAgain = [&, isSame = sameKind(found.kind, looking)](const Trace& candidate) {
    auto again = isSame(candidate);
    return again && kindOfFinding(*again, engine) == kind ? std::move(again) : std::nullopt;
  };
  Trace small = shrinkWithEngine(found, trace, engine, findAgain, how_.shrinkFor);
  const auto again = findAgain(small);
  if (!again) small = untilFound(trace, found);
  const Mismatch& shown = again ? *again : found;
  const std::string identity = identityOf({kind, small});
  const State state = isOne ? State::advice : known_.contains(identity) ? State::known : State::fault;
  if (!met_.insert(identity + (isOne ? " advice" : "")).second) return state;
  entry.findings.push_back({small, describe(shown, small), state});
  std::ranges::stable_sort(entry.findings, {}, [](const Finding& one) { return sizeOf(one.trace); });
  if (entry.findings.front().trace == small) keep(kind, small, {draw(shown), page(shown, small)});
  return state;
}

void Survey::keep(const std::string& kind, const Trace& trace, const Views& views) const {
  const std::string base = (std::filesystem::path(how_.folder) / fileOf(kind)).string();
  writeOrComplain(base + ".trace", printTrace(trace, kind));
  writeOrComplain(base + ".svg", views.picture);
  writeOrComplain(base + ".html", views.page);
}

std::vector<KnownMismatch> Survey::faults() const {
  std::vector<KnownMismatch> faults;
  for (const auto& [kind, entry] : kinds_)
    for (const Finding& one : entry.findings)
      if (one.state == State::fault) faults.push_back({kind, one.trace});
  return faults;
}

std::string Survey::facts(const CheckStats& stats) const {
  if (options_.engine == nullptr) return "It has not started.";
  return fmt::format("{}, {}. Worlds: {}. Compared: {}.", counted(stats.edits, "edit"),
                     counted(stats.commits, "commit"), worldsInWords(options_.engine->can()),
                     comparedInWords(options_.engine->can()));
}

bool Survey::write(const CheckStats& stats) const {
  const std::string name = options_.engine != nullptr ? readable(options_.engine->name()) : "An engine";
  const std::string title = name + " under the harness";
  std::string md = fmt::format("# {}\n\n{}\n\n{}\n\n", inMarkdown(title), facts(stats), indented(readable(how_.again)));
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<meta charset=\"utf-8\">\n<title>{0}</title>\n"
      "<style>body {{ font-family: sans-serif; max-width: 60em; margin: auto }} img {{ max-width: 100% }}\n"
      "pre {{ white-space: pre-wrap }} th, td {{ text-align: left; padding-right: 1em }}</style>\n"
      "<h1>{0}</h1>\n<p>{1}</p>\n<pre>{2}</pre>\n",
      inElement(title), inElement(facts(stats)), inElement(how_.again));
  md += kinds_.empty() ? "No mismatch.\n"
                       : "| kind | how often | minimal trace | picture | step by step |\n|---|---:|---|---|---|\n";
  html += kinds_.empty() ? "<p>No mismatch.</p>\n"
                         : "<table>\n<tr><th>kind<th>how often<th>minimal trace<th>picture<th>step by step\n";
  std::string mdTexts, htmlTexts;
  for (const auto& [kind, entry] : kinds_) {
    const std::string file = fileOf(kind), edits = counted(editCount(entry.findings.front().trace), "edit");
    md += fmt::format("| {0} | {1} | [{2}]({3}.trace) | [{3}.svg]({3}.svg) | [{3}.html]({3}.html) |\n", kind,
                      entry.count, edits, file);
    html += fmt::format(
        "<tr><td><a href=\"#{3}\">{0}</a><td>{1}<td><a href=\"{3}.trace\">{2}</a><td><a "
        "href=\"{3}.svg\">{3}.svg</a><td><a href=\"{3}.html\">{3}.html</a>\n",
        kind, entry.count, edits, file);
    const std::string text = printTrace(entry.findings.front().trace) + "\n" + entry.findings.front().text;
    mdTexts += fmt::format("\n## {}\n\n{}\n\n![{}]({}.svg)\n", kind, indented(readable(text)), kind, file);
    const std::string link = linkTo(how_.site, entry.findings.front().trace);
    if (!link.empty()) mdTexts += fmt::format("\n[in the sandbox]({})\n", link);
    htmlTexts += fmt::format("<h2 id=\"{0}\">{1}</h2>\n<pre>{2}</pre>\n<img src=\"{0}.svg\" alt=\"{1}\">\n", file, kind,
                             inElement(text));
    if (!link.empty()) htmlTexts += fmt::format("<p><a href=\"{}\">in the sandbox</a>\n", inElement(link));
  }
  if (!kinds_.empty()) html += "</table>\n";
  const std::string base = (std::filesystem::path(how_.folder) / "report").string();
  const bool isWritten = writeOrComplain(base + ".md", md + mdTexts);
  return writeOrComplain(base + ".html", html + htmlTexts) && isWritten;
}

}  // namespace lgs::oracle
