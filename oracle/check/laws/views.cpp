// Law 15: views of loops, islands, pieces and hashes that follow the world are their full recompute. Where chunks leave
// memory islands are held against the ground with what is unloaded, and those that end there against what is loaded.
#include "oracle/check/laws/list.h"
#include "oracle/views/beyond_check.h"
#include "oracle/views/ground_hashes.h"
#include "oracle/views/island_check.h"
#include "oracle/views/piece_check.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

namespace lgs::oracle {
namespace {

class ViewsLaw : public Law {
 public:
  void begin(Seen& seen) override {
    streams_ = std::ranges::any_of(seen.trace.calls, [](const Call& call) { return isOfMemory(call.kind); });
    isAsked_ = seen.options.views && begins(seen);
  }

  void before(Seen& seen, const Judged& judged) override {
    if (views_ && judged.call.kind == Call::Kind::leave) away_ = chunksAway(seen);
    const bool turns = isOfMemory(judged.call.kind) && seen.isPending();
    if (turns && !seen.trace.preserve.empty()) views_.reset();  // they ask for a commit
  }

  Found after(Seen& seen, const Judged& judged, bool isRefused) override {
    using enum Call::Kind;
    const Call::Kind kind = judged.call.kind;
    if (!isAsked_ || isRefused) return std::nullopt;
    if (kind == load || kind == Call::Kind::follow) {  // a world that was loaded follows nothing
      views_.reset();
      isAsked_ = begins(seen);
    }
    if (kind == foresee && !seen.trace.preserve.empty()) views_.reset();  // it rolls back
    if (views_ && kind == leave)
      std::ranges::set_difference(away_, chunksAway(seen), std::inserter(forgotten_, forgotten_.end()));
    return std::nullopt;
  }

  Found afterTravel(Seen& seen) override {
    if (views_ && seen.world().hasUncommitted() && views_->islands.update(seen.world(), seen.library->changes()))
      return seen.mismatch(Mismatch::Kind::views, "islands take a moment at which edits are pending");
    if (seen.isPending()) views_.reset();  // what follows from the outline of then is not the polygons'
    lookAway(seen);
    return isAsked_ && views_ ? look(seen) : std::nullopt;
  }

  Found afterCommit(Seen& seen) override {
    if (!isAsked_) return std::nullopt;
    if (views_) return look(seen);
    lookAway(seen);
    const World& world = seen.world();
    const std::size_t most = seen.trace.preserve.empty() ? 4 : 8;  // small ones come to their limit
    views_.emplace(Followed{Islands(world, isAnchorOfView),
                            IslandCheck(isAnchorOfView),
                            BeyondCheck(isAnchorOfView),
                            Pieces(world, {most}),
                            PieceCheck(),
                            GroundHashes(world),
                            {}});
    const Islands& islands = views_->islands;
    if (streams_) views_->open.emplace(Islands(world, isAnchorOfView, AtEdge::open), IslandCheck(isAnchorOfView));
    auto wrong = streams_ ? said(views_->beyondCheck.begin(world, ground(seen), islands))
                          : views_->islandCheck.begin(world, islands);
    if (!wrong && views_->open) wrong = views_->open->second.begin(world, views_->open->first);
    if (!wrong) wrong = views_->pieceCheck.begin(world, views_->pieces);
    return wrong ? Found(seen.mismatch(Mismatch::Kind::views, std::move(*wrong))) : std::nullopt;
  }

  Found atEnd(Seen& seen) override {
    auto wrong = views_ ? faultOfRounds(views_->hashes) : std::nullopt;
    return wrong ? Found(seen.mismatch(Mismatch::Kind::views, std::move(*wrong))) : std::nullopt;
  }

 private:
  using Wrong = std::optional<std::string>;
  static Wrong said(std::string wrong) { return wrong.empty() ? Wrong() : Wrong(std::move(wrong)); }

  static std::set<Cell> chunksAway(const Seen& seen) {
    std::set<Cell> corners;
    for (const Cell chunk : seen.model().chunksAway()) corners.insert(Model::cellsOfChunk(chunk).min);
    return corners;
  }

  // Under a preserve relation a view that begins, or that a roll-back moves, takes unloaded ground for solid.
  void lookAway(const Seen& seen) {
    if (!seen.trace.preserve.empty()) unknown_ = chunksAway(seen);
  }

  WholeGround ground(const Seen& seen) {
    WholeGround all{{}, chunksAway(seen), std::exchange(forgotten_, {})};
    hasReturned_ = std::erase_if(unknown_, [&](Cell chunk) { return !all.away.contains(chunk); }) != 0;
    const auto isUnknown = [&](Cell cell) { return unknown_.contains({cell.i & ~31, cell.j & ~31}); };
    const Scene scene = seen.scene();
    CellSet cells = unknown_;
    for (const ScenePolygon& p : scene.polygons) {
      if (isUnknown(p.cell)) continue;
      all.polygons.push_back(p);
      cells.insert(p.cell);
    }
    for (const Cell cell : around(cells))
      if (isUnknown(cell)) all.polygons.push_back({cell, 0, {kUnitSquare.begin(), kUnitSquare.end()}});
    return all;
  }

  static bool begins(Seen& seen) { return seen.world().followCells(true).has_value(); }

  Found look(Seen& seen) {
    const World& world = seen.world();
    auto& [islands, islandCheck, beyondCheck, pieces, pieceCheck, hashes, open] = *views_;
    const Changes& changes = seen.library->changes();
    if (!islands.update(world, changes) || !pieces.update(world, changes) || !hashes.update(world, changes) ||
        (open && !open->first.update(world, changes)))
      return seen.mismatch(Mismatch::Kind::views, "the views refuse what was committed");
    const bool isOther = changes.before != changes.after;
    if (isOther && (islands.update(world, changes) || pieces.update(world, changes) || hashes.update(world, changes)))
      return seen.mismatch(Mismatch::Kind::views, "a view takes what does not lead from what it saw last");
    if (!isOther && !world.cellChanges().empty())
      return seen.mismatch(Mismatch::Kind::views, "the ground changed, and who missed that does not see it");
    // No law says what views tell where ground returns that they took for solid.
    const WholeGround whole = ground(seen);
    auto wrong =
        streams_ ? said(beyondCheck.update(world, whole, islands, !hasReturned_)) : islandCheck.update(world, islands);
    if (!wrong && open) wrong = open->second.update(world, open->first);
    if (!wrong) wrong = pieceCheck.update(world, pieces, pieces.changed());
    if (!wrong) wrong = faultOf(hashes, world);
    return wrong ? Found(seen.mismatch(Mismatch::Kind::views, std::move(*wrong))) : std::nullopt;
  }

  struct Followed {
    Islands islands;
    IslandCheck islandCheck;
    BeyondCheck beyondCheck;
    Pieces pieces;
    PieceCheck pieceCheck;
    GroundHashes hashes;
    /// With an edge of memory that is open: then it is what a look at the loaded ground gives.
    std::optional<std::pair<Islands, IslandCheck>> open;
  };
  bool streams_ = false;  // chunks may leave memory
  bool isAsked_ = false;
  std::set<Cell> away_, forgotten_;  // chunks before the last call; those that were forgotten since the last look
  std::set<Cell> unknown_;           // those that are away, and solid for all that the views know
  bool hasReturned_ = false;         // some of these, since the last look
  std::optional<Followed> views_;
};

}  // namespace

std::unique_ptr<Law> laws::views() { return std::make_unique<ViewsLaw>(); }

}  // namespace lgs::oracle
