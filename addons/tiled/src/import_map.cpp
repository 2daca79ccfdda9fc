// An import from its beginning to its end: the files are opened, the evidence in them is weighed, the strongest choice
// that gives a world is taken, and what else could be taken is tried.
#include "evidence.h"
#include "ldtk.h"

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

class WholeImport {
 public:
  WholeImport(const std::string& path, const Options& options, const FileReader& reader, const FolderLister& lister)
      : path_(path), options_(options), ofUser_(reader), lister_(lister), budget_(options) {}

  Imported run() {
    open();
    if (leaveChoice(options_)) takeCensus();
    if (error_) return tl::unexpected(*error_);
    Imported map = take();
    if (!map) return map;
    if (missing_) join(map->report.partial, missing_->second);
    budget_.refill(options_);
    if (map->placements.empty()) {
      if (!leaveChoice(options_)) takeCensus();
      offerAll(*map);
    } else if (taken_) {
      tellChoice(map->report);
      offerMissed(*map);
    } else {
      tellLines(map->report);
    }
    return map;
  }

 private:
  void takeCensus() {
    if (!error_) facts_ = census(maps_, options_);
    choices_ = choices(facts_, options_);
  }

  /// Takes the strongest choice that gives anything; or what the options say.
  Imported take() {
    for (const Choice& choice : choices_) {
      if (!isTakenByItself(choice)) continue;
      budget_.refill(options_);
      Imported map = import(choice.options, budget_);
      if (!map) return map;
      if (map->placements.empty() || isOutweighed(choice, map->report)) continue;
      taken_ = choice;
      return map;
    }
    budget_.refill(options_);
    Imported map = import(options_, budget_);
    if (map && leaveChoice(options_)) forget(*map);
    return map;
  }

  static bool isLittle(const Report& report) {
    return !report.infinite && static_cast<double>(report.cells) < 0.03 * report.width * report.height;
  }

  /// Whether what says ground is next to nothing beside the only layer, of which it may be the slopes.
  bool isOutweighed(const Choice& choice, const Report& report) const {
    const LayerFacts* const only = onlyLayer(facts_);
    return choice.evidence == Evidence::ground && only && only->saying.says == Says::nothing && isLittle(report) &&
           only->tiles > 4 * report.cells;
  }

  /// One pass with these options. What it takes of the budget is gone for the next.
  Imported import(const Options& options, Budget& budget) {
    Options settled = options;
    std::vector<std::string> notes = notes_;
    const XmlFile& file = world_ ? *world_ : *maps_.front()->file;
    if (file.root().attribute(kLdtkAttribute)) settleLdtk(file, settled, notes);
    if (error_) return tl::unexpected(*error_);
    Imported map = importMaps(file, maps_, settled, budget);
    if (map) map->report.notes.insert(map->report.notes.begin(), notes.begin(), notes.end());
    return map;
  }

  void tellChoice(Report& report) const {
    std::string words;
    for (const std::string& argument : choosingArguments(taken_->options)) join(words, shellWord(argument), " ");
    report.choice = taken_->text + (words.empty() ? "" : " (" + words + ")");
    for (const auto& [what, passable] : facts_.passable)
      if (!passable.areSquares || has(taken_->options.leaveOut, what))
        join(report.leftOut, concat(what, " (", passable.uses, ")"), ", ");
  }

  /// Of the layers that the options chose, open polylines are the part that may be missed.
  static void tellLines(Report& report) {
    for (const LayerReport& layer : report.layers) {
      const auto lines = std::count_if(layer.notes.begin(), layer.notes.end(), [](const Note& note) {
        return note.kind == NoteKind::leftOut && note.text.starts_with(kNoArea);
      });
      if (lines > 0) join(report.partial, linesLeftOut(layer.path, static_cast<std::uint64_t>(lines)));
    }
  }

  /// Offers what options give, unless it cannot be had. All that is tried shares what one import may cost. Returns false
  /// if it is the same as what was taken.
  bool offer(ImportedMap& map, Options options, const std::string& text, bool isDecided = true) {
    if (isDecided && leaveChoice(options))
      options.objects = namesOfSaying(facts_);  // so that it is not the map that decides
    std::vector<std::string> arguments = choosingArguments(options);
    if (isSpent_ || tried_ == kMaxSuggestions || !offered_.insert(arguments).second) return true;
    ++tried_;
    Budget budget = budget_;
    const Imported other = import(options, budget);
    isSpent_ = budget.isOutOfWork() || budget.isOutOfCells();
    if (!isSpent_) budget_ = budget;
    error_.reset();  // nothing but an offer that is not made
    if (!other || other->placements.empty()) return true;
    if (isSameGround(map, *other)) return false;
    map.report.suggestions.push_back({text, std::move(arguments), other->placements.size(), std::move(options)});
    return true;
  }

  /// All that could be taken; first what is hidden, if it was to be left out.
  void offerAll(ImportedMap& map) {
    if (options_.visibleOnly) {
      Options options = options_;
      options.visibleOnly = false;
      std::vector<Choice> all = choices(census(maps_, options), options);
      error_.reset();
      if (!leaveChoice(options)) all = {{Evidence::solid, options, "what was asked for"}};
      for (const Choice& choice : all)
        if (isTakenByItself(choice) && map.report.suggestions.empty())
          offer(map, choice.options, "hidden, and --visible leaves it out: " + choice.text, false);
    }
    const auto lines = std::find_if(facts_.layers.begin(), facts_.layers.end(), [](const LayerFacts& layer) {
      return layer.lines > 0 && layer.saying.says != Says::nothing && !layer.uses.isPassable;
    });
    if (lines != facts_.layers.end() && options_.polylineThickness == 0) {
      Options thick = options_;
      thick.objects = namesOfSaying(facts_);
      thick.polylineThickness = kLineThickness;
      offer(map, std::move(thick), "object layer " + lines->name + ": " + lines->why + "; its polylines made thick");
    }
    for (const Choice& choice : choices_) offer(map, choice.options, choice.text);
  }

