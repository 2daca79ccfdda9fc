// Reals in files: the nearest double, however they are written, and with any standard library.
#include "addons/tiled/src/xml.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <random>
#include <string>

namespace lgs::tiled {
namespace {

/// What the importer reads from `<map x='…'/>`; nothing if that is an error.
std::optional<double> read(const std::string& text) {
  std::optional<ImportError> error;
  const FileReader reader = [&](const std::string&) -> tl::expected<std::string, std::string> {
    return "<map x='" + text + "'/>";
  };
  const XmlFile file("test.tmx", reader, error, false);
  const double value = file.real(file.root(), "x");
  return error ? std::nullopt : std::optional(value);
}

std::string shortest(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

TEST(TiledNumbers, EveryDoubleComesBackBitByBit) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20'000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const auto back = read(shortest(value));
    ASSERT_TRUE(back) << shortest(value);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value)) << shortest(value);
  }
}

TEST(TiledNumbers, HalfwayCasesAreRoundedToEven) {
  EXPECT_EQ(read("9007199254740993"), 9007199254740992.0);  // 2^53 + 1
  EXPECT_EQ(read("9007199254740993.0000000000000000000000000000001"), 9007199254740994.0);
  EXPECT_EQ(read("0.1"), 0.1);
  EXPECT_EQ(read("4.9e-324"), 4.9e-324);
  EXPECT_EQ(read("1e-999"), 0.0);
}

TEST(TiledNumbers, HowTheyMayBeWritten) {
  EXPECT_EQ(read(" +1.5e1 "), 15.0);
  EXPECT_EQ(read(".5"), 0.5);
  EXPECT_EQ(read("5."), 5.0);
  for (const char* wrong : {"", " ", "+", "++1", "1,5", "0x10", "1e", "1 2", "1.5px", "inf", "nan", "1e999"})
    EXPECT_EQ(read(wrong), std::nullopt) << wrong;
}

}  // namespace
}  // namespace lgs::tiled
