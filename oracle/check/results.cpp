#include "oracle/check/results.h"

#include "oracle/page/page.h"

#include <fmt/format.h>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

namespace lgs::oracle {
namespace {

constexpr std::array kStates{"fault", "known", "advice"};

const char* wordFor(Survey::State state) { return kStates[static_cast<std::size_t>(state)]; }

}  // namespace

std::string asJson(const Results& results) {
  using Json = nlohmann::ordered_json;
  Json kinds = Json::array(), gone = Json::array();
  for (const auto& [kind, entry] : results.survey.kinds()) {
    Json findings = Json::array();
    for (const Survey::Finding& one : entry.findings)
      findings.push_back({{"state", wordFor(one.state)},
                          {"edits", editCount(one.trace)},
                          {"trace", printTrace(one.trace)},
                          {"text", readable(one.text)}});
    kinds.push_back(
        {{"kind", kind}, {"count", entry.count}, {"only counted", entry.onlyCounted()}, {"findings", findings}});
  }
  for (const auto& [kind, trace] : results.gone) gone.push_back({{"kind", kind}, {"trace", printTrace(trace)}});
  const Json all{{"engine", readable(results.engine)},
                 {"fine", results.areFine()},
                 {"edits", results.stats.edits},
                 {"commits", results.stats.commits},
                 {"seconds", results.seconds},
                 {"kinds", kinds},
                 {"gone", gone}};
  return all.dump(1) + "\n";
}

std::string asJUnit(const Results& results) {
  std::string cases;
  std::size_t tests = 0, failures = 0, skipped = 0;
  const auto add = [&](const std::string& name, const char* element, const std::string& message,
                       const std::string& text) {
    cases += fmt::format("  <testcase classname=\"{}\" name=\"{}\">", inElement(results.engine), inElement(name));
    if (*element != '\0')
      cases += fmt::format("<{0} message=\"{1}\">{2}</{0}>", element, inElement(message), inElement(text));
    cases += "</testcase>\n";
    ++tests;
    failures += element == std::string_view("failure") ? 1 : 0;
    skipped += element == std::string_view("skipped") ? 1 : 0;
  };
  add(fmt::format("{} edits, {} commits", results.stats.edits, results.stats.commits), "", "", "");
  for (const auto& [kind, entry] : results.survey.kinds())
    for (std::size_t k = 0; k < entry.findings.size(); ++k) {
      const auto& [trace, text, state] = entry.findings[k];
      const bool isFault = state == Survey::State::fault;
      add(fmt::format("{} {}", kind, k + 1), isFault ? "failure" : "skipped", isFault ? kind : wordFor(state),
          printTrace(trace) + "\n" + text);
    }
  for (std::size_t k = 0; k < results.gone.size(); ++k)
    add(fmt::format("gone {}", k + 1), "failure", "known, but gone: " + results.gone[k].kind,
        printTrace(results.gone[k].trace));
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"lgs check: {}\" tests=\"{}\" failures=\"{}\" "
      "errors=\"0\" skipped=\"{}\" time=\"{:.3f}\">\n{}</testsuite>\n",
      inElement(results.engine), tests, failures, skipped, results.seconds, cases);
}

}  // namespace lgs::oracle
