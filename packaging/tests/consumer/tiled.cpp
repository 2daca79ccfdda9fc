// The smallest game with Tiled maps: a map of two tiles, read from memory, becomes a world.
#include <lgs/tiled/import.h>
#include <lgs/world.h>
#include <cstdio>
#include <string>

namespace {

const char* const kMap = R"(<?xml version="1.0"?>
<map version="1.10" orientation="orthogonal" width="2" height="1" tilewidth="16" tileheight="16" infinite="0">
 <tileset firstgid="1" name="one" tilewidth="16" tileheight="16" tilecount="1" columns="1">
  <tile id="0"><objectgroup><object id="1" x="0" y="0" width="16" height="16"/></objectgroup></tile>
 </tileset>
 <layer id="1" name="ground" width="2" height="1"><data encoding="csv">1,1</data></layer>
</map>
)";

}  // namespace

int main() {
  const auto map = lgs::tiled::importMap(
      "memory.tmx", {}, [](const std::string&) -> tl::expected<std::string, std::string> { return std::string(kMap); });
  if (!map) {
    std::fprintf(stderr, "consumer: %s\n", lgs::tiled::message(map.error()).c_str());
    return 1;
  }
  lgs::World world;
  for (const lgs::tiled::MapPolygon& placement : map->placements) {
    if (!world.add(placement.cell, map->shapes[placement.shape], placement.block)) return 1;
  }
  const std::size_t segments = world.commit().added.size();
  std::printf("consumer: %zu polygons, %zu segments\n", map->placements.size(), segments);
  return map->placements.size() == 2 && segments == 6 ? 0 : 1;
}
