// A scene whose polygons have names: adding and removing one costs the same in a world of any size.
#pragma once

#include "oracle/reference/scene.h"

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace lgs::oracle {

class NamedScene {
 public:
  explicit NamedScene(PreservePairs preserve = {}) { scene_.preserve = std::move(preserve); }

  const Scene& scene() const { return scene_; }  ///< in no particular order
  bool contains(const std::string& name) const { return at_.contains(name); }
  const ScenePolygon& operator[](const std::string& name) const { return scene_.polygons[at_.at(name)]; }

  /// The name must be free.
  void add(const std::string& name, const ScenePolygon& polygon) {
    at_.emplace(name, names_.size());
    names_.push_back(name);
    scene_.polygons.push_back(polygon);
  }

  /// The name must be there. The last polygon takes the place of the one that goes.
  void remove(const std::string& name) {
    const auto found = at_.find(name);
    const std::size_t hole = found->second;
    at_.erase(found);
    if (hole + 1 < names_.size()) {
      at_.at(names_.back()) = hole;
      names_[hole] = std::move(names_.back());
      scene_.polygons[hole] = std::move(scene_.polygons.back());
    }
    names_.pop_back();
    scene_.polygons.pop_back();
  }

 private:
  Scene scene_;
  std::vector<std::string> names_;                   // of scene_.polygons
  std::unordered_map<std::string, std::size_t> at_;  // where in scene_.polygons
};

}  // namespace lgs::oracle
