// What a page holds: its data, step by step; and that no text can become markup. How it behaves: browser_test.py.
#include "oracle/check/failure.h"
#include "oracle/check/report.h"
#include "oracle/tests/page/cases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace lgs::oracle {
namespace {

using Json = nlohmann::json;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// What is between two marks of a text.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t first = text.find(begin) + begin.size();
  return text.substr(first, text.find(end, first) - first);
}

std::string dataText(const std::string& page) {
  return between(page, "<script type=\"application/json\" id=\"data\">", "</script>");
}

Json dataOf(const std::string& page) { return Json::parse(dataText(page)); }

Json dataOf(const test::PageCase& made) { return dataOf(writePage(made.trace, made.options)); }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// A field of each step.
std::vector<std::string> texts(const Json& steps, const char* field) {
  std::vector<std::string> all;
  for (const Json& step : steps) all.push_back(step.value(field, ""));
  return all;
}

std::string ends(const Json& data, const Json& segment) {
  const auto text = [&](const char* end) { return data["points"][segment[end].get<std::size_t>()]["text"]; };
  return text("start").get<std::string>() + " " + text("end").get<std::string>();
}

TEST(Page, ListsTheDifferencesOfTheEnd) {
  const test::PageCase made = test::uncutWall();
  const Json data = dataOf(made);
  const Json& end = data["steps"].back();
  EXPECT_TRUE(end["wrong"].get<bool>());
  EXPECT_EQ(end["more"], 0);
  std::string report;
  for (const Json& difference : end["differences"]) report += difference["text"].get<std::string>() + "\n";
  EXPECT_EQ(report, made.options.report);
  const Json& first = end["differences"][0];
  EXPECT_EQ(first["kind"], "missing");
  EXPECT_TRUE(first["actual"].is_null());
  EXPECT_EQ(ends(data, data["segments"][first["expected"].get<std::size_t>()]), "(0.5, 1) (0, 1)");
  const Json& extra = data["segments"][end["differences"][1]["actual"].get<std::size_t>()];
  EXPECT_EQ(data["polygons"][extra["owner"].get<std::size_t>()]["name"], "floor");
}

// The owners of the last outline's segments, by name.
std::vector<std::string> ownersAtTheEnd(const std::string& trace) {
  const Json data = dataOf(writePage(parseTrace(trace).trace, {}));
  std::vector<std::string> names;
  for (const Json& number : data["steps"].back()["expected"]) {
    const Json& segment = data["segments"][number.get<std::size_t>()];
    names.push_back(data["polygons"][segment["owner"].get<std::size_t>()]["name"]);
  }
  return names;
}

TEST(Page, KnowsTheOwnerOfEachSegment) {
  // Sorted by start. Both have a segment on the side between them.
  const std::string squares = "lgs-trace 1\npreserve 1 2\nadd a 0 0 1 0 0 1 0 1 1 0 1\nadd b 1 0 2 0 0 1 0 1 1 0 1\n";
  EXPECT_THAT(ownersAtTheEnd(squares), ElementsAre("a", "a", "a", "b", "a", "b", "b", "b"));
  EXPECT_THAT(ownersAtTheEnd(squares + "remove a\nadd c 0 0 1 0 0 1 0 1 1 0 1\n"),
              ElementsAre("c", "c", "c", "b", "c", "b", "b", "b"));
}

TEST(Page, KeepsTextsFromBecomingMarkup) {
  const test::PageCase made = test::markup();
  const std::string page = writePage(made.trace, made.options);
  EXPECT_EQ(count(page, "<script"), 2u);
  EXPECT_EQ(count(page, "</script>"), 2u);
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_THAT(page, Not(HasSubstr("\xff")));
  EXPECT_THAT(dataText(page), Not(HasSubstr("<")));
  EXPECT_THAT(between(page, "<title>", "</title>"), StartsWith("&lt;/script&gt;&lt;img/src=x"));
  EXPECT_THAT(between(page, "<pre id=\"report\">", "</pre>"),
              HasSubstr("&amp;amp;&quot;'`${1}{{data}}\nits second line\n"));
  const Json data = dataOf(page);
  EXPECT_EQ(data["polygons"][0]["name"], made.trace.calls[0].name());
  EXPECT_EQ(data["expectedName"], "<b>expected</b>");
  EXPECT_EQ(data["title"], made.trace.calls[0].name() + " <!-- \x01\xef\xbf\xbd ü");  // no UTF-8: a replacement
}

