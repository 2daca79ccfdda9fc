#include "opened.h"

#include "below.h"
#include "ldtk.h"
#include "world_maps.h"

#include <filesystem>
#include <utility>

namespace lgs::tiled {

Opened::Opened(const std::string& path, const Options& options, const FileReader& reader, const FolderLister& lister)
    : path_(path),
      options_(options),
      reader_(reader),
      guarded_([this](const std::string& name) { return read(name); }),
      budget_(options) {
  auto file = std::make_unique<const XmlFile>(path, guarded_, "map", error_, Quoting{true, options.filesAnywhere});
  if (error_) return;
  if (std::string_view(file->root().name()) == "world") {
    world_ = std::move(file);
    openWorld(lister);
  } else {
    maps_.push_back(std::make_unique<MapSource>(std::move(file), MapPlace{}, options, guarded_, error_));
  }
}

tl::expected<std::string, std::string> Opened::read(const std::string& name) {
  const std::string folder = options_.filesIn.empty() ? folderOf(path_) : options_.filesIn;
  if (!options_.filesAnywhere && name != path_ && !liesBelow(folder, name)) {
    return tl::unexpected("it is not in the folder " + (folder.empty() ? "." : folder) +
                          ". If the map can be trusted: Options::filesIn = " + folderOfBoth(path_, name));
  }
  auto text = reader_(name);
  if (text && !budget_.read(text->size())) {
    return tl::unexpected<std::string>("the files of the map are larger together than the limit (Options::maxBytes)");
  }
  return text;
}

/// Opens a map of a world. Null if it cannot be read and may be missing, or if there is a problem.
std::unique_ptr<const XmlFile> Opened::openMapOf(const WorldMap& entry) {
  auto file = std::make_unique<const XmlFile>(*world_, entry.name, guarded_, "map", error_);
  if (error_ && !file->wasRead()) {  // the world is to blame for naming it
    std::string what = "the map's file " + error_->file + " " + error_->what;
    error_.reset();
    if (!file->isMissing() || options_.allMaps) {
      world_->fail(entry.node, std::move(what));
    } else {
      notes_.push_back("a map of the world is left out: " + what);
      if (!missing_) missing_ = {entry.node, std::move(what)};
    }
    return nullptr;
  }
  if (!file->failed() && (std::string_view(file->root().name()) == "world" || file->root().attribute(kLdtkAttribute))) {
    world_->fail(entry.node, entry.name + " is no map of Tiled's");
  }
  if (const std::string pattern = entry.node.attribute("regexp").value(); file->failed() && !pattern.empty()) {
    error_->what += " (it fits the pattern " + inQuotes(pattern) + " of the world)";  // perhaps by mistake
  }
  if (file->failed()) return nullptr;
  return file;
}

void Opened::openWorld(const FolderLister& lister) {
  for (const WorldMap& entry : mapsOf(*world_, lister, notes_)) {
    if (error_) return;
    auto file = openMapOf(entry);
    if (!file) continue;
    const MapPlace place{std::filesystem::path(entry.name).replace_extension().generic_string(), entry.at};
    maps_.push_back(std::make_unique<MapSource>(std::move(file), place, options_, guarded_, error_));
    if (error_) return;
    maps_.back()->entry = entry;
  }
  if (maps_.empty() && missing_) world_->fail(missing_->first, missing_->second);
}

tl::expected<ImportedMap, ImportError> Opened::import(const Options& options, Budget& budget, std::size_t& tiles,
                                                      std::size_t& placements) {
  Options settled = options;
  std::vector<std::string> notes = notes_;
  const XmlFile& file = world_ ? *world_ : *maps_.front()->file;
  if (file.root().attribute(kLdtkAttribute)) settleLdtk(file, settled, notes);
  if (error_) return tl::unexpected(*error_);
  ImportJob job{std::move(settled), budget};
  job.tilesLeft = tiles;
  job.placementsLeft = placements;
  auto map = world_ ? importWorld(file, maps_, job, error_) : importOne(*maps_.front(), job, error_);
  tiles = job.tilesLeft;
  placements = job.placementsLeft;
  if (!map) return map;
  job.names.checkAll(file);
  if (error_) return tl::unexpected(*error_);
  map->report.notes.insert(map->report.notes.begin(), notes.begin(), notes.end());
  for (std::string& note : job.asked.notes()) map->report.notes.push_back(std::move(note));
  return map;
}

}  // namespace lgs::tiled
