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
  const auto captures = regexp->match(text);
  return captures ? (*captures)[0] + "|" + (*captures)[1] : "no";
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
  EXPECT_EQ(matched("(x{)(},{,2})", "x{},{,2}"), "x{|},{,2}") << "such braces are letters";
  EXPECT_EQ(matched("(x)|(y)", "y"), "|y") << "a capture that took no part";
  EXPECT_EQ(matched("(?:a|b)+(c)(?<row>d)", "xabacd"), "c|d");
  EXPECT_EQ(matched("(x)(y)(z)", "xyz"), "x|y") << "the first two are kept";
  EXPECT_EQ(matched("()(^)x", "ax"), "no");
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
  EXPECT_EQ(matched("(a)(.)", "a\xFF"), "a|\xFF");
  EXPECT_EQ(matched("(a)(.)", "a\xE2\x82"), "a|\xE2") << "half a letter";
}

TEST(TiledRegexp, SaysWhatIsWrong) {
  EXPECT_EQ(matched("(\\d+", ""), "has a '(' without its ')'");
  EXPECT_EQ(matched("a)b", ""), "has a ')' without its '('");
  EXPECT_EQ(matched("[a-", ""), "has a '[' without its ']'");
  EXPECT_EQ(matched("[]", ""), "has a '[' without its ']'");
  EXPECT_EQ(matched("[", ""), "has a '[' without its ']'");
  EXPECT_EQ(matched("[b-a]", ""), "has a set with a wrong range");
  EXPECT_EQ(matched("[a-\\d]", ""), "has a set with a wrong range");
  EXPECT_EQ(matched("[[:digit:]]", ""), "has '[:', which is not supported");
  EXPECT_EQ(matched("[\\D]", ""), "has \\D, \\W or \\S in a set, which is not supported");
  EXPECT_EQ(matched("a\\", ""), "ends with a backslash");
  EXPECT_EQ(matched("[\\", ""), "ends with a backslash");
  EXPECT_EQ(matched("\\b", ""), "has '\\b', which is not supported");
  EXPECT_EQ(matched("(a)\\1", ""), "has '\\1', which is not supported");
  EXPECT_EQ(matched("*a", ""), "has a repetition of nothing");
  EXPECT_EQ(matched("a|+", ""), "has a repetition of nothing");
  EXPECT_EQ(matched("a**", ""), "has a repetition of a repetition");
  EXPECT_EQ(matched("a*+", ""), "has a repetition of a repetition");
  EXPECT_EQ(matched("a{2}{3}", ""), "has a repetition of a repetition");
  EXPECT_EQ(matched("a{3,2}", ""), "has a repetition whose numbers are the wrong way round");
  const std::string group = "has a group that begins with '(?', which is not supported, except (?:…) and (?<name>…)";
  for (const char* pattern : {"(?=a)", "(?!a)", "(?<=a)", "(?<!a)", "(?i)a", "(?"}) {
    EXPECT_EQ(matched(pattern, ""), group) << pattern;
  }
  EXPECT_EQ(matched("(?<a", ""), "has a '(' without its ')'");
}

TEST(TiledRegexp, IsLimited) {
  EXPECT_EQ(matched("a{1000}", ""), "no");
  EXPECT_EQ(matched("a{5000}", ""), "is too long");
  EXPECT_EQ(matched("a{99999999999999999999}", ""), "is too long");
  EXPECT_EQ(matched("((a{60}){60}){60}", ""), "is too long");
  EXPECT_EQ(matched(std::string(5'000, 'a'), ""), "is too long");
  EXPECT_EQ(matched(std::string(100'000, '('), ""), "has groups that are nested too deeply");
  const std::string nested = std::string(64, '(') + "a" + std::string(64, ')');
  EXPECT_EQ(matched(nested, "a"), "a|a");
  EXPECT_EQ(matched("(a*)*(a*)*b", std::string(2'000, 'a')), "no") << "in good time";
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
