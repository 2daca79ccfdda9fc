// Plays a trace into a World, edit by edit, and keeps beside it the scene that the edits so far amount to.
#pragma once

#include "oracle/reference/scene.h"
#include "oracle/trace/trace.h"

#include <lgs/world.h>
#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <unordered_map>

namespace lgs::oracle {

class Player {
 public:
  explicit Player(PreservePairs preserve);

  /// Applies an edit of kind add or remove; commits are commit()'s. A refused one leaves everything as it was.
  tl::expected<void, TraceError> apply(const Edit& edit);

  const Changes& commit();

  World& world() { return world_; }
  const World& world() const { return world_; }
  const Scene& scene() const { return scene_; }  ///< uncommitted edits included; in no particular order
  bool pending() const { return pending_; }      ///< edits since the last commit
  bool isAlive(const std::string& name) const { return placed_.contains(name); }
  PolygonHandle handleOf(const std::string& name) const { return placed_.at(name).handle; }  ///< of a name alive

 private:
  struct Placed {
    PolygonHandle handle;
    std::size_t index;  // in scene_.polygons and names_
  };
  tl::expected<void, TraceError> add(const std::string& name, const ScenePolygon& polygon);
  tl::expected<void, TraceError> remove(const std::string& name);

  World world_;
  Scene scene_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, Placed> placed_;
  bool pending_ = false;
};

/// Called after each commit; false stops the play.
using CommitCallback = std::function<bool(Player&, const Changes&)>;

/// Plays all of a trace, and commits what is pending at its end. Stops at the first edit that is refused.
tl::expected<void, TraceError> play(const Trace& trace, Player& player, const CommitCallback& afterCommit = {});

}  // namespace lgs::oracle
