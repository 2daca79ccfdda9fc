#include "oracle/trace/coordinate.h"

#include <fmt/format.h>
#include <lgs/lattice.h>
#include <boost/multiprecision/cpp_int.hpp>
#include <charconv>
#include <numeric>

namespace lgs::oracle {
namespace {

using boost::multiprecision::cpp_int;

constexpr std::size_t kMaxLength = 1'000;
constexpr int kMaxExponent = 1'000;
constexpr std::int64_t kMaxLocal = INT32_MAX;  // whether they are in the cell is not asked here
constexpr std::int64_t kMaxWorld = std::int64_t{2} * kMaxCell * kUnitsPerCell;

bool allDigits(std::string_view s) { return !s.empty() && s.find_first_not_of("0123456789") == std::string_view::npos; }

// cpp_int would read a leading 0 as octal.
cpp_int toInteger(std::string_view digits) {
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits.empty() ? cpp_int(0) : cpp_int(std::string(digits));
}

tl::unexpected<std::string> bad(std::string text) { return tl::unexpected(std::move(text)); }

struct Ratio {
  cpp_int numerator;
  cpp_int denominator;
};

tl::expected<Ratio, std::string> parseFraction(std::string_view word, std::size_t slash) {
  const std::string_view above = word.substr(0, slash);
  const std::string_view below = word.substr(slash + 1);
  if (!allDigits(above) || !allDigits(below)) {
    return bad("a fraction is two integers, like 1/3 or -1/3");
  }
  Ratio ratio{toInteger(above), toInteger(below)};
  if (ratio.denominator == 0) return bad("division by zero");
  return ratio;
}

tl::expected<Ratio, std::string> parseDecimal(std::string_view word) {
  int exponent = 0;
  if (const std::size_t e = word.find_first_of("eE"); e != std::string_view::npos) {
    std::string_view power = word.substr(e + 1);
    if (power.starts_with('+')) power.remove_prefix(1);
    const auto [end, status] = std::from_chars(power.data(), power.data() + power.size(), exponent);
    const bool digits = allDigits(power.starts_with('-') ? power.substr(1) : power);
    if (!digits) return bad("not a number");
    if (status != std::errc() || end != power.data() + power.size() || std::abs(exponent) > kMaxExponent) {
      return bad(fmt::format("the exponent is beyond {}", kMaxExponent));
    }
    word = word.substr(0, e);
  }
  std::string digits(word);
  if (const std::size_t dot = word.find('.'); dot != std::string_view::npos) {
    exponent -= static_cast<int>(word.size() - dot - 1);
    digits.erase(dot, 1);
  }
  if (!allDigits(digits)) return bad("not a number");
  Ratio ratio{toInteger(digits), 1};
  const cpp_int power = pow(cpp_int(10), static_cast<unsigned>(std::abs(exponent)));
  (exponent < 0 ? ratio.denominator : ratio.numerator) *= power;
  return ratio;
}

tl::expected<std::int64_t, std::string> parse(std::string_view word, std::int64_t most, const char* tooFar) {
  if (word.size() > kMaxLength) return bad(fmt::format("a number of more than {} characters", kMaxLength));
  const bool negative = word.starts_with('-');
  if (negative) word.remove_prefix(1);
  const std::size_t slash = word.find('/');
  const auto ratio = slash == std::string_view::npos ? parseDecimal(word) : parseFraction(word, slash);
  if (!ratio) return bad(ratio.error());
  const auto& [numerator, denominator] = *ratio;
  // floor(v + 1/2) of the magnitude: nearest, halves away from zero.
  const cpp_int units = (numerator * (2 * kUnitsPerCell) + denominator) / (denominator * 2);
  if (units > most + (negative ? 1 : 0)) return bad(tooFar);
  const auto magnitude = static_cast<std::int64_t>(units);
  return negative ? -magnitude : magnitude;
}

}  // namespace

tl::expected<std::int32_t, std::string> parseCoordinate(std::string_view word) {
  return parse(word, kMaxLocal, "far outside the cell, which is 0 to 1 on both axes").map([](std::int64_t units) {
    return static_cast<std::int32_t>(units);
  });
}

tl::expected<std::int64_t, std::string> parseWorldCoordinate(std::string_view word) {
  return parse(word, kMaxWorld, "far outside of all cells");
}

std::string printCoordinate(std::int64_t units) {
  if (units % kUnitsPerCell == 0) return std::to_string(units / kUnitsPerCell);  // most are corners of cells
  const std::int64_t divisor = std::gcd(units, std::int64_t{kUnitsPerCell});
  const std::int64_t numerator = units / divisor;
  const std::int64_t denominator = kUnitsPerCell / divisor;
  constexpr std::int64_t kFourPlaces = 16;  // 1/16 = 0.0625
  if (denominator > kFourPlaces) return fmt::format("{}/{}", numerator, denominator);
  const std::int64_t tenThousandths = std::abs(numerator * (10'000 / denominator));
  std::string text = fmt::format("{}{}.{:04}", units < 0 ? "-" : "", tenThousandths / 10'000, tenThousandths % 10'000);
  text.erase(text.find_last_not_of('0') + 1);
  return text;
}

void printDecimal(std::int64_t units, std::string& text) {
  const std::int64_t magnitude = std::abs(units);
  if (units < 0) text += '-';
  text += fmt::format("{}", magnitude / kUnitsPerCell);
  if (magnitude % kUnitsPerCell == 0) return;
  constexpr std::int64_t kUnit = 152'587'890'625;  // 10^16 / 65,536
  text += fmt::format(".{:016}", magnitude % kUnitsPerCell * kUnit);
  text.erase(text.find_last_not_of('0') + 1);
}

}  // namespace lgs::oracle
