// This library's engine as an engine. What only it shows, the laws ask of its player (law.h).
#pragma once

#include "oracle/check/window.h"
#include "oracle/engine/engine.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"

#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::oracle {

class LibraryEngine : public Engine {
 public:
  LibraryEngine() { introduce("LocalGridSeg", Capabilities::all()); }

  void reset(const PreservePairs& preserve) override;
  void add(const std::string& name, const ScenePolygon& polygon) override;
  void remove(const std::string& name) override;
  void stroke(const BrushEdit& brush) override;
  Refusals commit() override;
  Outline outline() const override { return outlineOf(player_->world()); }

  /// The segments of these cells.
  Outline outlineIn(const CellSet& cells) const;

  /// Makes a call that is no commit. What is judged here is a group as it stands, or another call (Player::judge()).
  tl::expected<void, TraceError> apply(const Judged& judged);

  /// By which executor the next commit is made (caller.h).
  void useExecutor(std::uint32_t number) { executor_ = number; }

  /// Of the last commit, or of a roll-back or redo.
  const Changes& changes() const { return *changes_; }

  Player& player() { return *player_; }
  const Player& player() const { return *player_; }
  const Model& model() const { return player_->model(); }

 private:
  std::optional<Player> player_;
  const Changes* changes_ = nullptr;
  std::vector<RefusedEdit> refused_;  // since the last commit
  std::uint32_t executor_ = 0;
};

}  // namespace lgs::oracle
