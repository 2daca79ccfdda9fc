#include "tile_table.h"

#include <fast_float/fast_float.h>
#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr std::uint32_t kMaxId = 0x0FFF'FFFF;
constexpr std::size_t kMaxTiles = 1 << 16;  // of a table

constexpr std::string_view kBlanks = " \t\r";

/// Takes the next word off a line. Commas count as blanks if asked for.
std::string_view takeWord(std::string_view& line, std::string_view blanks) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

std::optional<std::uint32_t> idIn(std::string_view text) {
  std::uint32_t id = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (status != std::errc() || end != text.data() + text.size() || id > kMaxId) return std::nullopt;
  return id;
}

/// A decimal, or a fraction of two.
std::optional<double> numberIn(std::string_view text) {
  const auto decimal = [](std::string_view part) -> std::optional<double> {
    double value = 0;
    const auto [end, status] = fast_float::from_chars(part.data(), part.data() + part.size(), value);
    const bool isGood = status == std::errc() && end == part.data() + part.size() && value >= -64 && value <= 1e6;
    return isGood ? std::optional(value) : std::nullopt;
  };
  const std::size_t slash = text.find('/');
  const auto over = decimal(text.substr(0, slash));
  const auto under = slash == std::string_view::npos ? std::optional(1.0) : decimal(text.substr(slash + 1));
  if (!over || !under || *under <= 0) return std::nullopt;
  return *over / *under;
}

class TableParser {
 public:
  tl::expected<TileTable, std::string> parse(std::string_view text) {
    constexpr std::string_view kHead = "lgs-tiles 1";
    bool isFirst = true;
    for (std::size_t number = 1; !text.empty() && fault_.empty(); ++number) {
      std::string_view line = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(line.size() + 1, text.size()));
      line = line.substr(0, line.find('#'));
      line = line.substr(0, line.find_last_not_of(kBlanks) + 1);
      if (line.empty()) continue;
      isFirst ? head(line == kHead) : row(line);
      isFirst = false;
      if (!fault_.empty()) return tl::unexpected(std::to_string(number) + ": " + fault_);
    }
    if (isFirst) return tl::unexpected<std::string>("1: should begin with \"lgs-tiles 1\"");
    return std::move(table_);
  }

 private:
  void head(bool isRight) {
    if (!isRight) fault_ = "should begin with \"lgs-tiles 1\"";
  }

  void row(std::string_view line) {
    const std::string_view first = takeWord(line, kBlanks);
    if (first == "tileset") {
      line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
      tileset_ = line;
      return;
    }
    const std::vector<std::uint32_t> ids = idsIn(first);
    const TileShape shape = shapeIn(line);
    if (!fault_.empty()) return;
    for (const std::uint32_t id : ids) {
      if (!table_[tileset_].emplace(id, shape).second) fault_ = "tile " + std::to_string(id) + " has a row already";
    }
    tiles_ += ids.size();
    if (tiles_ > kMaxTiles) fault_ = "has more than " + std::to_string(kMaxTiles) + " tiles";
  }

  /// "3", "60-63" or "0,39,60-63".
  std::vector<std::uint32_t> idsIn(std::string_view text) {
    std::vector<std::uint32_t> ids;
    while (!text.empty() && fault_.empty()) {
      const std::string_view part = text.substr(0, text.find(','));
      text.remove_prefix(std::min(part.size() + 1, text.size()));
      const std::size_t dash = part.find('-');
      const auto from = idIn(part.substr(0, dash));
      const auto to = dash == std::string_view::npos ? from : idIn(part.substr(dash + 1));
      if (!from || !to || *to < *from || *to - *from >= kMaxTiles) {
        fault_ = "should begin with the numbers of tiles, such as 3 or 0,5,60-63, or with \"tileset NAME\"";
        return {};
      }
      for (std::uint32_t id = *from; id <= *to; ++id) ids.push_back(id);
    }
    return ids;
  }

  TileShape shapeIn(std::string_view line) {
    TileShape shape;
    std::string_view rest = line;
    const std::string_view word = takeWord(rest, kBlanks);
    if (word == "full" || word == "none") {
      if (!takeWord(rest, kBlanks).empty()) fault_ = "has more than \"" + std::string(word) + "\"";
      if (word == "full") shape.outline = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
      return shape;
    }
    shape.oneWay = word == "oneway";
    if (shape.oneWay) line = rest;
    std::vector<double> numbers;
    for (std::string_view text = takeWord(line, " \t\r,"); !text.empty(); text = takeWord(line, " \t\r,")) {
      const auto number = numberIn(text);
      if (!number) {
        fault_ = "should say full, none, oneway with x y of two points or more, or x y of three or more";
        return {};
      }
      numbers.push_back(*number);
    }
    const std::size_t least = shape.oneWay ? 2 : 3;
    if (numbers.size() % 2 != 0 || numbers.size() / 2 < least || numbers.size() / 2 > kMaxObjectVertices) {
      fault_ = "should have x y of " + std::to_string(least) + " points or more";
    }
    for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) shape.outline.push_back({numbers[k], numbers[k + 1]});
    return shape;
  }

  TileTable table_;
  std::string tileset_;  // "" for any
  std::size_t tiles_ = 0;
  std::string fault_;
};

/// The shape in pixels of the tile's image, y down.
CollisionObject objectOf(const TileShape& shape, const Tile& tile, DoublePoint size) {
  CollisionObject object;
  object.kind = shape.oneWay ? CollisionObject::Kind::polyline : CollisionObject::Kind::polygon;
  object.oneWay = shape.oneWay;
  if (shape.oneWay && tile.className.empty()) object.className = "one-way";
  for (const DoublePoint p : shape.outline) object.points.push_back({p.x * size.x, (1 - p.y) * size.y});
  return object;
}

}  // namespace

tl::expected<TileTable, std::string> parseTileTable(std::string_view text) { return TableParser().parse(text); }

void reshape(Tileset& tileset, const TileTable& table) {
  for (const std::string& name : {std::string(), tileset.name}) {
    const auto rows = table.find(name);
    if (rows == table.end()) continue;
    for (const auto& [id, shape] : rows->second) {
      Tile& tile = tileset.tiles[id];
      const bool hasSize = tile.size.x > 0 && tile.size.y > 0;
      tile.objects.clear();
      tile.isSettled = true;
      if (!shape.outline.empty()) tile.objects.push_back(objectOf(shape, tile, hasSize ? tile.size : tileset.tileSize));
    }
  }
}

}  // namespace lgs::tiled
