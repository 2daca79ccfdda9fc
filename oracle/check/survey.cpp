#include "oracle/check/survey.h"

#include "oracle/check/finding.h"
#include "oracle/generate/generator.h"
#include "oracle/page/page.h"
#include "oracle/reference/words.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <filesystem>

namespace lgs::oracle {
namespace {

std::string fileOf(std::string kind) {
  std::ranges::replace(kind, ' ', '-');
  return kind;
}

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

void Survey::add(const Mismatch& found, const Trace& trace, const CheckStats& stats) {
  constexpr std::uint64_t kShrunk = 3;  // later ones are only counted
  const std::string kind = kindOfFinding(found, *options_.engine);
  Entry& entry = kinds_[kind];
  if (++entry.count <= kShrunk) shrink(kind, entry, found, trace);
  if (found.kind == Mismatch::Kind::hang && entry.count >= kShrunk) options_.engine->hurry(true);
  write(stats);
}

void Survey::add(const Failure& failure) {
  constexpr std::array kKinds{"crash", "hang", "protocol"};
  const std::string kind = kKinds[static_cast<std::size_t>(failure.kind)];
  Entry& entry = kinds_[kind];
  if (++entry.count > 1) return;
  entry.text = inWords(failure);
  keep(kind, entry, {}, {drawWithoutEngine({}, kind), pageWithoutEngine({}, kind)});
}

void Survey::shrink(const std::string& kind, Entry& entry, const Mismatch& found, const Trace& trace) {
  Engine& engine = *options_.engine;
  const auto findAgain = [&, isSame = sameKind(found.kind, options_)](const Trace& candidate) {
    auto again = isSame(candidate);
    return again && kindOfFinding(*again, engine) == kind ? std::move(again) : std::nullopt;
  };
  Trace small = shrinkWithEngine(found, trace, engine, findAgain, shrinkFor_);
  const auto again = findAgain(small);
  if (!again) small = untilFound(trace, found);
  if (entry.count > 1 && sizeOf(small) >= sizeOf(entry.trace)) return;
  const Mismatch& shown = again ? *again : found;
  entry.text = describe(shown, small);
  keep(kind, entry, small, {draw(shown), page(shown, small)});
}

void Survey::keep(const std::string& kind, Entry& entry, const Trace& trace, const Views& views) {
  entry.trace = trace;
  const std::string base = (std::filesystem::path(folder_) / fileOf(kind)).string();
  writeOrComplain(base + ".trace", printTrace(trace, kind));
  writeOrComplain(base + ".svg", views.picture);
  writeOrComplain(base + ".html", views.page);
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
  std::string md = fmt::format("# {}\n\n{}\n\n{}\n\n", inMarkdown(title), facts(stats), indented(readable(again_)));
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<meta charset=\"utf-8\">\n<title>{0}</title>\n"
      "<style>body {{ font-family: sans-serif; max-width: 60em; margin: auto }} img {{ max-width: 100% }}\n"
      "pre {{ white-space: pre-wrap }} th, td {{ text-align: left; padding-right: 1em }}</style>\n"
      "<h1>{0}</h1>\n<p>{1}</p>\n<pre>{2}</pre>\n",
      inElement(title), inElement(facts(stats)), inElement(again_));
  md += kinds_.empty() ? "No mismatch.\n"
                       : "| kind | how often | minimal trace | picture | step by step |\n|---|---:|---|---|---|\n";
  html += kinds_.empty() ? "<p>No mismatch.</p>\n"
                         : "<table>\n<tr><th>kind<th>how often<th>minimal trace<th>picture<th>step by step\n";
  std::string mdTexts, htmlTexts;
  for (const auto& [kind, entry] : kinds_) {
    const std::string file = fileOf(kind), edits = counted(editCount(entry.trace), "edit");
    md += fmt::format("| {0} | {1} | [{2}]({3}.trace) | [{3}.svg]({3}.svg) | [{3}.html]({3}.html) |\n", kind,
                      entry.count, edits, file);
    html += fmt::format(
        "<tr><td><a href=\"#{3}\">{0}</a><td>{1}<td><a href=\"{3}.trace\">{2}</a><td><a "
        "href=\"{3}.svg\">{3}.svg</a><td><a href=\"{3}.html\">{3}.html</a>\n",
        kind, entry.count, edits, file);
    const std::string text = printTrace(entry.trace) + "\n" + entry.text;
    mdTexts += fmt::format("\n## {}\n\n{}\n\n![{}]({}.svg)\n", kind, indented(readable(text)), kind, file);
    htmlTexts += fmt::format("<h2 id=\"{0}\">{1}</h2>\n<pre>{2}</pre>\n<img src=\"{0}.svg\" alt=\"{1}\">\n", file, kind,
                             inElement(text));
  }
  if (!kinds_.empty()) html += "</table>\n";
  const std::string base = (std::filesystem::path(folder_) / "report").string();
  const bool isWritten = writeOrComplain(base + ".md", md + mdTexts);
  return writeOrComplain(base + ".html", html + htmlTexts) && isWritten;
}

}  // namespace lgs::oracle
