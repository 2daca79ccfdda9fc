// Coordinates as text: exact rounding on the way in, exact values on the way out.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace lgs::oracle {

/// Lattice units of a decimal or a fraction given in cells, rounded to the nearest, halves away from zero; or what is
/// wrong with the word.
tl::expected<std::int32_t, std::string> parseCoordinate(std::string_view word);

/// The same of a coordinate of the world. It may lie somewhat beyond the last cell.
tl::expected<std::int64_t, std::string> parseWorldCoordinate(std::string_view word);

/// The exact value in cells: a decimal of up to four places, else a fraction in lowest terms.
std::string printCoordinate(std::int64_t units);

/// Appends the exact value in cells as a decimal, of up to sixteen places.
void printDecimal(std::int64_t units, std::string& text);

}  // namespace lgs::oracle
