// Cost under attack, found by a search (search.h): of maps, saves, strokes and questions.
#include "search.h"

#include <lgs/brush.h>

#include <gtest/gtest.h>

namespace lgs::cost_test {
namespace {

// --- Maps

/// Polygons of an object layer, in pixels, and the size of a tile.
struct Map {
  std::vector<std::vector<std::pair<int, int>>> objects;
  int tile = 32;
};

std::string asXml(const Map& map) {
  const std::string tile = std::to_string(map.tile);
  std::string text = "<map orientation='orthogonal' width='4' height='4' tilewidth='" + tile + "' tileheight='" + tile +
                     "'><objectgroup name='walls'>";
  for (const auto& points : map.objects) {
    text += "<object id='1' x='0' y='0'><polygon points='";
    for (const auto& [x, y] : points) text += std::to_string(x) + ',' + std::to_string(y) + ' ';
    text += "'/></object>";
  }
  return text + "</objectgroup></map>";
}

std::string asJson(const Map& map) {
  const std::string tile = std::to_string(map.tile);
  std::string text = R"({"type":"map","orientation":"orthogonal","width":4,"height":4,"tilewidth":)" + tile +
                     R"(,"tileheight":)" + tile + R"(,"layers":[{"type":"objectgroup","name":"walls","objects":[)";
  for (const auto& points : map.objects) {
    text += (&points == map.objects.data() ? "" : ",") + std::string(R"({"id":1,"x":0,"y":0,"polygon":[)");
    for (const auto& [x, y] : points)
      text += (&points.front().first == &x ? "" : ",") + std::string(R"({"x":)") + std::to_string(x) + R"(,"y":)" +
              std::to_string(y) + "}";
    text += "]}";
  }
  return text + "]}]}";
}

std::vector<std::pair<int, int>> drawObject(Random& random) {
  std::vector<std::pair<int, int>> points;
  const int reach = random.pick(std::vector{4, 31, 200, 4'000});
  for (int k = 3 + random.below(30); k > 0; --k) points.emplace_back(random.below(reach), random.below(reach));
  return points;
}

void changeMap(Map& map, Random& random) {
  const int kind = random.below(5);
  if (kind == 0 || map.objects.empty()) {
    map.objects.push_back(drawObject(random));
  } else if (kind == 1) {
    map.objects.push_back(random.pick(std::vector(map.objects)));
  } else if (kind == 2) {
    map.tile = random.pick(std::vector{1, 2, 8, 32, 500});
  } else if (kind == 3) {
    auto& points = map.objects[random.below(map.objects.size())];
    points.emplace_back(random.below(300), random.below(300));
  } else {
    auto& points = map.objects[random.below(map.objects.size())];
    points[random.below(points.size())] = {random.below(100), random.below(100)};
  }
}

TEST(CostSearch, OfMapsFindsNoneBeyondTheirLimit) {
  const std::function<Map(Random&)> make = [](Random& random) {
    return Map{{drawObject(random), drawObject(random)}, 32};
  };
  for (const auto& write : {asXml, asJson})
    EXPECT_LT(dearest<Map>(
                  make, changeMap, [&](const Map& map) { return shareOfLimit(write(map)); }, 3, 120),
              8);
}

// --- Saved worlds

double costOfLoading(const Calls& calls) {
  std::vector<std::byte> file;
  EXPECT_TRUE(worldOf(calls).save(
      [&](std::span<const std::byte> piece) { file.insert(file.end(), piece.begin(), piece.end()); }));
  const auto cost = visitsOf([&] { EXPECT_TRUE(World::load(file)); });
  return static_cast<double>(cost) / static_cast<double>(file.size());
}

TEST(CostSearch, OfSavedWorldsFindsNoneThatTakesLongForItsSize) {
  EXPECT_LT(dearest<Calls>(drawCalls, changeCalls, costOfLoading, 3, 400), 3'000);
}

// --- Strokes

constexpr std::int64_t kCell = kUnitsPerCell;

Point drawPoint(Random& random) { return {random.below(3 * kCell) - kCell, random.below(3 * kCell) - kCell}; }

Region drawRegion(Random& random) {
  Region region{{{}}, FillRule::evenOdd};
  for (int k = 0; k < 24; ++k) region.rings[0].push_back(drawPoint(random));
  return region;
}

void changeRegion(Region& region, Random& random) {
  Ring& ring = region.rings[0];
  Point& p = ring[random.below(ring.size())];
  p = random.chance(50) ? drawPoint(random) : Point{p.x + random.below(9) - 4, p.y + random.below(9) - 4};
}

/// For each pair of edges, which may cross: that is what a stroke may cost.
double costOfStroke(const Region& region) {
  World world;
  EXPECT_TRUE(world.fill({{-1, -1}, {1, 1}}, world.shape(kUnitSquare).value(), 1));
  const auto cost = visitsOf([&] { static_cast<void>(carve(world, region)); });
  return static_cast<double>(cost) / static_cast<double>(region.rings[0].size() * region.rings[0].size());
}

TEST(CostSearch, OfStrokesFindsNoneBeyondTheSquareOfItsEdges) {
  EXPECT_LT(dearest<Region>(drawRegion, changeRegion, costOfStroke, 3, 400), 5'000);
}

// --- Questions

struct Question {
  Calls calls;
  Point from, to;
};

Question drawQuestion(Random& random) { return {drawCalls(random), drawPoint(random), drawPoint(random)}; }

void changeQuestion(Question& question, Random& random) {
  if (random.chance(60)) return changeCalls(question.calls, random);
  Point& p = random.chance(50) ? question.from : question.to;
  const std::int64_t far = random.pick(std::vector<std::int64_t>{kCell, 100 * kCell, 8'000 * kCell});
  p = {random.below(2 * far) - far, random.below(2 * far) - far};
}

/// For each cell that the question may look at.
double costOfQuestion(const Question& question) {
  const World world = worldOf(question.calls);
  const auto ray = visitsOf([&] { static_cast<void>(world.rayCast(question.from, question.to)); });
  const auto near = visitsOf([&] { static_cast<void>(world.nearest(question.from, kMaxRadius)); });
  const auto cells = [](std::int64_t a, std::int64_t b) {
    return static_cast<double>(std::max(a, b) - std::min(a, b)) / kCell + 2;
  };
  const double touched = cells(question.from.x, question.to.x) + cells(question.from.y, question.to.y);
  const auto chunks = static_cast<double>(world.stats().chunks);
  return std::max(static_cast<double>(ray) / touched, static_cast<double>(near) / (1'024 * chunks + 1));
}

TEST(CostSearch, OfQuestionsFindsNoneBeyondTheCellsThatTheyTouch) {
  EXPECT_LT(dearest<Question>(drawQuestion, changeQuestion, costOfQuestion, 3, 400), 80);
}

}  // namespace
}  // namespace lgs::cost_test
