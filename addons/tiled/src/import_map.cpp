// An import from its beginning to its end: the files are opened, the evidence in them is weighed, the strongest choice
// that gives a world is taken, and what else could be taken is tried.
#include "evidence.h"
#include "opened.h"

#include <algorithm>
#include <set>
#include <utility>

namespace lgs::tiled {
namespace {

using Imported = tl::expected<ImportedMap, ImportError>;

/// Whether two maps have the same polygons, whatever their blocks.
bool isSameGround(const ImportedMap& a, const ImportedMap& b) {
  return std::equal(a.placements.begin(), a.placements.end(), b.placements.begin(), b.placements.end(),
                    [&](const MapPolygon& p, const MapPolygon& q) {
                      return p.cell == q.cell && a.shapes[p.shape] == b.shapes[q.shape];
                    });
}

/// Nothing of a map is taken, but its report stays.
void forget(ImportedMap& map) {
  map.placements.clear();
  map.shapes.clear();
  map.report.polygons = map.report.cells = map.report.shapes = 0;
  map.report.blocks.clear();
}

void join(std::string& list, const std::string& text) { list += (list.empty() ? "" : "; ") + text; }

class WholeImport {
 public:
  WholeImport(Opened& opened, const Options& options) : opened_(opened), options_(options) {}

  Imported run() {
    if (leaveChoice(options_)) takeCensus();
    if (opened_.error()) return tl::unexpected(*opened_.error());
    Imported map = take();
    if (!map) return map;
    if (map->placements.empty()) {
      if (!leaveChoice(options_)) takeCensus();
      offerAll(*map);
      opened_.forgive();
    } else if (taken_) {
      tellChoice(map->report);
      offerMissed(*map);
    }
    return map;
  }

 private:
  void takeCensus() {
    std::size_t tiles = options_.maxTiles;
    if (!opened_.error()) facts_ = census(opened_.maps(), options_, tiles);
    choices_ = choices(facts_, options_);
  }

  /// Takes the strongest choice that gives anything; or what the options say.
  Imported take() {
    for (const Choice& choice : choices_) {
      if (!isTakenByItself(choice)) continue;
      Imported map = import(choice.options);
      if (!map) return map;
      if (!map->placements.empty()) {
        taken_ = choice;
        return map;
      }
    }
    Imported map = import(options_);
    if (map && leaveChoice(options_)) forget(*map);
    return map;
  }

  Imported import(const Options& options) {
    std::size_t tiles = options.maxTiles, placements = options.maxPlacements;
    return opened_.import(options, opened_.budget(), tiles, placements);
  }

  void tellChoice(Report& report) const {
    std::string words;
    for (const std::string& argument : choosingArguments(taken_->options)) words += " " + shellWord(argument);
    report.choice = taken_->text + (words.empty() ? "" : " (" + words.substr(1) + ")");
    for (const auto& [what, passable] : facts_.passable) {
      const std::vector<std::string>& names = taken_->options.leaveOut;
      if (passable.areSquares && std::find(names.begin(), names.end(), what) == names.end()) continue;
      report.leftOut += (report.leftOut.empty() ? "" : ", ") + what + " (" + std::to_string(passable.uses) + ")";
    }
  }

  /// Offers what options give, unless it is the same as what was taken or cannot be had. All that is tried shares what
  /// one import may cost.
  void offer(ImportedMap& map, Options options, const std::string& text, bool isDecided = true) {
    if (isDecided && leaveChoice(options))
      options.objects = namesOfSaying(facts_);  // so that it is not the map that decides
    std::vector<std::string> arguments = choosingArguments(options);
    if (isSpent_ || tried_ == kMaxSuggestions || !offered_.insert(arguments).second) return;
    ++tried_;
    Budget budget = opened_.budget();
    const Imported other = opened_.import(options, budget, tilesLeft_, placementsLeft_);
    isSpent_ = budget.isOutOfWork() || budget.isOutOfCells();
    if (!isSpent_) opened_.budget() = budget;
    opened_.forgive();
    if (other && !other->placements.empty() && !isSameGround(map, *other))
      map.report.suggestions.push_back({text, std::move(arguments), other->placements.size()});
  }

  void offerAll(ImportedMap& map) {
    if (!facts_.hidden.empty()) offerHidden(map);
    for (const Choice& choice : choices_) offer(map, choice.options, choice.text);
  }

  /// What is hidden, if it was to be left out: all that would be taken without that.
  void offerHidden(ImportedMap& map) {
    Options options = options_;
    options.visibleOnly = false;
    std::size_t tiles = options.maxTiles;
    std::vector<Choice> all = choices(census(opened_.maps(), options, tiles), options);
    opened_.forgive();
    if (!leaveChoice(options)) all.insert(all.begin(), Choice{Evidence::solid, options, ""});
    const std::size_t layers = facts_.hidden.size(), before = map.report.suggestions.size();
    const std::string text = counted(layers, "layer") + (layers == 1 ? " is" : " are") +
                             " hidden, and --visible leaves " + (layers == 1 ? "it" : "them") +
                             " out: " + listed(facts_.hidden);
    for (const Choice& choice : all) {
      if (!isTakenByItself(choice) || map.report.suggestions.size() > before) continue;
      offer(map, choice.options, text, false);
    }
  }

  /// What else says that it is solid; and if none of that is an offer, the next best choice.
  void offerMissed(ImportedMap& map) {
    offered_.insert(choosingArguments(taken_->options));
    Report& report = map.report;
    const double cells = static_cast<double>(report.width) * report.height;
    if (taken_->evidence != Evidence::solid && !report.infinite && static_cast<double>(report.cells) < 0.03 * cells)
      join(report.partial, "it is less than 3 % of the map");
    for (const Missed& part : missed(facts_, *taken_, options_)) {
      join(part.isDue ? report.partial : report.also, part.text);
      offer(map, part.options, part.offer);
    }
    for (const Choice& choice : choices_)
      if (report.suggestions.empty()) offer(map, choice.options, choice.text);
  }

  Opened& opened_;
  const Options& options_;
  Facts facts_;
  std::vector<Choice> choices_;
  std::optional<Choice> taken_;
  std::size_t tilesLeft_ = options_.maxTiles, placementsLeft_ = options_.maxPlacements;  // for all that is tried
  std::size_t tried_ = 0;
  bool isSpent_ = false;
  std::set<std::vector<std::string>> offered_;
};

}  // namespace

std::optional<Block> ImportedMap::block(const std::string& name) const {
  const auto found = blocks.find(name);
  return found == blocks.end() ? std::nullopt : std::optional(found->second);
}

Imported importMap(const std::string& path, const Options& options, const FileReader& reader,
                   const FolderLister& lister) {
  Opened opened(path, options, reader, lister);
  return WholeImport(opened, options).run();
}

}  // namespace lgs::tiled