  /// What else says that it is solid; if none of that is an offer, the next best choice that something speaks for; then
  /// what is only there, and at last any other choice.
  void offerMissed(ImportedMap& map) {
    offered_.insert(choosingArguments(taken_->options));
    Report& report = map.report;
    if (isLittle(report) && (taken_->evidence != Evidence::solid || onlyLayer(facts_)))
      join(report.partial, "it is less than 3 % of the map");
    const std::vector<Missed> parts = missed(facts_, *taken_, options_, report);
    for (const bool isSaid : {true, false}) {
      for (const Missed& part : parts)
        if (part.isSaid == isSaid && offer(map, part.options, part.offer))
          join(part.isDue ? report.partial : report.also, part.text);
      for (const Choice& choice : choices_)
        if (report.suggestions.empty() && (isTakenByItself(choice) || !isSaid)) offer(map, choice.options, choice.text);
    }
  }

  /// Reads the map, and what it names. A problem is kept.
  void open() {
    auto file = std::make_unique<const XmlFile>(path_, reader_, error_, options_.filesAnywhere);
    if (error_) return;
    if (std::string_view(file->root().name()) == "world") {
      world_ = std::move(file);
      openWorld();
    } else {
      maps_.push_back(std::make_unique<MapSource>(std::move(file), MapPlace{}, options_));
    }
  }

  tl::expected<std::string, std::string> read(const std::string& name) {
    const std::string folder = options_.filesIn.empty() ? folderOf(path_) : options_.filesIn;
    if (!options_.filesAnywhere && name != path_ && !liesBelow(folder, name)) {
      return tl::unexpected(concat(kNotInFolder, folder.empty() ? "." : folder,
                                   ". If the map can be trusted: Options::filesIn = ", folderOfBoth(path_, name)));
    }
    auto text = ofUser_(name);
    if (text && !budget_.read(text->size())) {
      return tl::unexpected<std::string>("the files of the map are larger together than the limit (Options::maxBytes)");
    }
    return text;
  }

  /// Opens a map of a world. It may be missing.
  void openMapOf(const MapPlace& entry) {
    auto file = std::make_unique<const XmlFile>(*world_, entry.file, "map", error_);
    if (std::string what = file->takeReason("map"); !what.empty()) {
      if (!file->isMissing() || options_.allMaps) return world_->fail(entry.entry, std::move(what));
      notes_.push_back("a map of the world is left out: " + what);
      if (!missing_) missing_ = {entry.entry, std::move(what)};
      return;
    }
    if (!error_ && (std::string_view(file->root().name()) == "world" || file->root().attribute(kLdtkAttribute)))
      world_->fail(entry.entry, entry.file + " is no map of Tiled's");
    if (const std::string pattern = entry.entry.attribute("regexp").value(); error_ && !pattern.empty())
      error_->what += " (it fits the pattern " + inQuotes(pattern) + " of the world)";  // perhaps by mistake
    if (!error_) maps_.push_back(std::make_unique<MapSource>(std::move(file), entry, options_));
  }

  void openWorld() {
    for (const MapPlace& entry : mapsOf(*world_, lister_, notes_))
      if (!error_) openMapOf(entry);
    if (maps_.empty() && missing_) world_->fail(missing_->first, missing_->second);
  }

  const std::string& path_;
  const Options& options_;
  const FileReader& ofUser_;
  const FolderLister& lister_;
  const FileReader reader_ = [this](const std::string& name) { return read(name); };
  Budget budget_;
  std::optional<ImportError> error_;
  std::vector<std::string> notes_;
  std::optional<std::pair<pugi::xml_node, std::string>> missing_;  // the first map of a world that cannot be read
  std::unique_ptr<const XmlFile> world_;                           // null for a map by itself
  Maps maps_;
  Facts facts_;
  std::vector<Choice> choices_;
  std::optional<Choice> taken_;
  std::size_t tried_ = 0;
  bool isSpent_ = false;
  std::set<std::vector<std::string>> offered_;
};

}  // namespace

MapSource::MapSource(std::unique_ptr<const XmlFile> map, MapPlace where, const Options& options)
    : file(std::move(map)), place(std::move(where)) {
  const auto root = file->root();
  const std::string_view orientation = root.attribute("orientation").value();
  if (!orientation.empty() && orientation != "orthogonal")
    file->fail(root, concat("has the orientation", file->quoted(" ", orientation),
                            ": only orthogonal maps have square cells"));
  if (!file->failed()) tilesets = readTilesets(*file, templates, options.tiles);
}

std::optional<Block> ImportedMap::block(const std::string& name) const {
  const auto found = blocks.find(name);
  return found == blocks.end() ? std::nullopt : std::optional(found->second);
}

Imported importMap(const std::string& path, const Options& options, const FileReader& reader,
                   const FolderLister& lister) {
  return WholeImport(path, options, reader, lister).run();
}

}  // namespace lgs::tiled
