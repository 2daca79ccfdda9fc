// WKT and WKB by Boost.Geometry and by hand, and the cases of GEOS and JTS in XML.
#include "oracle/suites/suite.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <pugixml.hpp>
#include <tuple>
#include <utility>

namespace lgs::oracle {
namespace {

namespace bg = boost::geometry;
using Polygon = bg::model::polygon<bg::model::d2::point_xy<double>>;
constexpr std::string_view kCollection = "GEOMETRYCOLLECTION";

/// Why a geometry is not taken.
struct NotTaken {
  std::string why;
};

SuitePart::Vertex vertexOf(double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y)) throw NotTaken{"geometry with a vertex that is no number"};
  return {x, y};
}

Operand partsOf(const bg::model::multi_polygon<Polygon>& polygons) {
  Operand operand;
  for (const Polygon& polygon : polygons) {
    SuitePart& part = operand.emplace_back();
    const auto take = [&](const auto& ring) {
      part.rings.emplace_back();
      for (const auto& p : ring) part.rings.back().push_back(vertexOf(p.x(), p.y()));
    };
    take(polygon.outer());
    std::ranges::for_each(polygon.inners(), take);
  }
  return operand;
}

// Well-known binary as hexadecimal digits: polygons in two dimensions, alone or in collections.
class Binary {
 public:
  explicit Binary(std::string_view digits) : digits_(digits) {}

  Operand geometry(int depth = 0) {
    constexpr std::uint32_t kPolygon = 3, kCollections = 6, kReference = 0x2000'0000;
    isLittle_ = byte() == 1;
    std::uint32_t kind = number<std::uint32_t>();
    if ((kind & kReference) != 0) static_cast<void>(number<std::uint32_t>());
    kind &= ~kReference;
    Operand operand;
    if (kind == kPolygon) {
      operand.emplace_back();
      for (auto rings = number<std::uint32_t>(); rings > 0; --rings) {
        operand[0].rings.emplace_back();
        for (auto points = number<std::uint32_t>(); points > 0; --points) {
          const auto x = number<double>();
          operand[0].rings.back().push_back(vertexOf(x, number<double>()));
        }
      }
    } else if ((kind == kCollections || kind == kCollections + 1) && depth < 8) {
      for (auto parts = number<std::uint32_t>(); parts > 0; --parts)
        for (SuitePart& part : geometry(depth + 1)) operand.push_back(std::move(part));
    } else {
      throw NotTaken{"geometry in WKB that is no polygon in two dimensions"};
    }
    return operand;
  }

 private:
  std::uint8_t byte() {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    if (digits_.size() < 2) throw NotTaken{"geometry in WKB that ends too early"};
    unsigned value = 0;
    for (int k = 0; k < 2; ++k, digits_.remove_prefix(1))
      value = value * 16 + static_cast<unsigned>(kDigits.find(static_cast<char>(std::toupper(digits_[0]))));
    return static_cast<std::uint8_t>(value);
  }

  template <class Number>
  Number number() {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < sizeof(Number); ++k) {
      const std::uint64_t next = byte();
      bits = isLittle_ ? bits | next << (8 * k) : bits << 8 | next;
    }
    if constexpr (sizeof(Number) == sizeof bits) return std::bit_cast<Number>(bits);
    return static_cast<Number>(bits);
  }

  std::string_view digits_;
  bool isLittle_ = false;
};

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool isSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::string tidied(std::string_view text) {
  std::string line;  // one line, one blank between words
  for (const char c : text)
    if (!isSpace(c) || (!line.empty() && line.back() != ' '))
      line += isSpace(c) ? ' ' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  while (line.ends_with(' ') || line.ends_with('\'')) line.pop_back();
  return line;
}

// Where the next geometry begins and ends; at the end of the text, if there is none.
std::pair<std::size_t, std::size_t> nextGeometry(std::string_view upper, std::size_t from) {
  constexpr std::array<std::string_view, 4> kWords{"POLYGON", "LINESTRING", "POINT", kCollection};
  constexpr std::string_view kMany = "MULTI";
  for (;;) {
    std::size_t begin = std::string_view::npos, end = begin;
    for (const std::string_view word : kWords)
      if (const std::size_t at = upper.find(word, from); at < begin) begin = at, end = at + word.size();
    if (begin == std::string_view::npos) return {upper.size(), upper.size()};
    from = end;
    end = std::min(upper.find_first_not_of(" \t\r\nZM", end), upper.size());
    if (upper.substr(0, begin).ends_with(kMany)) begin -= kMany.size();
    if (upper.substr(end).starts_with("EMPTY")) return {begin, end + 5};
    const std::size_t inside = std::min(upper.find_first_not_of("( \t\r\n", end), upper.size() - 1);
    const bool isRemark = isLetter(upper[inside]) && !upper.substr(begin).starts_with(kCollection);
    if (!upper.substr(end).starts_with('(') || isRemark) continue;
    int open = 0;
    do open += upper[end] == '(' ? 1 : upper[end] == ')' ? -1 : 0;
    while (++end < upper.size() && open > 0);
    return {begin, open == 0 ? end : std::string_view::npos};
  }
}

