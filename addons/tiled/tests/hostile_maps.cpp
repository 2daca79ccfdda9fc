#include "hostile_maps.h"

#include <fmt/format.h>

#include <limits>

namespace lgs::tiled {
namespace {

using oracle::Random;

constexpr int kTiles = 5, kSide = 4, kPixels = 32;

/// In pixels, within some cells of the map; one in so many is no good number.
std::string number(Random& choices, int hostilePercent = 2) {
  static const std::vector<std::string> kHostile{"",       "nan",  "inf",   "-inf",       "1e308",
                                                 "-1e308", "1e-9", "0x10",  "2147483648", "-9223372036854775808",
                                                 "1e999",  "-0.0", "1,000", "99999"};
  if (choices.chance(hostilePercent)) return choices.pick(kHostile);
  if (choices.chance(50)) return std::to_string(choices.between(-1, 5) * 8);
  return fmt::format("{:.2f}", choices.between(-1'000, 6'000) / 100.0);
}

std::string points(Random& choices) {
  std::string list;
  for (int k = choices.between(0, 6); k >= 0; --k) list += number(choices, 1) + "," + number(choices, 1) + " ";
  return list;
}

std::string object(Random& choices) {
  std::string text = fmt::format("<object id='{}' x='{}' y='{}'", choices.below(9), number(choices), number(choices));
  if (choices.chance(20)) text += fmt::format(" rotation='{}'", number(choices));
  if (choices.chance(20)) text += fmt::format(" type='{}'", choices.chance(50) ? "ice" : "one-way");
  if (choices.chance(10)) text += " visible='0'";
  switch (choices.below(6)) {
    case 0:
      return text + fmt::format("><polygon points='{}'/></object>", points(choices));
    case 1:
      return text + fmt::format("><polyline points='{}'/></object>", points(choices));
    case 2:
      return text + fmt::format(" width='{}' height='{}'><ellipse/></object>", number(choices), number(choices));
    case 3:
      return text + fmt::format(" gid='{}' width='{}' height='{}'/>", choices.below(kTiles + 2), number(choices),
                                number(choices));
    default:
      return text + fmt::format(" width='{}' height='{}'/>", number(choices), number(choices));
  }
}

std::string objects(Random& choices, int most) {
  std::string all;
  for (int k = choices.below(most + 1); k > 0; --k) all += object(choices);
  return all;
}

/// Tiles are turned and mirrored by the highest bits of their numbers.
std::string layer(Random& choices) {
  std::string csv;
  for (int k = 0; k < kSide * kSide; ++k) {
    const std::uint32_t turn = choices.chance(30) ? choices.below(16U) << 28 : 0;
    csv += fmt::format("{}{}", k == 0 ? "" : ",", choices.chance(40) ? 0 : turn | choices.below(kTiles + 2U));
  }
  const std::string offset = choices.chance(20) ? fmt::format(" offsetx='{}'", number(choices)) : "";
  return fmt::format("<layer name='solid' width='{0}' height='{0}'{1}><data encoding='csv'>{2}</data></layer>", kSide,
                     offset, csv);
}

double lengthFor(Random& choices) {
  using Limits = std::numeric_limits<double>;
  return choices.pick(
      std::vector<double>{0, 1, 4, 1e308, -1, -0.0, Limits::quiet_NaN(), Limits::infinity(), Limits::denorm_min()});
}

/// As they come as a rule.
Options optionsFor(Random& choices) {
  Options options{.maxObjectCells = 1 << 12};
  if (choices.chance(20)) options.tolerance = lengthFor(choices);
  if (choices.chance(20)) options.polylineThickness = lengthFor(choices);
  if (choices.chance(20)) options.solidWithoutShapes = true;
  if (choices.chance(40)) options.objects.emplace();
  if (choices.chance(20)) options.blockFrom = static_cast<BlockFrom>(choices.below(5));
  if (choices.chance(20)) options.blocks = {{"ice", ~Block{0}}, {"", 0}};
  if (choices.chance(5)) options.leaveOut = {"", "ice"};
  if (choices.chance(5)) options.solidIf = {"", "=", "class=ice"};
  if (choices.chance(5)) options.maxTiles = choices.below(20U);
  if (choices.chance(5)) options.maxPlacements = choices.below(20U);
  if (choices.chance(5)) options.maxWork = choices.below(20U);
  if (choices.chance(5)) options.maxBytes = choices.chance(50) ? 0 : ~std::size_t{0};
  return options;
}

}  // namespace

HostileMap HostileMap::draw(Random& choices) {
  const int side = choices.chance(95) ? kPixels : choices.below(3);
  std::string text = fmt::format(
      "<map orientation='orthogonal' width='{0}' height='{0}' tilewidth='{1}' tileheight='{1}'>", kSide, side);
  text += fmt::format("<tileset firstgid='1' name='s' tilewidth='{0}' tileheight='{0}'>", kPixels);
  for (int k = 0; k < kTiles; ++k)
    text += fmt::format("<tile id='{}'><objectgroup>{}</objectgroup></tile>", k, objects(choices, 3));
  text += "</tileset>";
  for (int k = choices.below(3); k > 0; --k) text += layer(choices);
  if (choices.chance(60)) text += fmt::format("<objectgroup name='walls'>{}</objectgroup>", objects(choices, 6));
  return {text + "</map>", optionsFor(choices)};
}

std::string HostileMap::inWords() const {
  const Options& o = options;
  std::string words = fmt::format(
      "{}\ntolerance {}, thickness {}, squares {}, all objects {}, blocks from {}, {} names, {} classes left "
      "out, {} properties, at most {} tiles, {} polygons, {} steps, {} bytes",
      text, o.tolerance, o.polylineThickness, o.solidWithoutShapes, !o.objects.has_value(),
      static_cast<int>(o.blockFrom), o.blocks.size(), o.leaveOut.size(), o.solidIf.size(), o.maxTiles, o.maxPlacements,
      o.maxWork, o.maxBytes);
  return words;
}

tl::expected<ImportedMap, ImportError> HostileMap::import() const {
  return importMap("a.tmx", options,
                   [&](const std::string&) -> tl::expected<std::string, std::string> { return text; });
}

}  // namespace lgs::tiled