TEST(Page, HasExactCoordinatesAtTheEndsOfTheWorld) {
  const Json data = dataOf(test::endsOfTheWorld());
  const std::int64_t far = std::int64_t{kMaxCell} * kUnitsPerCell;
  EXPECT_EQ(data["points"][0]["x"].get<std::int64_t>(), -far);
  EXPECT_EQ(data["points"][4]["x"].get<std::int64_t>(), far + 1);
  EXPECT_EQ(data["points"][4]["text"], "(1073741824+1/65536, 1073741824)");
}

TEST(Page, ShowsAnExcerptOfALongTrace) {
  const test::PageCase made = test::longTrace();
  const std::string page = writePage(made.trace, made.options);
  EXPECT_LT(page.size(), 500'000u);
  const Json data = dataOf(page);
  EXPECT_THAT(data["note"].get<std::string>(), HasSubstr("too long"));
  ASSERT_EQ(data["steps"].size(), 1'001u);
  EXPECT_EQ(data["steps"][0]["added"].size(), 27u * 27u);  // 25 and a rim of one
  EXPECT_EQ(data["steps"].back()["number"], made.trace.calls.size());
  EXPECT_THAT(texts(data["steps"], "edit"), Not(Contains(StartsWith("add far"))));
  EXPECT_EQ(data["steps"].back()["differences"].size(), 1u);
  EXPECT_EQ(data["steps"].back()["actual"].size() + 1, data["steps"].back()["expected"].size());
}

// The checker may compare the surroundings of an edit alone. The page shows the whole outline all the same.
TEST(Page, CompletesAnOutlineThatIsAPart) {
  test::PageCase made = test::uncutWall();
  const std::size_t whole = dataOf(made)["steps"].back()["expected"].size();
  PageEnd& end = *made.options.end;
  const auto isRight = [](const OutlineSegment& s) { return s.end == Point{kUnitsPerCell, 3 * kUnitsPerCell / 2}; };
  std::erase_if(end.expected, isRight);  // one of two that start at a point
  std::erase_if(end.actual, isRight);
  end.polygons -= 1;
  const Json steps = dataOf(made)["steps"];
  EXPECT_EQ(steps.back()["expected"].size(), whole);
  EXPECT_EQ(steps.back()["actual"].size(), whole - 1);
  EXPECT_EQ(steps.back()["differences"].size(), 6u);
}

// What the checker would find at the end of a page's trace.
Mismatch mismatchOf(const test::PageCase& made) {
  Mismatch mismatch;
  mismatch.kind = Mismatch::Kind::cgal;
  mismatch.text = "it differs\n";
  mismatch.edits = made.options.end->edits;
  mismatch.scene.polygons.resize(made.options.end->polygons);
  mismatch.expected = made.options.end->expected;
  mismatch.actual = made.options.end->actual;
  return mismatch;
}

TEST(Page, ShowsAMismatchOfTheChecker) {
  const test::PageCase made = test::uncutWall();
  Mismatch mismatch = mismatchOf(made);
  const Json data = dataOf(page(mismatch, made.trace));
  EXPECT_EQ(data["expectedName"], "CGAL");
  EXPECT_THAT(data["report"].get<std::string>(), HasSubstr("after edit 7, line 8"));
  EXPECT_EQ(data["steps"].back()["differences"].size(), 7u);
  mismatch.kind = Mismatch::Kind::verdict;
  mismatch.edits = 1;
  const Json first = dataOf(page(mismatch, made.trace));
  EXPECT_EQ(first["steps"].size(), 2u);
  EXPECT_EQ(first["expectedName"], "engine") << "there is no other outline";
  EXPECT_EQ(first["actualName"], "");
}

TEST(Page, IsSavedBesideThePicture) {
  const test::PageCase made = test::uncutWall();
  const Mismatch mismatch = mismatchOf(made);
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "lgs-page-test";
  ::testing::internal::CaptureStdout();
  reportMismatch(mismatch, made.trace, [](const Trace&) { return std::nullopt; },
                 {folder.string(), "found", "again", {}});
  const std::string said = ::testing::internal::GetCapturedStdout();
  EXPECT_THAT(said, HasSubstr("found.svg\npage       "));
  std::ostringstream saved;
  saved << std::ifstream(folder / "found.html").rdbuf();
  EXPECT_EQ(saved.str(), page(mismatch, made.trace));
  std::filesystem::remove_all(folder);
}

TEST(Page, NeedsNothingFromOutside) {
  const test::PageCase made = test::uncutWall();
  const std::string page = writePage(made.trace, made.options);
  EXPECT_THAT(page, HasSubstr("content=\"default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'\""));
  EXPECT_LT(page.size(), 60'000u);
  for (const std::string outside : {" src=", "<link", "@import", "url(", "fetch("})
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  EXPECT_EQ(count(page, "http"), 2u) << "http-equiv, and the namespace of SVG";
}

}  // namespace
}  // namespace lgs::oracle
