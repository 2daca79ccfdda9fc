// iOverlay's JSON and GeoJSON.
#include "oracle/suites/suite.h"

#include <fmt/format.h>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace lgs::oracle {
namespace {

using Json = nlohmann::json;

/// What is wrong with a value, to be caught by the readers.
struct Wrong {
  std::string text;
};

const Json& at(const Json& value, const char* key) {
  static const Json kNone;
  const auto found = value.is_object() ? value.find(key) : value.end();
  return found != value.end() ? *found : kNone;
}

const Json& list(const Json& value, const char* of) {
  if (!value.is_array()) throw Wrong{fmt::format("{} must be a list", of)};
  return value;
}

SuitePart partOf(const Json& rings) {
  SuitePart part;
  for (const Json& ring : list(rings, "a polygon")) {
    part.rings.emplace_back();
    for (const Json& vertex : list(ring, "a ring")) {
      const bool isPoint = vertex.is_array() && vertex.size() >= 2 && vertex[0].is_number() && vertex[1].is_number();
      if (!isPoint) throw Wrong{"a vertex must be a list of two numbers, or more"};
      part.rings.back().push_back({vertex[0].get<double>(), vertex[1].get<double>()});
      if (!std::isfinite(part.rings.back().back().x) || !std::isfinite(part.rings.back().back().y))
        throw Wrong{"a vertex is too far away for a number"};
    }
  }
  return part;
}

// A geometry or a feature. What is no polygon is counted.
void addGeometry(const Json& value, Operand& operand, Suite& suite, int depth = 0) {
  constexpr int kDeep = 8;
  const Json& type = at(value, "type");
  if (type == "Feature" && depth < kDeep) return addGeometry(at(value, "geometry"), operand, suite, depth + 1);
  if (type == "GeometryCollection" && depth < kDeep) {
    for (const Json& part : list(at(value, "geometries"), "'geometries'")) addGeometry(part, operand, suite, depth + 1);
  } else if (type == "Polygon") {
    operand.push_back(partOf(at(value, "coordinates")));
  } else if (type == "MultiPolygon") {
    for (const Json& polygon : list(at(value, "coordinates"), "'coordinates'")) operand.push_back(partOf(polygon));
  } else {
    ++suite.leftOut["geometry of GeoJSON that is no polygon"];
  }
}

void addGeoJson(const std::string& file, const Json& root, std::vector<Operation> operations, Suite& suite) {
  const bool isCollection = at(root, "type") == "FeatureCollection";
  std::vector<Operand> operands;
  std::vector<NamedOperation> named;
  const auto take = [&](const Json& feature) {
    const Json& operation = at(at(feature, "properties"), "operation");
    if (operation.is_string()) {
      named.push_back(operationOf(operation.get<std::string>()));
      if (named.back().operations.empty()) ++suite.leftOut[fmt::format("operation '{}'", operation.get<std::string>())];
      return;
    }
    addGeometry(feature, operands.emplace_back(), suite);
    if (operands.back().empty()) operands.pop_back();
  };
  if (isCollection)
    for (const Json& feature : list(at(root, "features"), "'features'")) take(feature);
  else
    take(root);
  if (operands.empty()) throw Wrong{"there is no polygon in it"};
  if (operands.size() == 1) operations = {Operation::unite};
  if (operations.empty() && named.empty()) operations = kAllOperations;
  suite.add(file, operations, operands);
  for (const auto& [wanted, isSwapped] : named) {
    std::vector<Operand> ordered = operands;
    if (isSwapped && ordered.size() > 1) std::swap(ordered[0], ordered[1]);
    suite.add(file, wanted, ordered);
  }
}

void addIOverlay(const std::string& file, const Json& root, Suite& suite) {
  constexpr std::array kResults{"union", "intersect", "difference", "inverseDifference", "xor"};
  const Json& rule = at(root, "fillRule");
  const bool isRule = rule.is_null() || (rule.is_number_integer() && 0 <= rule && rule <= 3);
  if (!isRule) throw Wrong{"'fillRule' must be 0 (even-odd), 1 (non-zero), 2 (positive) or 3 (negative)"};
  std::vector<Operand> operands;
  for (const char* const paths : {"subjPaths", "clipPaths"}) {
    if (at(root, paths).is_null()) continue;
    operands.push_back({partOf(at(root, paths))});
    operands.back()[0].rule = rule.is_null() ? Filled::evenOdd : static_cast<Filled>(rule.get<int>());
    if (!at(root, paths == std::string_view("subjPaths") ? "subject" : "clip").is_null())
      suite.add(file, {Operation::unite}, {operands.back()});
  }
  bool isNamed = false;
  for (const char* const result : kResults) {
    if (at(root, result).is_null() || operands.size() < 2) continue;
    isNamed = true;
    const NamedOperation named = operationOf(result);
    suite.add(file, named.operations,
              named.isSwapped ? std::vector{operands[1], operands[0]} : std::vector{operands[0], operands[1]});
  }
  if (!isNamed) suite.add(file, kAllOperations, operands);
}

}  // namespace

Read readJson(const std::string& file, std::string_view text, const std::vector<Operation>& operations, Suite& suite) {
  try {
    const Json root = Json::parse(text);
    if (root.is_object() && (root.contains("subjPaths") || root.contains("clipPaths")))
      addIOverlay(file, root, suite);
    else if (at(root, "type").is_string())
      addGeoJson(file, root, operations, suite);
    else
      ++suite.leftOut["file of JSON that is neither GeoJSON nor two operands of iOverlay ('type', 'subjPaths')"];
  } catch (const Json::exception& wrong) {
    return tl::unexpected(fmt::format(" it is no JSON: {}", wrong.what()));
  } catch (const Wrong& wrong) {
    return tl::unexpected(" " + wrong.text);
  }
  return {};
}

}  // namespace lgs::oracle
