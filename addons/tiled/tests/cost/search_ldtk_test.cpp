// Cost under attack, found by a search (search.h): of LDtk projects.
#include "search.h"

#include <gtest/gtest.h>

namespace lgs::cost_test {
namespace {

struct Value {
  int number = 1;
  std::string name;
};

struct Layer {
  int definition = 1;
  std::string name;
  std::vector<int> cells;
};

struct Entity {
  std::string name;
  int x = 0, y = 0, width = 8, height = 8;
};

/// One definition of values, which all layers may name or not, and levels with the same layers and entities.
struct Project {
  std::vector<Value> values{{}};
  std::vector<Layer> layers{{}};
  std::vector<Entity> entities;
  int levels = 1, grid = 8;
};

template <class Item, class Write>
std::string joined(const std::vector<Item>& items, Write&& write) {
  std::string all;
  for (const Item& item : items) all += (all.empty() ? "" : ",") + write(item);
  return all;
}

std::string quoted(const std::string& text) { return '"' + text + '"'; }

std::string field(const char* name, int value) { return quoted(name) + ":" + std::to_string(value); }

std::string asText(const Project& project) {
  const std::string grid = field("__gridSize", project.grid);
  const std::string values = joined(project.values, [](const Value& v) {
    return "{" + field("value", v.number) + R"(,"identifier":)" + quoted(v.name) + "}";
  });
  const std::string layers = joined(project.layers, [&](const Layer& layer) {
    const std::string cells = joined(layer.cells, [](int cell) { return std::to_string(cell); });
    return R"({"__type":"IntGrid","__identifier":)" + quoted(layer.name) + "," + grid + "," +
           field("__cWid", static_cast<int>(layer.cells.size())) + R"(,"__cHei":1,)" +
           field("layerDefUid", layer.definition) + R"(,"intGridCsv":[)" + cells + "]}";
  });
  const std::string entities = joined(project.entities, [](const Entity& e) {
    return R"({"__identifier":)" + quoted(e.name) + R"(,"px":[)" + std::to_string(e.x) + "," + std::to_string(e.y) +
           "]," + field("width", e.width) + "," + field("height", e.height) + R"(,"defUid":1})";
  });
  std::string levels;
  for (int k = 0; k < project.levels; ++k)
    levels += (k == 0 ? "" : ",") + ("{" + quoted("identifier") + ":" + quoted(std::to_string(k)) + ",") +
              field("worldX", k * 8) + R"(,"worldY":0,"pxWid":8,"pxHei":8,"layerInstances":[)" + layers + "," +
              R"({"__type":"Entities","__identifier":"solid","entityInstances":[)" + entities + "]}]}";
  return R"({"jsonVersion":"1.5.3","worldLayout":"Free","defs":{"layers":[{"uid":1,"intGridValues":[)" + values +
         R"(]}],"entities":[{"uid":1,"renderMode":"Ellipse"}]},"levels":[)" + levels + "]}";
}

std::string drawName(Random& random) {
  if (random.chance(50)) return random.pick(std::vector<std::string>{"", "x", "1", "g.x", "g.x.1"});
  return random.chance(80) ? std::to_string(random.below(1'000)) : std::string(random.below(400U), 'g');
}

/// A few more of something, or something else of what is there.
void changeProject(Project& project, Random& random) {
  const int many = random.pick(std::vector{1, 8, 64});
  const int next = static_cast<int>(project.values.size());
  switch (random.below(9)) {
    case 0:
    case 1:
    case 2: {
      const std::string name = drawName(random);
      for (int k = 0; k < many; ++k) project.values.push_back({next + k + 1, name});
      return;
    }
    case 3:
      project.values.push_back({random.below(1 << 10), drawName(random)});
      return;
    case 4:
      if (project.layers.size() < 200) project.layers.push_back({random.below(4), drawName(random), {}});
      return;
    case 5: {
      auto& cells = project.layers[random.below(project.layers.size())].cells;
      for (int k = 0; k < many; ++k) cells.push_back(random.chance(80) ? next + k : random.below(1 << 20));
      return;
    }
    case 6:
      for (int k = 0; k < many; ++k)
        project.entities.push_back({drawName(random), k * random.below(9), random.below(99), 1 + random.below(99), 8});
      return;
    case 7:
      if (project.levels * many < 200) project.levels *= many;
      return;
    default:
      project.grid = random.pick(std::vector{1, 8, 1'000});
  }
}

Project drawProject(Random& random) {
  Project project;
  for (int k = 0; k < 2; ++k) changeProject(project, random);
  return project;
}

TEST(CostSearch, OfLdtkProjectsFindsNoneBeyondTheirLimit) {
  constexpr std::size_t kMost = 8'000;  // bytes: to climb further takes long, and is as steep
  const auto cost = [](const Project& project) {
    const std::string text = asText(project);
    return text.size() < kMost ? shareOfLimit(text) : -1;
  };
  EXPECT_LT(dearest<Project>(drawProject, changeProject, cost, 3, 120), 5);
}

/// So many times as large: more values of the same names, used in the same layers, and more entities beside.
Project repeated(const Project& project, int times) {
  Project all = project;
  int last = 0;
  for (const Value& value : project.values) last = std::max(last, value.number);
  for (int k = 1; k < times; ++k) {
    for (const Value& value : project.values) all.values.push_back({value.number + k * last, value.name});
    for (std::size_t at = 0; at < project.layers.size(); ++at)
      for (const int cell : project.layers[at].cells)
        if (cell <= last) all.layers[at].cells.push_back(cell + k * last);
    for (const Entity& e : project.entities) all.entities.push_back({e.name, e.x + k * 1'000, e.y, e.width, e.height});
  }
  return all;
}

/// The bound of bytes is wide for a project that is small. What is four times as large may cost four times as much.
TEST(CostSearch, OfLdtkProjectsFindsNoneThatGrowsFasterThanItsLists) {
  constexpr std::size_t kLeast = 3'000, kMost = 9'000;  // bytes
  constexpr int kTimes = 4;
  const auto growth = [](const Project& project) {
    const std::string text = asText(project);
    if (text.size() > kMost) return -1.0;
    const std::string larger = asText(repeated(project, kTimes));
    const bool isSmall = text.size() < kLeast;  // what an import costs in any case would hide it
    return isSmall ? static_cast<double>(text.size()) / 1e6 : costOfImport(larger) / costOfImport(text);
  };
  EXPECT_LT(dearest<Project>(drawProject, changeProject, growth, 4, 100), 1.25 * kTimes);
}

}  // namespace
}  // namespace lgs::cost_test
