// Patterns of Tiled's worlds: what the importer asks PCRE2 for, and takes from it.
#include "addons/tiled/src/regexp.h"

#include <gtest/gtest.h>

namespace lgs::tiled {
namespace {

/// "first|second" capture of the first match; "no" if nothing matches.
std::string matched(const std::string& pattern, const std::string& text) {
  std::uint64_t steps = kMaxPatternSteps;
  const auto fits = namesThatFit(pattern, {text}, steps);
  if (!fits) return fits.error();
  return fits->empty() ? "no" : fits->front().captures[0] + "|" + fits->front().captures[1];
}

TEST(TiledRegexp, FindsTheFirstMatch) {
  EXPECT_EQ(matched("ow-p0*(\\d+)-n0*(\\d+)-o0000\\.tmx", "ow-p0012-n0003-o0000.tmx"), "12|3");
  EXPECT_EQ(matched("(\\d+)_(\\d+)", "level_12_34.tmx"), "12|34") << "anywhere";
  EXPECT_EQ(matched("(x)|(y)", "y"), "|y") << "a capture that took no part";
  EXPECT_EQ(matched("(x)(y)(z)", "xyz"), "has 3 captures. It needs two: (…) for the column and (…) for the row");
}

TEST(TiledRegexp, LettersAreThoseOfUtf8) {
  EXPECT_EQ(matched("(.)(.)", "\na\nbc"), "b|c") << "a dot is no end of a line";
  EXPECT_EQ(matched("(a.c)(\\.)", "aéc."), "aéc|.") << "a letter of several bytes is one";
  EXPECT_EQ(matched("(a)(.)", "a\xFF"), "no") << "no letter";
  EXPECT_EQ(matched("(a)(.)",
                    "a\xE2\x82"
                    "ab"),
            "a|b")
      << "after half a letter";
}

TEST(TiledRegexp, SaysWhatIsWrong) {
  EXPECT_EQ(matched("(\\d+", ""), "is wrong at byte 5: missing closing parenthesis");
  EXPECT_EQ(matched("a)b", ""), "is wrong at byte 2: unmatched closing parenthesis");
  EXPECT_EQ(matched("[a-", ""), "is wrong at byte 4: missing terminating ] for character class");
  EXPECT_EQ(matched("[b-a]", ""), "is wrong at byte 4: range out of order in character class");
  EXPECT_EQ(matched("a\\", ""), "is wrong at byte 3: \\ at end of pattern");
  EXPECT_EQ(matched("*a", ""), "is wrong at byte 1: quantifier does not follow a repeatable item");
  EXPECT_EQ(matched("a\\C", ""), "is wrong at byte 4: using \\C is disabled by the application");
  EXPECT_EQ(matched("\xFF", "").substr(0, 31), "is wrong at byte 1: UTF-8 error");
}

TEST(TiledRegexp, HostilePatternsEndWithASentence) {
  EXPECT_EQ(matched("a{1000}()()", ""), "no");
  EXPECT_EQ(matched("a{99999}", ""), "is wrong at byte 8: number too big in {} quantifier");
  EXPECT_EQ(matched("((a{60}){60}){60}", ""), "is wrong at byte 18: regular expression is too large");
  EXPECT_EQ(matched(std::string(1'020, 'a') + "()()", ""), "no");
  EXPECT_EQ(matched(std::string(1'025, 'a'), ""), "has more than 1024 bytes");
  EXPECT_EQ(matched(std::string(1'000, '('), ""), "is wrong at byte 66: parentheses are too deeply nested");
  const std::string nested = std::string(64, '(') + "a" + std::string(64, ')');
  EXPECT_EQ(matched(nested, "a").substr(0, 15), "has 64 captures");
  const std::string name(255, 'a');
  for (const char* pattern : {"(a*)*(a*)*b", "(a|aa)+$()b", "(.*)(.*).*.*.*.*.*b", "((a+)+)+b", "(a?){99}()c",
                              "(?=(a+)+b)()", "(a)(?:\\1|a)*b|(?:(a|aa)*){9}c", "(?R)*b()()", "(a(?1)?a?)()b"}) {
    const std::string answer = matched(pattern, name);
    EXPECT_TRUE(answer == "no" || answer.starts_with("takes too long to match: ")) << pattern << ": " << answer;
  }
  const std::string file = "; the file is '" + name.substr(0, 40) + "…'";
  EXPECT_EQ(matched("((a+)+)+[bc]", name), "takes too long to match: match limit exceeded" + file);
  EXPECT_EQ(matched("(*LIMIT_MATCH=4000000000)((a+)+)+[bc]", name),
            "takes too long to match: match limit exceeded" + file)
      << "a pattern may lower the limits only";
}

TEST(TiledRegexp, CountsItsSteps) {
  const std::string pattern = "(a+)+[bc]()";
  std::uint64_t steps = 100;
  EXPECT_FALSE(namesThatFit(pattern, {"aaaaaaaaaaaaaaaa"}, steps));
  EXPECT_EQ(steps, 0U);
  steps = 100;
  EXPECT_EQ(namesThatFit(pattern, {"ab"}, steps)->size(), 1U);
  EXPECT_GT(steps, 80U);
  EXPECT_LT(steps, 99U);
  steps = 100;
  EXPECT_TRUE(namesThatFit(pattern, {std::string(40, 'x')}, steps)->empty());
  EXPECT_LE(steps, 60U) << "a name that is looked at, and not tried";
}

}  // namespace
}  // namespace lgs::tiled
