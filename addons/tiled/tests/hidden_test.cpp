// Hidden layers and objects: they count and are marked, or they are left out.
#include "maps.h"

namespace lgs::tiled {
namespace {

std::string walls(const std::string& objects, const std::string& attributes = "") {
  return objectLayer(objects, "name='Walls' " + attributes);
}

std::string box(int column, const std::string& attributes = "") {
  return "<object id='" + std::to_string(column + 1) + "' x='" + std::to_string(32 * column) +
         "' y='0' width='32' height='32' " + attributes + "/>";
}

Options visibleOnly() {
  const Options options{.visibleOnly = true};
  return options;
}

TEST(TiledHidden, LayersAreMarkedOrLeftOut) {
  const std::string tile = tilesetXml({kFullTile});
  const std::string content = tile + csvLayer(1, 1, "1") + csvLayer(2, 1, "0,1", "visible='0'") +
                              walls(box(2), "visible='0'") + walls(box(3), "visible='1' opacity='0'") +
                              "<objectgroup name='Doors' visible='0'/><imagelayer name='Sky' visible='0'/>";
  const std::string mark = "hidden (--visible leaves it out)";
  const std::string unsaid = "neither its name, its class nor a property says that it is solid; hidden]";
  const auto all = mustImport(content);
  EXPECT_EQ(cellsOf(all), (Cells{{0, -1}, {1, -1}, {2, -1}, {3, -1}}));
  EXPECT_THAT(remarks(all), ElementsAre("Ground", "Ground: " + mark, "Walls: its name says 'wall'; " + mark,
                                        "Walls: its name says 'wall'", "[Doors: " + unsaid, "[Sky: an image]"));
  const auto visible = mustImport(content, visibleOnly());
  EXPECT_EQ(cellsOf(visible), (Cells{{0, -1}, {3, -1}})) << "opacity hides nothing";
  EXPECT_THAT(remarks(visible), ElementsAre("Ground", "[Ground: hidden]", "[Walls: hidden]",
                                            "Walls: its name says 'wall'", "[Doors: " + unsaid, "[Sky: an image]"));
}

TEST(TiledHidden, AGroupHidesWhatIsInIt) {
  const std::string content = "<group name='A' visible='0'><group name='B' visible='1'>" + walls(box(0)) +
                              "</group></group><group name='C'>" + walls(box(1)) + "</group>";
  EXPECT_EQ(cellsOf(mustImport(content)), (Cells{{0, -1}, {1, -1}}));
  EXPECT_EQ(cellsOf(mustImport(content, visibleOnly())), (Cells{{1, -1}}));
  Options named = visibleOnly();
  named.objects = {"A", "C"};
  EXPECT_EQ(cellsOf(mustImport(content, named)), (Cells{{1, -1}})) << "not even by its name";
}

/// "OBJECT: text" of all notes.
std::vector<std::string> numberedNotes(const ImportedMap& map) {
  std::vector<std::string> result;
  for (const Note& note : notesOf(map)) result.push_back(fmt::format("{}: {}", note.object, note.text));
  return result;
}

TEST(TiledHidden, ObjectsAreMarkedOrLeftOut) {
  const std::string content = walls(box(0) + box(1, "visible='0'") + box(2, "visible='1'"));
  const auto all = mustImport(content);
  EXPECT_EQ(cellsOf(all), (Cells{{0, -1}, {1, -1}, {2, -1}}));
  EXPECT_THAT(numberedNotes(all), ElementsAre("2: is hidden, and counts all the same; --visible leaves it out"));
  EXPECT_THAT(toText(all.report), HasSubstr("Worth a look:\n  layer Walls\n    object 2: is hidden"));
  const auto visible = mustImport(content, visibleOnly());
  EXPECT_EQ(cellsOf(visible), (Cells{{0, -1}, {2, -1}}));
  EXPECT_THAT(numberedNotes(visible), ElementsAre("2: it is hidden"));
  EXPECT_THAT(toText(visible.report), HasSubstr("Left out:\n  layer Walls\n    object 2: it is hidden"));
}

TEST(TiledHidden, ShapesOfTilesAndTileObjects) {
  const std::string half = "<object id='1' width='16' height='32' visible='0'/>";
  const std::string rest = "<object id='2' x='16' width='16' height='32'/>";
  const Ring right = pxBox(16, 0, 32, 32);
  const std::string tiles = tilesetXml({half + rest}) + csvLayer(1, 1, "1");
  EXPECT_EQ(areaInCells(mustImport(tiles)), 1);
  const auto visible = mustImport(tiles, visibleOnly());
  EXPECT_EQ(ringsIn(visible, {0, -1}), (Rings{right}));
  EXPECT_THAT(numberedNotes(visible), ElementsAre("1: it is hidden"));
  const auto object = [&](const std::string& attributes) {
    return tilesetXml({half + rest}) +
           walls("<object id='7' gid='1' x='0' y='32' width='32' height='32' " + attributes + "/>");
  };
  EXPECT_EQ(ringsIn(mustImport(object(""), visibleOnly()), {0, -1}), (Rings{right}));
  EXPECT_TRUE(mustImport(object("visible='0'"), visibleOnly()).placements.empty());
  EXPECT_THAT(numberedNotes(mustImport(object("visible='0'"), visibleOnly())), ElementsAre("7: it is hidden"));
  EXPECT_EQ(numberedNotes(mustImport(object("visible='0'"))).size(), 2U) << "both of its shapes are marked";
}

TEST(TiledHidden, ATemplateCanHide) {
  const auto area = [](const std::string& attributes) {
    return areaInCells(mustImportFiles(
        {{"maps/test.tmx", mapXml(walls("<object id='1' template='a.tx' x='0' y='0' " + attributes + "/>"))},
         {"maps/a.tx", "<template><object width='32' height='32' visible='0'/></template>"}},
        visibleOnly()));
  };
  EXPECT_EQ(area(""), 0);
  EXPECT_EQ(area("visible='1'"), 1);
}

TEST(TiledHidden, IfAllIsHiddenTheReportSaysSo) {
  const auto map = mustImport(walls(box(0), "visible='0'") + csvLayer(1, 1, "0", "visible='0'"), visibleOnly());
  ASSERT_EQ(map.report.suggestions.size(), 1U);
  EXPECT_EQ(map.report.suggestions[0].text,
            "hidden, and --visible leaves it out: object layer Walls: its name says 'wall'");
  EXPECT_TRUE(map.report.suggestions[0].arguments.empty());
  EXPECT_EQ(map.report.suggestions[0].polygons, 1U);
  EXPECT_THAT(toText(map.report),
              HasSubstr("\n  or:  (1 polygon: hidden, and --visible leaves it out: object layer Walls: its name "));
}

}  // namespace
}  // namespace lgs::tiled
