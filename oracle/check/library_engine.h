// This library's engine as an engine, and what is checked of it beyond refusals and the outline:
//  - each call is answered as the model says (model.h); one that is refused changes nothing; a stale handle stays stale;
//  - each commit, and going back and forward: the change list is exact (mirror.h); the polygons of the edited cells read
//    as they were placed;
//  - if it is asked for, views of loops, islands and pieces are held against a full recompute after each commit;
//  - now and then: everything else that a world can be asked (reads.h, questions.h);
//  - at the end: a world in which nothing was undone is the same (observed.h).
#pragma once

#include "oracle/check/checker.h"
#include "oracle/check/reads.h"
#include "oracle/check/window.h"
#include "oracle/engine/engine.h"
#include "oracle/reference/canonical.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/mirror.h"
#include "oracle/trace/player.h"
#include "oracle/views/ground_hashes.h"
#include "oracle/views/island_check.h"
#include "oracle/views/piece_check.h"

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::oracle {

/// What is wrong, beside the outline.
struct Complaint {
  Mismatch::Kind kind{};
  std::string text;
  Outline marked = {};  ///< segments to point out
};

class LibraryEngine : public Engine {
 public:
  LibraryEngine() { introduce("LocalGridSeg", Capabilities::all()); }

  /// From the next reset() on views of loops, islands and pieces follow the world, and are checked after each commit.
  void followViews() { followsViews_ = true; }

  void reset(const PreservePairs& preserve) override;
  void add(const std::string& name, const ScenePolygon& polygon) override;
  void remove(const std::string& name) override;
  Refusals commit() override;
  Outline outline() const override { return outlineOf(player_->world()); }

  /// The segments of these cells.
  Outline outlineIn(const CellSet& cells) const;

  /// Makes a call that is no commit. The error is that of one that is rightly refused.
  tl::expected<std::optional<Complaint>, TraceError> apply(const Call& call, const Judged& judged);

  /// By which executor the next commit is made (caller.h).
  void useExecutor(std::uint32_t number) { executor_ = number; }

  /// To be called after each commit, with the cells edited since the one before.
  std::optional<Complaint> afterCommit(const CellSet& edited);

  /// Asks the world everything. To be called after a commit.
  std::optional<Complaint> readAll(const Outline& whole, std::size_t questions);

  /// To be called at the end.
  std::optional<Complaint> compareWithPast() const;

  /// The loops, collinear vertices dropped.
  Loops loops() const;

  /// The outline of a world that plays a trace and commits once, by an executor. An error if an edit is refused.
  static tl::expected<Outline, TraceError> outlineAtOnce(const Trace& trace);

  const Player& player() const { return *player_; }
  const Model& model() const { return player_->model(); }

 private:
  std::optional<Complaint> afterRefusal(const Call& call, const Stats& before) const;
  std::optional<Complaint> afterTravel(Call::Kind kind);
  std::optional<Complaint> checkViews();
  std::optional<Complaint> checkStale(const std::vector<PolygonHandle>& handles);

  std::optional<Player> player_;
  Mirror mirror_;
  const Changes* changes_ = nullptr;  // of the last commit
  std::vector<PolygonHandle> stale_;  // of all polygons that were removed
  std::vector<RefusedEdit> refused_;  // since the last commit
  bool followsViews_ = false;
  std::uint32_t executor_ = 0;
  bool wasAway_ = false;  // some chunks are not in memory, or were not
  struct Followed {
    Islands islands;
    IslandCheck islandCheck;
    Pieces pieces;
    PieceCheck pieceCheck;
    GroundHashes hashes;
  };
  std::optional<Followed> views_;
};

}  // namespace lgs::oracle
