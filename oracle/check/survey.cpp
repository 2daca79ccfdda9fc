#include "oracle/check/survey.h"

#include "oracle/check/finding.h"
#include "oracle/generate/generator.h"
#include "oracle/reference/words.h"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>

namespace lgs::oracle {
namespace {

std::string fileOf(std::string kind) {
  std::ranges::replace(kind, ' ', '-');
  return kind;
}

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    if (c == '<' || c == '>' || c == '&') {
      html += c == '<' ? "&lt;" : c == '>' ? "&gt;" : "&amp;";
    } else {
      html += c;
    }
  }
  return html;
}

/// Fewer edits first, then less to read: cells near the origin, round coordinates.
std::pair<std::size_t, std::size_t> sizeOf(const Trace& trace) { return {editCount(trace), printTrace(trace).size()}; }

}  // namespace

void Survey::add(const Mismatch& found, const Trace& trace) {
  const std::string kind = kindOfFinding(found, *options_.engine);
  Entry& entry = kinds_[kind];
  constexpr std::uint64_t kShrunk = 3;  // later ones are only counted
  if (++entry.count <= kShrunk) keep(kind, entry, found, trace);
}

void Survey::keep(const std::string& kind, Entry& entry, const Mismatch& found, const Trace& trace) {
  Engine& engine = *options_.engine;
  CheckOptions narrow = options_;
  narrow.afterCommit = {};
  narrow.cgal = narrow.cgal && found.kind != Mismatch::Kind::naive;
  const auto findAgain = [&](const Trace& candidate) -> std::optional<Mismatch> {
    if (!whyNot(candidate, engine.can()).empty()) return std::nullopt;
    auto again = findMismatch(candidate, narrow);
    return again && again->kind == found.kind && kindOfFinding(*again, engine) == kind ? std::move(again)
                                                                                       : std::nullopt;
  };
  Trace small = shrinkWithEngine(found, trace, engine, findAgain, shrinkFor_);
  const auto again = findAgain(small);
  if (!again) small = untilFound(trace, found);
  if (entry.count > 1 && sizeOf(small) >= sizeOf(entry.trace)) return;
  const Mismatch& shown = again ? *again : found;
  entry.trace = small;
  entry.text = describe(shown, small);
  const std::string base = (std::filesystem::path(folder_) / fileOf(kind)).string();
  writeOrComplain(base + ".trace", printTrace(small, kind));
  writeOrComplain(base + ".svg", draw(shown));
  writeOrComplain(base + ".html", page(shown, small));
}

bool Survey::write(const CheckStats& stats, const std::string& again) const {
  const std::string title = fmt::format("{} under the harness", options_.engine->name());
  const std::string facts =
      fmt::format("{}, {}. Worlds: {}. Compared: {}.", counted(stats.edits, "edit"), counted(stats.commits, "commit"),
                  worldsInWords(options_.engine->can()), comparedInWords(options_.engine->can()));
  std::string md = fmt::format("# {}\n\n{}\n\n    {}\n\n", title, facts, again);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<meta charset=\"utf-8\">\n<title>{0}</title>\n"
      "<style>body {{ font-family: sans-serif; max-width: 60em; margin: auto }} img {{ max-width: 100% }}\n"
      "pre {{ white-space: pre-wrap }} th, td {{ text-align: left; padding-right: 1em }}</style>\n"
      "<h1>{0}</h1>\n<p>{1}</p>\n<pre>{2}</pre>\n",
      escaped(title), escaped(facts), escaped(again));
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
    mdTexts += fmt::format("\n## {}\n\n```\n{}```\n\n![{}]({}.svg)\n", kind, text, kind, file);
    htmlTexts += fmt::format("<h2 id=\"{0}\">{1}</h2>\n<pre>{2}</pre>\n<img src=\"{0}.svg\" alt=\"{1}\">\n", file, kind,
                             escaped(text));
  }
  if (!kinds_.empty()) html += "</table>\n";
  const std::string base = (std::filesystem::path(folder_) / "report").string();
  const bool isWritten = writeOrComplain(base + ".md", md + mdTexts);
  return writeOrComplain(base + ".html", html + htmlTexts) && isWritten;
}

}  // namespace lgs::oracle
