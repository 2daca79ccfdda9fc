#include "map_source.h"

#include "regexp.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace lgs::tiled {
namespace {

class WorldMaps {
 public:
  WorldMaps(const XmlFile& file, const FolderLister& lister, std::vector<std::string>& notes)
      : file_(file), lister_(lister), notes_(notes) {}

  std::vector<MapPlace> read() {
    for (const auto node : file_.root().children("map")) readListed(node);
    const auto patterns = file_.root().children("pattern");
    if (!patterns.empty()) listFolder();
    for (const auto node : patterns) readPattern(node);
    if (maps_.empty())
      file_.fail(file_.root(), patterns.empty() ? "lists no maps" : "has no maps: no file fits its patterns");
    return std::move(maps_);
  }

 private:
  void readListed(pugi::xml_node node) {
    const std::string name = node.attribute("fileName").value();
    const DoublePoint at{file_.real(node, "x"), file_.real(node, "y")};
    if (name.empty()) return file_.fail(node, "has no fileName");
    if (!known_.insert(file_.pathTo(name)).second) return file_.fail(node, name + " is listed twice");
    place(node, name, at);
  }

  void place(pugi::xml_node node, const std::string& file, DoublePoint at) {
    maps_.push_back({std::filesystem::path(file).replace_extension().generic_string(), at, file, node});
  }

  void listFolder() {
    if (file_.failed()) return;
    const std::string folder = folderOf(file_.name());
    const pugi::xml_node pattern = file_.root().child("pattern");
    if (!lister_)
      return file_.fail(pattern,
                        "takes maps by the names of the files in its folder, and nothing lists them: give importMap() "
                        "a FolderLister, or list the maps of the world as \"maps\"");
    auto names = lister_(folder.empty() ? "." : folder);
    if (!names) return file_.fail(pattern, "needs a list of its folder: " + names.error());
    names_ = std::move(*names);
    std::erase_if(names_, [](const std::string& name) { return name.starts_with('.'); });  // Tiled does not see them
    std::sort(names_.begin(), names_.end());
  }

  void readPattern(pugi::xml_node node) {
    if (file_.failed()) return;
    const std::string pattern = inQuotes(node.attribute("regexp").value());
    const auto fits = namesThatFit(node.attribute("regexp").value(), names_, stepsLeft_);
    if (!fits) return file_.fail(node, "its regexp " + pattern + " " + fits.error());
    if (fits->empty()) notes_.push_back("no file in the folder fits the pattern " + pattern);
    const std::size_t before = maps_.size();
    for (const auto& [name, captures] : *fits)
      if (known_.insert(file_.pathTo(name)).second) add(node, name, captures);
    noteSamePlaces(before, pattern);
  }

  void add(pugi::xml_node node, const std::string& name, const std::array<std::string, 2>& at) {
    const auto along = [&](const std::string& text, const char* multiplier, const char* offset) {
      constexpr std::int64_t kMin = std::numeric_limits<std::int32_t>::min();
      constexpr std::int64_t kMax = std::numeric_limits<std::int32_t>::max();
      const auto number = parseInteger(text);
      const bool isNumber = number && *number >= kMin && *number <= kMax;
      if (!isNumber)
        file_.fail(node,
                   "takes " + name + ", where it captures " + inQuotes(text) + ": this is no whole number of 32 bits");
      const std::int64_t by = file_.integer(node, multiplier, 1, kMin, kMax);
      if (by == 0) file_.fail(node, std::string(multiplier) + " is 0, so all its maps would lie at one place");
      return static_cast<double>((isNumber ? *number : 0) * by + file_.integer(node, offset, 0, kMin, kMax));
    };
    place(node, name, {along(at[0], "multiplierX", "offsetX"), along(at[1], "multiplierY", "offsetY")});
  }

  /// A copy of a map, such as "1-2.tmx.bak", fits what its map fits, unless the pattern has an end.
  void noteSamePlaces(std::size_t from, const std::string& pattern) {
    std::map<std::pair<double, double>, std::string> at;
    for (std::size_t k = from; k < maps_.size(); ++k) {
      const auto [first, isNew] = at.try_emplace({maps_[k].offset.x, maps_[k].offset.y}, maps_[k].file);
      if (isNew) continue;
      notes_.push_back("the pattern " + pattern + " puts " + first->second + " and " + maps_[k].file +
                       " at one place. If one is a copy, end the pattern with $");
    }
  }

  const XmlFile& file_;
  const FolderLister& lister_;
  std::vector<std::string>& notes_;
  std::vector<std::string> names_;
  std::uint64_t stepsLeft_ = kMaxPatternSteps;
  std::set<std::string> known_;  // paths
  std::vector<MapPlace> maps_;
};

}  // namespace

std::vector<MapPlace> mapsOf(const XmlFile& file, const FolderLister& lister, std::vector<std::string>& notes) {
  return WorldMaps(file, lister, notes).read();
}

}  // namespace lgs::tiled
