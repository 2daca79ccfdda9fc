// Suites that others wrote for unions of polygons: files with two operands or more and an operation, in four formats.
//
//   Clipper2's text     blocks of CAPTION, CLIPTYPE, FILLRULE, SUBJECTS and CLIPS, as in its Polygons.txt
//   iOverlay's JSON     subjPaths, clipPaths, fillRule, and the results of the operations
//   GeoJSON             a collection of features: the operands; those with a property `operation`, and files union,
//                       intersection, difference, xor and all .geojson beside an args.geojson, name the operations
//   WKT, XML            <case>s of GEOS and JTS, in WKT or WKB as hexadecimal digits; or a text with WKT, in pairs, be
//                       it a program, as Boost's overlay_cases.hpp
//
// Where no operation is named all four are meant. The answers of a suite are not read: what is right is up to the
// references. Files are not trusted. What is not read is counted, and never silently left out.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::oracle {

enum class Filled { evenOdd, nonZero, positive, negative };

/// Rings by a rule, in coordinates of the suite.
struct SuitePart {
  struct Vertex {
    double x = 0, y = 0;
    friend bool operator==(const Vertex&, const Vertex&) = default;
  };
  std::vector<std::vector<Vertex>> rings;
  Filled rule = Filled::evenOdd;
};

/// Its parts, united.
using Operand = std::vector<SuitePart>;

enum class Operation { unite, intersect, subtract, exclude };
inline constexpr const char* kOperations[] = {"union", "intersection", "difference", "xor"};

struct SuiteCase {
  std::string name;  ///< "FILE:LINE: union", or the like
  Operation operation{};
  std::vector<Operand> operands;  ///< of a difference the first is what the others are taken from
};

struct Suite {
  std::size_t files = 0;
  std::vector<SuiteCase> cases;
  std::map<std::string, std::size_t> leftOut;  ///< what is not read, in words, and how often

  std::size_t seen() const;  ///< cases and what is left out
  void add(const std::string& place, const std::vector<Operation>& operations, const std::vector<Operand>& operands);
};

/// Reads a file, or of a folder all files whose names end in txt, json, geojson, wkt or xml. An error is a whole
/// complaint, "FILE:LINE: …"; in a folder what is wrong with a file is left out.
tl::expected<Suite, std::string> readSuite(const std::string& path);

/// The operation of such a name, whatever the format: "intersect", "symdifference", "diff_ba"; the latter is a
/// difference the other way around.
struct NamedOperation {
  std::vector<Operation> operations;  ///< none: it is no such name
  bool isSwapped = false;
};
NamedOperation operationOf(std::string_view name);
inline const std::vector<Operation> kAllOperations{Operation::unite, Operation::intersect, Operation::subtract,
                                                   Operation::exclude};

/// One reader each: the cases of a text, which are added to a suite; or what is wrong, "LINE: …".
using Read = tl::expected<void, std::string>;
Read readClipper(const std::string& file, std::string_view text, Suite& suite);
Read readJson(const std::string& file, std::string_view text, const std::vector<Operation>& operations, Suite& suite);
Read readXml(const std::string& file, std::string_view text, Suite& suite);
Read readWkt(const std::string& file, std::string_view text, Suite& suite);

/// A polygon or some, in WKT or WKB; or why it is none.
tl::expected<Operand, std::string> geometryOf(std::string_view text);

}  // namespace lgs::oracle
