// An import from its beginning to its end: the files are opened, the evidence in them is weighed, the strongest choice
// that gives a world is taken, and what else could be taken is tried.
#include "evidence.h"
#include "opened.h"

#include <set>
#include <utility>

namespace lgs::tiled {
namespace {

using Imported = tl::expected<ImportedMap, ImportError>;

/// Arguments as a shell takes them, each after a blank.
std::string commandLine(const std::vector<std::string>& arguments) {
  std::string result;
  for (const std::string& argument : arguments) result += " " + shellWord(argument);
  return result;
}

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
      offerAll(map->report);
      opened_.forgive();
    } else if (taken_) {
      tellChoice(map->report);
      offerMissed(map->report);
      tellSilent(map->report);
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
    return import(options_);
  }

  Imported import(const Options& options) {
    std::size_t tiles = options.maxTiles, placements = options.maxPlacements;
    return opened_.import(options, opened_.budget(), tiles, placements);
  }

  void tellChoice(Report& report) const {
    const std::vector<std::string> arguments = choosingArguments(taken_->options);
    if (arguments == choosingArguments(options_)) return;
    report.choice = taken_->text + " (" + commandLine(arguments).substr(1) + ")";
  }

  /// How many polygons a choice gives; 0 if it cannot be had. All that is tried shares what one import may cost.
  std::uint64_t polygonsOf(const Options& options) {
    if (isSpent_ || tried_ == kMaxSuggestions) return 0;
    ++tried_;
    Budget budget = opened_.budget();
    const Imported map = opened_.import(options, budget, tilesLeft_, placementsLeft_);
    isSpent_ = budget.isOutOfWork() || budget.isOutOfCells();
    if (!isSpent_) opened_.budget() = budget;
    opened_.forgive();
    return map ? map->placements.size() : 0;
  }

  void offer(Report& report, const Options& options, const std::string& text) {
    std::vector<std::string> arguments = choosingArguments(options);
    if (!offered_.insert(arguments).second) return;
    const std::uint64_t polygons = polygonsOf(options);
    if (polygons > 0 && polygons != report.polygons)
      report.suggestions.push_back({text, std::move(arguments), polygons});
  }

  void offerAll(Report& report) {
    if (!facts_.hidden.empty()) offerHidden(report);
    for (const Choice& choice : choices_) offer(report, choice.options, choice.text);
  }

  /// What is hidden, if it was to be left out: all that would be taken without that.
  void offerHidden(Report& report) {
    Options options = options_;
    options.visibleOnly = false;
    std::size_t tiles = options.maxTiles;
    std::vector<Choice> all = choices(census(opened_.maps(), options, tiles), options);
    opened_.forgive();
    if (!leaveChoice(options)) all.insert(all.begin(), Choice{Evidence::shapes, options, ""});
    const std::size_t layers = facts_.hidden.size(), before = report.suggestions.size();
    const std::string text = counted(layers, "layer") + (layers == 1 ? " is" : " are") +
                             " hidden, and --visible leaves " + (layers == 1 ? "it" : "them") +
                             " out: " + listed(facts_.hidden);
    for (const Choice& choice : all) {
      if (!isTakenByItself(choice) || report.suggestions.size() > before) continue;
      offer(report, choice.options, text);
    }
  }

  void offerMissed(Report& report) {
    for (const Missed& part : missed(facts_, *taken_, options_)) {
      report.partial += (report.partial.empty() ? "" : "; ") + part.text;
      offer(report, part.options, part.offer);
    }
  }

  void tellSilent(Report& report) const {
    for (const Missed& beside : silentBeside(facts_, *taken_))
      report.notes.push_back(beside.text + ", as nothing says that it is solid; it is with" +
                             commandLine(choosingArguments(beside.options)));
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