// The parts of a collection, which must all be polygons.
tl::expected<Operand, std::string> collected(std::string_view collection) {
  Operand all;
  std::size_t begin = 0, end = kCollection.size();
  while (std::tie(begin, end) = nextGeometry(collection, end), begin < collection.size()) {
    const std::string_view one = collection.substr(begin, end - begin);
    if (one.starts_with(kCollection)) throw NotTaken{"operand that is a collection of collections"};
    auto part = geometryOf(one);
    if (!part) return part;
    all.insert(all.end(), part->begin(), part->end());
  }
  return all;
}

}  // namespace

tl::expected<Operand, std::string> geometryOf(std::string_view text) {
  std::string line = tidied(text);
  for (const auto& [empty, instead] : {std::pair{", EMPTY", ""}, {",EMPTY", ""}, {"(EMPTY, ", "("}, {"(EMPTY,", "("}})
    for (std::size_t at = 0; (at = line.find(empty)) != std::string::npos;)
      line.replace(at, std::string_view(empty).size(), instead);
  try {
    if (!line.empty() && line.find_first_not_of("0123456789ABCDEF") == std::string::npos)
      return Binary(line).geometry();
    const std::string word = line.substr(0, line.find_first_of(" (0123456789"));
    if (word == kCollection) return collected(line);
    bg::model::multi_polygon<Polygon> polygons;
    if (word == "MULTIPOLYGON")
      bg::read_wkt(line, polygons);
    else if (word == "POLYGON")
      bg::read_wkt(line, polygons.emplace_back());
    else
      return tl::unexpected(fmt::format("operand that is a {}, and no polygon", word));
    return partsOf(polygons);
  } catch (const bg::read_wkt_exception& wrong) {
    return tl::unexpected("operand that is no WKT: " + std::string(wrong.what()).substr(0, 80));
  } catch (const NotTaken& wrong) {
    return tl::unexpected(wrong.why);
  }
}

// A text may be a program: its strings may go on in the next line, and a semicolon ends a list of them.
Read readWkt(const std::string& file, std::string_view text, Suite& suite) {
  std::string upper(text);
  for (char& c : upper)
    c = c == '"' || c == '\\' ? ' ' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::vector<Operand> pair;
  std::size_t line = 1, first = 0, geometries = 0;
  const auto endPair = [&] {
    if (pair.size() == 2)
      suite.add(fmt::format("{}:{}", file, line), kAllOperations, pair);
    else if (geometries != 0)
      ++suite.leftOut["pair of geometries that are not both polygons, or geometry that is alone"];
    pair.clear();
    geometries = 0;
  };
  for (std::size_t at = 0; at < upper.size();) {
    const auto [begin, end] = nextGeometry(upper, at);
    if (begin == upper.size()) break;
    const std::string_view between = std::string_view(upper).substr(at, begin - at);
    if (between.find(';') < between.find('=')) endPair();  // SRID=…; is of a geometry
    line += static_cast<std::size_t>(std::ranges::count(text.substr(first, begin - first), '\n'));
    first = begin;
    if (end == std::string_view::npos) return tl::unexpected(fmt::format("{}: a ( is never closed", line));
    const std::string_view one = std::string_view(upper).substr(begin, end - begin);
    at = end;
    if (one.starts_with("POLYGON") || one.starts_with("MULTIPOLYGON")) {
      auto geometry = geometryOf(one);
      if (!geometry) return tl::unexpected(fmt::format("{}: {}", line, geometry.error()));
      pair.push_back(std::move(*geometry));
    }
    if (++geometries == 2) endPair();
  }
  endPair();
  return {};
}

Read readXml(const std::string& file, std::string_view text, Suite& suite) {
  pugi::xml_document document;
  std::size_t counted = 0, line = 1;  // forwards alone
  const auto lineAt = [&](std::ptrdiff_t offset) {
    for (; static_cast<std::ptrdiff_t>(counted) < offset; ++counted) line += text[counted] == '\n' ? 1 : 0;
    return line;
  };
  if (const auto parsed = document.load_buffer(text.data(), text.size()); !parsed)
    return tl::unexpected(fmt::format("{}: it is no XML: {}", lineAt(parsed.offset), parsed.description()));
  for (const pugi::xpath_node& found : document.select_nodes("//case")) {
    const pugi::xml_node node = found.node();
    const std::string place = fmt::format("{}:{}", file, lineAt(node.offset_debug()));
    std::map<std::string, tl::expected<Operand, std::string>> operands;
    const auto operand = [&](const char* name) {
      return operands.try_emplace(name, geometryOf(node.child(name).text().get())).first->second;
    };
    std::size_t taken = 0;
    for (const pugi::xpath_node& test : node.select_nodes("test/op")) {
      const pugi::xml_node op = test.node();
      const NamedOperation named = operationOf(op.attribute("name").value());
      if (named.operations.empty()) continue;
      std::vector<Operand> wanted;
      ++taken;
      for (const char* const key : {"arg1", "arg2"}) {
        const std::string_view arg = op.attribute(key).value();
        if (key == std::string_view("arg2") && arg.empty()) continue;  // the union of one
        const auto& geometry = operand(arg == "B" || arg == "b" ? "b" : "a");
        if (!geometry) ++suite.leftOut[geometry.error()];
        if (geometry) wanted.push_back(*geometry);
      }
      const bool isWhole = wanted.size() == (op.attribute("arg2").empty() ? 1U : 2U);
      if (isWhole) suite.add(place, named.operations, wanted);
    }
    if (taken == 0) ++suite.leftOut["case of XML without a union, intersection, difference or symdifference"];
  }
  return {};
}

}  // namespace lgs::oracle
