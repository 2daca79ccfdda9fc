// Cost of an import under attack: for maps that are made to be as costly for their size as can be, what the importer,
// the brushes and the engine do grows with the bytes of the map, beyond the limits of Options.
#include "visits.h"

#include <lgs/tiled/import.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace lgs::cost_test {
namespace {

using tiled::Options;

/// With the least base, so that what is counted is what the bytes of a map allow for.
Options strict() {
  const Options options{.blockFrom = tiled::BlockFrom::tileClass, .maxObjectCells = 1 << 12, .maxWork = 1 << 20};
  return options;
}

/// What the import of a map does for each byte of it. It need not be accepted.
std::uint64_t costPerByte(const std::string& map) {
  const auto reader = [&](const std::string&) -> tl::expected<std::string, std::string> { return map; };
  return visitsOf([&] {
           const auto done = tiled::importMap("a.tmx", strict(), reader);
           if (done) static_cast<void>(tiled::toText(done->report));
         }) /
         map.size();
}

std::string mapOf(const std::string& content, int side) {
  const std::string sides = " width='" + std::to_string(side) + "' height='" + std::to_string(side) + "'";
  return "<map orientation='orthogonal' tilewidth='32' tileheight='32'" + sides + ">" + content + "</map>";
}

std::string times(int count, const std::function<std::string(int)>& make) {
  std::string all;
  for (int k = 0; k < count; ++k) all += make(k);
  return all;
}

std::string walls(const std::string& objects) { return "<objectgroup name='walls'>" + objects + "</objectgroup>"; }

std::string set(const std::string& tiles) {
  return "<tileset firstgid='1' name='s' tilewidth='32' tileheight='32'>" + tiles + "</tileset>";
}

std::string tile(int id, const std::string& objects) {
  return "<tile id='" + std::to_string(id) + "'><objectgroup>" + objects + "</objectgroup></tile>";
}

std::string layer(int side, const std::string& csv, const std::string& attributes = "") {
  const std::string sides = " width='" + std::to_string(side) + "' height='" + std::to_string(side) + "'";
  return "<layer name='a'" + sides + attributes + "><data encoding='csv'>" + csv + "</data></layer>";
}

/// A layer of one tile.
std::string named(const std::string& name, int k) {
  return "<layer name='" + name + " " + std::to_string(k) +
         "' width='1' height='1'><data encoding='csv'>1</data></layer>";
}

/// A small triangle somewhere in the first tile.
std::string triangle(int k) {
  const auto at = [k](int factor) { return std::to_string(k * factor % 2'800 / 100.0).substr(0, 5); };
  return "<object id='" + std::to_string(k) + "' x='" + at(1'237) + "' y='" + at(1'791) +
         "'><polygon points='0,0 3.1,0 0,2.7'/></object>";
}

struct Attack {
  const char* name;
  std::function<std::string(int size)> map;
  int size;
};

const Attack kAttacks[] = {
    {"small triangles in one cell", [](int n) { return mapOf(walls(times(n, triangle)), 4); }, 400},
    {"one object of many cells",
     [](int n) { return mapOf(walls("<object id='1' width='" + std::to_string(n * 32) + "' height='131072'/>"), 4); },
     4'096},
    {"long slivers across each other",
     [](int n) {
       return mapOf(walls(times(n,
                                [](int k) {
                                  const std::string y = std::to_string(k * 97 % 1'000 - 500);
                                  return "<object id='1' x='0' y='500'><polygon points='0,0 3000," + y + " 3000," + y +
                                         ".5'/></object>";
                                })),
                    4);
     },
     200},
    {"rings of many corners in one cell",
     [](int n) {
       const auto ring = [](int k) {
         std::string points;
         for (int i = 0; i < 1'000; ++i) {
           const double turn = i * 0.00628 + k * 0.01, radius = i % 2 == 0 ? 15 : 12;
           points += std::to_string(16 + radius * std::cos(turn)).substr(0, 5) + "," +
                     std::to_string(16 + radius * std::sin(turn)).substr(0, 5) + " ";
         }
         return "<object id='1' x='0' y='0'><polygon points='" + points + "'/></object>";
       };
       return mapOf(walls(times(n, ring)), 4);
     },
     8},
    {"many tile objects of a tile with many shapes",
     [](int n) {
       const auto object = [](int k) {
         return "<object id='1' gid='1' x='" + std::to_string(k * 64) + "' y='0' width='32' height='32'/>";
       };
       return mapOf(set(tile(0, times(n, triangle))) + walls(times(n, object)), 4);
     },
     300},
    {"many offsets of a tile with many shapes",
     [](int n) {
       const auto moved = [](int k) { return layer(1, "1", " offsetx='" + std::to_string(k) + ".01'"); };
       return mapOf(set(tile(0, times(n, triangle))) + times(n, moved), 1);
     },
     300},
    {"many combinations of tiles",
     [](int n) {
       const std::string tiles =
           times(64, [](int k) { return tile(k, times(10, [k](int j) { return triangle(31 * k + j); })); });
       const auto one = [n](int l) {
         return layer(n, times(n * n, [l](int k) {
                        return (k == 0 ? "" : ",") + std::to_string(1 + (k * k + 7 * k * l + l) % 61);
                      }));
       };
       return mapOf(set(tiles) + times(4, one), n);
     },
     40},
    {"many classes",
     [](int n) {
       return mapOf(walls(times(n,
                                [](int k) {
                                  return "<object id='" + std::to_string(k) + "' type='c" + std::to_string(k) +
                                         "' x='" + std::to_string(k * 32) + "' width='32' height='9'/>";
                                })),
                    1);
     },
     8'000},
    {"a tile whose properties all say solid, in many layers",
     [](int n) {
       const auto property = [](int k) { return "<property name='solid" + std::to_string(k) + "' value='1'/>"; };
       const std::string tile = "<tile id='0'><properties>" + times(n, property) + "</properties></tile>";
       const auto one = [](int k) { return "<group name='" + std::to_string(k) + "'>" + layer(1, "1") + "</group>"; };
       return mapOf(set(tile) + times(n, one), 1);
     },
     400},
    {"many layers that say solid",
     [](int n) {
       return mapOf(set("") + times(n,
                                    [](int k) {
                                      const std::string name = "<layer name='solid " + std::to_string(k) + "'";
                                      return name + " width='1' height='1'><data encoding='csv'>1</data></layer>";
                                    }),
                    1);
     },
     1'000},
    {"values of an LDtk project that all have one name",
     [](int n) {
       std::string values, used;
       for (int k = 1; k <= n; ++k) {
         values += (k == 1 ? "" : ",") + ("{\"value\":" + std::to_string(k)) + ",\"identifier\":\"x\"}";
         used += (k == 1 ? "" : ",") + std::to_string(k);
       }
       const std::string number = std::to_string(n);
       return R"({"jsonVersion":"1.5.3","defaultGridSize":8,"worldLayout":"Free","defs":{"layers":[{"uid":1,)"
              R"("type":"IntGrid","identifier":"g","intGridValues":[)" +
              values +
              R"(]}],"entities":[]},"levels":[{)"
              R"("identifier":"A","worldX":0,"worldY":0,"pxWid":8,"pxHei":8,"layerInstances":[{"__identifier":"g",)"
              R"("__type":"IntGrid","__cWid":)" +
              number +
              R"(,"__cHei":1,"__gridSize":8,"layerDefUid":1,)"
              R"("visible":true,"intGridCsv":[)" +
              used + "]}]}]}";
     },
     1'000},
};

/// The most that was counted is 2,100 blocks of code a byte, for rings of many corners; a byte allows for kWorkPerByte
/// steps. The base of strict() is spread over the bytes of the map.
TEST(Cost, OfAnImportGrowsWithTheBytesOfTheMap) {
  constexpr std::uint64_t kBlocksPerStep = 3;
  for (const Attack& attack : kAttacks) {
    for (const int size : {attack.size, 4 * attack.size}) {
      const std::string map = attack.map(size);
      const std::uint64_t steps = tiled::kWorkPerByte + strict().maxWork / map.size();
      EXPECT_LT(costPerByte(map), kBlocksPerStep * steps) << attack.name << ", " << map.size() << " bytes";
    }
  }
}

/// Maps of many layers: what each says is weighed against the others.
const Attack kManyLayers[] = {
    {"grounds", [](int n) { return mapOf(set("") + times(n, [](int k) { return named("ground", k); }), 1); }, 250},
    {"collisions of shapes",
     [](int n) { return mapOf(set(tile(0, triangle(1))) + times(n, [](int k) { return named("collision", k); }), 1); },
     250},
    {"others beside a collision",
     [](int n) { return mapOf(set("") + named("collision", 0) + times(n, [](int k) { return named("x", k); }), 1); },
     250},
    {"bricks with pictures beside layers of tiles",
     [](int n) {
       const auto both = [](int k) {
         const std::string object = "<object id='1' gid='1' width='32' height='32'/></objectgroup>";
         return named("x", k) + "<objectgroup name='brick " + std::to_string(k) + "'>" + object;
       };
       return mapOf(set("") + times(n, both), 1);
     },
     250},
};

TEST(Cost, OfAnImportIsTheSameForEachByteHoweverManyLayersThereAre) {
  for (const Attack& attack : kManyLayers)
    EXPECT_LT(costPerByte(attack.map(16 * attack.size)), 2 * costPerByte(attack.map(attack.size))) << attack.name;
}

}  // namespace
}  // namespace lgs::cost_test
