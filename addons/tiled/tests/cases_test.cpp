// Fifteen ways in which a stranger's map was refused, or taken wrongly or in part without a word, each as the smallest
// map that shows it; and what is meant.
#include "ldtk_projects.h"
#include "maps.h"
#include "proptests/support/command.h"

namespace lgs::tiled {
namespace {

/// Tiles of 16 px without shapes; `content` stands in the tileset.
std::string plainMap(const std::string& layers, const std::string& content = "") {
  return "<map orientation='orthogonal' width='4' height='3' tilewidth='16' tileheight='16'>"
         "<tileset firstgid='1' name='t' tilewidth='16' tileheight='16'>" +
         content + "</tileset>" + layers + "</map>";
}

/// A tile layer of four columns, row by row: "..a./bbbb".
std::string rows(const std::string& name, const std::string& picture, const std::string& properties = "") {
  std::string csv;
  for (const char c : picture)
    if (c != '/') csv += (csv.empty() ? "" : ",") + std::to_string(c == '.' ? 0 : c - 'a' + 1);
  const auto height = 1 + std::count(picture.begin(), picture.end(), '/');
  return fmt::format("<layer name='{}' width='4' height='{}'>{}<data encoding='csv'>{}</data></layer>", name, height,
                     properties, csv);
}

std::string drawn(const std::string& name, const std::string& objects) {
  return "<objectgroup name='" + name + "'>" + objects + "</objectgroup>";
}

std::string box(int column, int row, int width, const std::string& words = "") {
  return fmt::format("<object id='1' {} x='{}' y='{}' width='{}' height='16'/>", words, 16 * column, 16 * row,
                     16 * width);
}

std::string tile(int id, const std::string& content) { return fmt::format("<tile id='{}'>{}</tile>", id, content); }

const std::string kLower = "<objectgroup><object id='1' y='8' width='16' height='8'/></objectgroup>";
const std::string kYes = property("collides", "true");

struct MapCase {
  const char* name;
  std::string text;
  std::size_t polygons;  ///< 0: nothing is taken, and something is offered
  const char* said;      ///< in the first two lines
};

const std::string kSolid = property("solid", "true");

std::vector<MapCase> mapCases() {
  const std::string shaped = tile(1, kLower), bricks = "<object gid='1' x='0' y='16' width='16' height='16'/>";
  const std::string lines =
      "<object id='1' x='16' y='16'><polyline points='0,0 32,0'/></object>"
      "<object id='2' x='48' y='16'><polyline points='0,0 0,32'/></object>";
  return {
      {"3: a property of a layer and of tiles",
       plainMap(rows("wall", "aaaa") + rows("door", "..../.b..", kYes), tile(0, kYes) + tile(1, kYes)), 5,
       "collides (5 tiles)"},
      {"4: decoration beside a background that is the ground",
       plainMap(rows("bg", "..../aa.a/aa.a") + rows("objects", ".b..")), 0, "--layer objects --solid"},
      {"5: no destructible terrain", plainMap(rows("terrain", ".aa.") + rows("terrain_no_destructible", "..../a..a")),
       4, "terrain_no_destructible"},
      {"6: bricks with pictures", plainMap(drawn("brick_layer", bricks + bricks)), 0,
       "--solid-if layer=brick_layer --objects brick_layer  (1 polygon"},
      {"6: the same with a layer of tiles", plainMap(rows("sky", "bbbb/bbbb/bbbb") + drawn("brick_layer", bricks)), 0,
       "--solid-if layer=brick_layer --objects brick_layer  (1 polygon"},
      {"9: shapes that are deadly",
       plainMap(rows("GroundLayer", "..../aaa.") + rows("Flames", ".b.."),
                tile(0, "<objectgroup>" + box(0, 0, 1) + "</objectgroup>") +
                    tile(1, "<objectgroup>" + box(0, 0, 1, "name='Deadly'") + "</objectgroup>")),
       3, "left out as deadly or passable: Deadly (1)"},
      {"9: tiles that are deadly", plainMap(rows("Ground", "..b./aaaa"), "<tile id='1' class='spikes'/>"), 4,
       "spikes (1)"},
      {"9: tiles that are not solid", plainMap(rows("Ground", "..b./aaaa"), tile(1, property("solid", "false"))), 4,
       "solid=false (1)"},
      {"9: objects that are deadly", plainMap(drawn("Collision", box(0, 1, 3) + box(0, 0, 1, "name='Trigger 1'"))), 3,
       "Trigger 1 (1)"},
      {"9: layers that are deadly",
       plainMap(rows("Ground", "..../aaaa") + rows("Hazards", ".b../...."), tile(0, kLower) + tile(1, kLower)), 4,
       "Hazards (1)"},
      {"10: a layer that is two thirds full", plainMap(rows("Tile Layer 1", "a..a/a..a/aaaa")), 0,
       "--layer 'Tile Layer 1' --solid"},
      {"11: a letter is wrong",
       plainMap(rows("Background", "bbbb/bbbb") + rows("Obsticles", "..../aaaa") + rows("PhysicsObjects", ".c..")), 4,
       "Obsticles: its name says 'obstacle'"},
      {"12: boxes before pictures",
       plainMap(rows("tiles", "bbbb") + drawn("scenery", bricks) + drawn("geom", box(0, 2, 4)), tile(0, kLower)), 4,
       "geom: its name says 'geom'"},
      {"12: boxes without a word before pictures",
       plainMap(drawn("scenery", bricks) + drawn("stuff", box(0, 2, 4)), tile(0, kLower)), 0,
       "\n  or: --objects stuff"},
      {"13: polylines beside the ground", plainMap(rows("ground", "aaaa/a..a/a..a") + drawn("collision", lines)), 8,
       "IN PART: object layer collision, of which 2 open polylines"},
      {"16a: three plain tiles and one with a shape", plainMap(rows("L", ".aaa/.b..", kSolid), shaped), 4,
       "solid (3 tiles)"},
      {"16b: one and one", plainMap(rows("L", ".a../.b..", kSolid), shaped), 2, "solid (1 tile)"},
      {"16c: two and three", plainMap(rows("L", ".aa./.bbb", kSolid), shaped), 5, "solid (2 tiles)"},
      {"16: a name says so", plainMap(rows("Collision", ".aa./.bbb"), shaped), 5, "Collision: its name says"},
  };
}

/// The first two lines of a report.
std::string summaryOf(const ImportedMap& map) {
  const std::string text = toText(map.report);
  return text.substr(0, text.find('\n', text.find('\n') + 1));
}

TEST(TiledCases, AreTakenAsTheyAreMeantOrOffered) {
  for (const MapCase& one : mapCases()) {
    SCOPED_TRACE(one.name);
    const auto map = mustImportFiles({{"maps/test.tmx", one.text}});
    EXPECT_EQ(map.placements.size(), one.polygons);
    EXPECT_THAT(summaryOf(map), HasSubstr(one.said));
    EXPECT_EQ(map.report.suggestions.empty() && one.polygons == 0, false);
    for (const Suggestion& offer : map.report.suggestions) {
      const auto taken = mustImportFiles({{"maps/test.tmx", one.text}}, offer.options);
      EXPECT_EQ(taken.placements.size(), offer.polygons) << offer.text;
    }
  }
}

/// 4, as it was found: all but one of a map's tiles are in a layer whose name is for another use.
TEST(TiledCases, BothOfTwoLayersAreOfferedIfTheLargerIsPassedOver) {
  std::string bg, things = "1";
  for (int k = 0; k < 40; ++k) bg += k < 20 ? "0," : k == 39 ? "1" : "1,";
  for (int k = 1; k < 40; ++k) things += ",0";
  const auto layer = [](const char* name, const std::string& csv) {
    return fmt::format("<layer name='{}' width='10' height='4'><data encoding='csv'>{}</data></layer>", name, csv);
  };
  const auto map = mustImportFiles({{"maps/test.tmx", plainMap(layer("bg", bg) + layer("objects", things))}});
  EXPECT_TRUE(map.placements.empty());
  ASSERT_EQ(map.report.suggestions.size(), 2U);
  EXPECT_EQ(map.report.suggestions[0].arguments.at(1), "bg") << "the other one has less than 3 % of the map";
  EXPECT_EQ(map.report.suggestions[1].arguments.at(1), "objects");
}

/// A floor that fills a level, without walls, may be what one walks on.
TEST(TiledCases, AFloorThatFillsALevelIsOffered) {
  std::string text = project(level("A", 0, 0, grid("2,2,2,2,3,0")));
  for (std::size_t at = 0; (at = text.find("ice", at)) != std::string::npos;) text.replace(at, 3, "Floor");
  const auto map = test::must(importFiles({{"maps/test.tmx", text}}));
  EXPECT_TRUE(map.placements.empty());
  ASSERT_EQ(map.report.suggestions.size(), 2U);
  EXPECT_THAT(map.report.suggestions[0].arguments, ElementsAre("--no-objects", "--not", "Floor"));
  EXPECT_EQ(map.report.suggestions[0].polygons, 1U);
  EXPECT_EQ(map.report.suggestions[1].polygons, 5U);
}

/// Layers that are missed are offered together first. One that lies under what is taken is not missed.
TEST(TiledCases, AllThatIsMissedIsOfferedAtOnce) {
  const std::string shapes = tile(0, property("solid", "true"));
  const std::string all = rows("Platforms", "aa../....") + rows("Blocks of snow", "..b./....");
  const auto map = mustImportFiles({{"maps/test.tmx", plainMap(all + rows("Blocks of ice", "...b/b..."), shapes)}});
  EXPECT_EQ(map.placements.size(), 2U);
  EXPECT_THAT(map.report.partial, AllOf(HasSubstr("snow"), HasSubstr("ice")));
  ASSERT_EQ(map.report.suggestions.size(), 3U);
  EXPECT_EQ(map.report.suggestions[0].polygons, 5U);
  const auto covered = mustImportFiles({{"maps/test.tmx", plainMap(all + rows("Walls", "b.../...."), shapes)}});
  EXPECT_THAT(covered.report.partial, Not(HasSubstr("Walls")));
}

/// A guess is undone by the command of the second line, and that one by the first.
TEST(TiledCases, EachOfferIsDifferentFromWhatWasTaken) {
  const std::string text = plainMap(rows("Collision", "..../aaaa") + rows("Walls", "a..a/aaaa"));
  const auto map = mustImportFiles({{"maps/test.tmx", text}});
  EXPECT_EQ(map.placements.size(), 4U);
  ASSERT_FALSE(map.report.suggestions.empty());
  const auto other = mustImportFiles({{"maps/test.tmx", text}}, map.report.suggestions.front().options);
  EXPECT_EQ(other.placements.size(), 6U) << summaryOf(map);
}

}  // namespace
}  // namespace lgs::tiled
