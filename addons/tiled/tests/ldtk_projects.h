// Small LDtk projects for the tests.
#pragma once

#include "maps.h"

namespace lgs::tiled {

/// A project of 8 px cells, whose IntGrid layers are "Solid" (values dirt and ice, and one without a name) and "Fine".
inline std::string project(const std::string& levels, const std::string& layout = "Free",
                           const std::string& more = "") {
  return R"({"__header__":{"fileType":"LDtk Project JSON", "app":"LDtk"}, "jsonVersion":"1.5.3", "defaultGridSize":8,
    "worldLayout":")" +
         layout + R"(", "defs":{"layers":[
      {"uid":1, "type":"IntGrid", "identifier":"Solid", "parallaxFactorX":0, "intGridValues":[
        {"value":2, "identifier":"ice"}, {"value":1, "identifier":"dirt"}, {"value":3, "identifier":null}]},
      {"uid":2, "type":"IntGrid", "identifier":"Other", "parallaxFactorX":0.5, "intGridValues":[
        {"value":2, "identifier":"dirt"}]},
      {"uid":3, "type":"Entities", "identifier":"Things"}],
      "entities":[{"uid":11, "identifier":"Boulder", "renderMode":"Ellipse"},
                  {"uid":12, "identifier":"Wall", "renderMode":"Rectangle"}]},)" +
         more + "\"levels\":[" + levels + "]}";
}

inline std::string level(const std::string& name, int x, int y, const std::string& layers,
                         const std::string& more = "") {
  return "{\"identifier\":\"" + name + "\", \"worldX\":" + std::to_string(x) + ", \"worldY\":" + std::to_string(y) +
         ", \"worldDepth\":0, \"pxWid\":24, \"pxHei\":16, " + more + "\"layerInstances\":[" + layers + "]}";
}

/// An IntGrid layer of 3×2 cells.
inline std::string grid(const std::string& csv, const std::string& name = "Solid", int uid = 1,
                        const std::string& more = "") {
  return "{\"__identifier\":\"" + name + "\", \"__type\":\"IntGrid\", \"__cWid\":3, \"__cHei\":2, " +
         (more.find("__gridSize") == std::string::npos ? "\"__gridSize\":8, " : "") + more +
         "\"layerDefUid\":" + std::to_string(uid) + ", \"visible\":true, \"intGridCsv\":[" + csv +
         "], \"entityInstances\":[]}";
}

inline std::string entity(const std::string& name, int uid, const std::string& place, const std::string& more = "") {
  return "{\"__identifier\":\"" + name + "\", \"defUid\":" + std::to_string(uid) + ", " + place + more +
         ", \"iid\":\"x\", \"fieldInstances\":[{\"__identifier\":\"heavy\", \"__value\":true}]}";
}

inline std::string things(const std::string& entities, const std::string& name = "Things") {
  return "{\"__identifier\":\"" + name +
         "\", \"__type\":\"Entities\", \"__cWid\":3, \"__cHei\":2, \"__gridSize\":8, \"layerDefUid\":3, "
         "\"__pxTotalOffsetX\":0, \"__pxTotalOffsetY\":8, \"intGridCsv\":[], \"entityInstances\":[" +
         entities + "]}";
}

inline ImportedMap mustImportProject(const std::string& text, const Options& options = {}, Files files = {}) {
  files["maps/test.tmx"] = text;
  return mustImportWorld(files, options);
}

}  // namespace lgs::tiled
