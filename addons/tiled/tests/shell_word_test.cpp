// Names in commands that messages print: a shell must give back what the map says.
#include "maps.h"
#include "oracle/check/shell.h"
#include "proptests/support/command.h"

#include <cctype>

namespace lgs::tiled {
namespace {

TEST(TiledShellWord, IsInQuotesIfItHasToBe) {
  const std::string plain = "azAZ09_-./,:=+@%";
  EXPECT_EQ(shellWord(plain), plain);
  for (int c = 1; c < 256; ++c) {
    const bool isPlain = std::isalnum(c) != 0 || plain.find(static_cast<char>(c)) != std::string::npos;
    const std::string word = "a" + std::string(1, static_cast<char>(c));
    EXPECT_EQ(shellWord(word) == word, isPlain) << c;
  }
  EXPECT_EQ(shellWord(""), "''");
  EXPECT_EQ(shellWord("My boxes"), "'My boxes'");
  EXPECT_EQ(shellWord("it's"), "'it'\\''s'");
  EXPECT_EQ(shellWord("Wände"), "'Wände'");
  EXPECT_EQ(shellWord("a\\b"), "'a\\b'");
  EXPECT_EQ(shellWord("a\n1'\\\x7F"), "$'a\\0121\\'\\\\\\177'");
  EXPECT_EQ(shellWord("\x1B[31m"), "$'\\033[31m'");
}

/// Bash gives back every name. (Other shells know such escapes too, but not every /bin/sh.) test.sh itself runs in
/// bash.
TEST(TiledShellWord, BashGivesItBack) {
  for (const std::string word :
       {"it's \"so\"", "$HOME `x` $(y)", "a\tb\\n'c'", "\x1B]0;x\a", "~", "*", "-x", "\n", "é \n7"}) {
    EXPECT_EQ(test::outcomeOf("bash -c " + oracle::shellWord("printf %s " + shellWord(word))).text, word);
  }
}

TEST(TiledShellWord, IsInTheErrorsThatNameAnOption) {
  const std::string walls = "<objectgroup name=\"Bob's boxes\"/>";
  EXPECT_EQ(refusalOf(mapXml(walls), {.layers = {"Bob's boxes"}}),
            "maps/test.tmx: 'Bob's boxes' is an object layer: --objects 'Bob'\\''s boxes'");
  EXPECT_EQ(refusalOf(mapXml("<objectgroup name='a&#10;b'/>"), {.layers = {"a\nb"}}),
            "maps/test.tmx: 'a b' is an object layer: --objects $'a\\012b'");
}

TEST(TiledShellWord, IsInTheReport) {
  const std::string text = toText(
      mustImport("<objectgroup name='My &#27;boxes'><object id='1' width='9' height='9'/></objectgroup>").report);
  EXPECT_THAT(text, HasSubstr("  or: --objects $'My \\033boxes'  (1 polygon: object layer My  boxes, 1 object: nothing "
                              "says what it is)\n"));
}

}  // namespace
}  // namespace lgs::tiled
