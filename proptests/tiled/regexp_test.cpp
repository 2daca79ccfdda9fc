// Regular expressions of Tiled's worlds: by hand, and against those of the standard library.
#include "proptests/support/law.h"

#include "lib/tiled/src/regexp.h"

#include <gtest/gtest.h>
#include <regex>

namespace lgs::tiled {
namespace {

/// "first|second" capture of the first match; "no" if nothing matches.
std::string matched(const std::string& pattern, const std::string& text) {
  const auto regexp = Regexp::parse(pattern);
  if (!regexp) return regexp.error();
  std::uint64_t steps = Regexp::kMaxSteps;
  const auto match = regexp->match(text, steps);
  if (!match) return match.error();
  return match->isThere ? match->captures[0] + "|" + match->captures[1] : "no";
}

TEST(TiledRegexp, FindsTheFirstMatch) {
  EXPECT_EQ(matched("ow-p0*(\\d+)-n0*(\\d+)-o0000\\.tmx", "ow-p0012-n0003-o0000.tmx"), "12|3");
  EXPECT_EQ(matched("(\\d+)_(\\d+)", "level_12_34.tmx"), "12|34") << "anywhere";
  EXPECT_EQ(matched("^(\\d+)_(\\d+)$", "level_12_34.tmx"), "no");
  EXPECT_EQ(matched("^(\\d+)_(\\d+)$", "12_34"), "12|34");
  EXPECT_EQ(matched("(-?\\d+)x([+-]?[0-9]+)", "a-3x+4b"), "-3|+4");
  EXPECT_EQ(matched("(a|ab)(c|bcd)", "abcd"), "a|bcd") << "what stands first is preferred";
  EXPECT_EQ(matched("(a+)(a*)", "baaac"), "aaa|");
  EXPECT_EQ(matched("(a+?)(a*)", "baaac"), "a|aa");
  EXPECT_EQ(matched("(a?\?)(a?)", "a"), "|a");
  EXPECT_EQ(matched("(a*?)(b|$)", "aab"), "aa|b");
  EXPECT_EQ(matched("(\\d{2})(\\d{1,2})", "12345"), "12|34");
  EXPECT_EQ(matched("(\\d{2,})(\\d)", "12345"), "1234|5");
  EXPECT_EQ(matched("^(a{0})(a{2,3}?)", "aaaa"), "|aa");
  EXPECT_EQ(matched("(x)|(y)", "y"), "|y") << "a capture that took no part";
  EXPECT_EQ(matched("(?:a|b)+(c)(?<row>d)", "xabacd"), "c|d");
  EXPECT_EQ(matched("(x)(y)(z)", "xyz"), "x|y") << "the first two are kept";
  EXPECT_EQ(matched("()(^)x", "ax"), "no");
  EXPECT_EQ(matched("(?<=_)(\\d)(?=-)-(?!x)(.)", "1-2_3-4"), "3|4") << "looking ahead and behind";
  EXPECT_EQ(matched("(?i)(A)\\1\\b(.)", "aaa-"), "a|-") << "a back reference";
}

TEST(TiledRegexp, SetsOfLetters) {
  EXPECT_EQ(matched("([a-c]+)([^a-c]+)", "xabcdef"), "abc|def");
  EXPECT_EQ(matched("([]a]+)([-b^]+)", "]a]-b^"), "]a]|-b^");
  EXPECT_EQ(matched("([\\d_]+)([\\]\\-]+)", "1_2]-]"), "1_2|]-]");
  EXPECT_EQ(matched("([a\\-c]+)([+--]+)", "a-c+,-"), "a-c|+,-");
  EXPECT_EQ(matched("(\\w+)(\\W+)", "a_9-+"), "a_9|-+");
  EXPECT_EQ(matched("(\\S+)\\s(\\D+)", "1a \tb"), "1a|\tb");
  EXPECT_EQ(matched("(.)(.)", "\na\nbc"), "b|c") << "a dot is no end of a line";
  EXPECT_EQ(matched("(a.c)(\\.)", "aéc."), "aéc|.") << "a letter of several bytes is one";
  EXPECT_EQ(matched("([ä-ü])(€)", "xö€"), "ö|€");
  EXPECT_EQ(matched("(a)(.)", "a\xFF"), "no") << "no letter";
  EXPECT_EQ(matched("(a)(.)",
                    "a\xE2\x82"
                    "ab"),
            "a|b")
      << "after half a letter";
  EXPECT_EQ(matched("([[:digit:]])([\\D])", "1a"), "1|a");
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
  EXPECT_EQ(matched("a{1000}", ""), "no");
  EXPECT_EQ(matched("a{99999}", ""), "is wrong at byte 8: number too big in {} quantifier");
  EXPECT_EQ(matched("((a{60}){60}){60}", ""), "is wrong at byte 18: regular expression is too large");
  EXPECT_EQ(matched(std::string(1'024, 'a'), ""), "no");
  EXPECT_EQ(matched(std::string(1'025, 'a'), ""), "has more than 1024 bytes");
  EXPECT_EQ(matched(std::string(1'000, '('), ""), "is wrong at byte 66: parentheses are too deeply nested");
  const std::string nested = std::string(64, '(') + "a" + std::string(64, ')');
  EXPECT_EQ(matched(nested, "a"), "a|a");
  const std::string name(255, 'a');
  for (const char* pattern : {"(a*)*(a*)*b", "(a|aa)+$()b", "(.*)(.*)(.*)(.*)(.*)(.*)(.*)b", "((a+)+)+b", "(a?){99}()c",
                              "(?=(a+)+b)()", "(a)(?:\\1|a)*b|(?:(a|aa)*){9}c", "(?R)*b()()", "(a(?1)?a?)()b"}) {
    const std::string answer = matched(pattern, name);
    EXPECT_TRUE(answer == "no" || answer.starts_with("takes too long to match: ")) << pattern << ": " << answer;
  }
  EXPECT_EQ(matched("((a+)+)+[bc]", name), "takes too long to match: match limit exceeded");
  EXPECT_EQ(matched("(*LIMIT_MATCH=4000000000)((a+)+)+[bc]", name), "takes too long to match: match limit exceeded")
      << "a pattern may lower the limits only";
}

TEST(TiledRegexp, CountsItsSteps) {
  const auto regexp = Regexp::parse("(a+)+[bc]()");
  ASSERT_TRUE(regexp);
  std::uint64_t steps = 100;
  EXPECT_FALSE(regexp->match("aaaaaaaaaaaaaaaa", steps));
  EXPECT_EQ(steps, 0U);
  steps = 100;
  EXPECT_TRUE(regexp->match("ab", steps)->isThere);
  EXPECT_GT(steps, 80U);
  EXPECT_LT(steps, 99U);
  steps = 100;
  EXPECT_FALSE(regexp->match(std::string(40, 'x'), steps)->isThere);
  EXPECT_LE(steps, 60U) << "a name that is looked at, and not tried";
}

/// Patterns whose repetitions are never of what may be empty, as engines do not agree on these.
rc::Gen<std::string> patterns(int depth) {
  const auto letter = rc::gen::element<std::string>("a", "b", "c", ".", "[ab]", "[^a]", "\\d", "1");
  if (depth == 0) return letter;
  const auto less = rc::gen::lazy([depth] { return patterns(depth - 1); });
  const auto pair = [&](const std::string& between) {
    return rc::gen::map(rc::gen::pair(less, less),
                        [between](const auto& both) { return both.first + between + both.second; });
  };
  const auto repeated = rc::gen::map(
      rc::gen::pair(letter,
                    rc::gen::element<std::string>("*", "+", "?", "*?", "+?", "??", "{2}", "{1,2}", "{0,2}?", "{1,}")),
      [](const auto& both) { return both.first + both.second; });
  const auto either = rc::gen::map(pair("|"), [](const std::string& text) { return "(?:" + text + ")"; });
  return rc::gen::oneOf(letter, pair(""), repeated, either);
}

TEST(TiledRegexp, AgreesWithTheStandardLibrary) {
  const auto law = [](const std::string& first, const std::string& second, const std::string& between,
                      const std::string& text) {
    const std::string pattern = "(" + first + ")" + between + "(" + second + ")";
    std::smatch match;
    const bool matches = std::regex_search(text, match, std::regex(pattern));
    EXPECT_EQ(matched(pattern, text), matches ? match[1].str() + "|" + match[2].str() : "no") << pattern << " " << text;
  };
  const auto text = rc::gen::container<std::string>(rc::gen::element('a', 'b', 'c', '1'));
  test::forAll(2'000, law, patterns(4), patterns(4), rc::gen::element<std::string>("", "", "c", "b*", "^", "$"), text);
}

}  // namespace
}  // namespace lgs::tiled
