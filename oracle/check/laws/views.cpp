// Law 15: views of loops, islands, pieces and hashes that follow the world are their full recompute, until a chunk leaves
// memory: the recompute knows what is there alone.
#include "oracle/check/laws/list.h"
#include "oracle/views/ground_hashes.h"
#include "oracle/views/island_check.h"
#include "oracle/views/piece_check.h"

namespace lgs::oracle {
namespace {

// Some polygons hold their islands, wherever they are.
bool isAnchor(Block block, Cell cell) { return block % 3 == 1 || (std::int64_t{cell.i} + cell.j) % 5 == 0; }

class ViewsLaw : public Law {
 public:
  void begin(Seen& seen) override { isAsked_ = seen.options.views && begins(seen); }

  Found after(Seen& seen, const Judged& judged, bool isRefused) override {
    using enum Call::Kind;
    const Call::Kind kind = judged.call.kind;
    isAsked_ = isAsked_ && !seen.wasAway;
    if (!isAsked_ || isRefused) return std::nullopt;
    if (kind == load || kind == Call::Kind::follow) {  // a world that was loaded follows nothing
      views_.reset();
      isAsked_ = begins(seen);
    }
    return std::nullopt;
  }

  Found afterTravel(Seen& seen) override {
    if (seen.isPending()) views_.reset();  // what follows from the outline of then is not that of the polygons
    return isAsked_ && views_ ? look(seen) : std::nullopt;
  }

  Found afterCommit(Seen& seen) override {
    if (!isAsked_) return std::nullopt;
    if (views_) return look(seen);
    const World& world = seen.world();
    views_.emplace(
        Followed{Islands(world, isAnchor), IslandCheck(isAnchor), Pieces(world), PieceCheck(), GroundHashes(world)});
    auto wrong = views_->islandCheck.begin(world, views_->islands);
    if (!wrong) wrong = views_->pieceCheck.begin(world, views_->pieces);
    return wrong ? Found(seen.mismatch(Mismatch::Kind::views, std::move(*wrong))) : std::nullopt;
  }

 private:
  static bool begins(Seen& seen) { return seen.world().followCells(true).has_value(); }

  Found look(Seen& seen) {
    const World& world = seen.world();
    auto& [islands, islandCheck, pieces, pieceCheck, hashes] = *views_;
    if (!islands.update(world, seen.library->changes()))
      return seen.mismatch(Mismatch::Kind::views, "the views refuse what was committed");
    hashes.update(world.cellChanges());
    auto wrong = islandCheck.update(world, islands);
    if (!wrong) wrong = pieceCheck.update(world, pieces, pieces.update(world.cellChanges()));
    if (!wrong) wrong = faultOf(hashes, world);
    return wrong ? Found(seen.mismatch(Mismatch::Kind::views, std::move(*wrong))) : std::nullopt;
  }

  struct Followed {
    Islands islands;
    IslandCheck islandCheck;
    Pieces pieces;
    PieceCheck pieceCheck;
    GroundHashes hashes;
  };
  bool isAsked_ = false;
  std::optional<Followed> views_;
};

}  // namespace

std::unique_ptr<Law> laws::views() { return std::make_unique<ViewsLaw>(); }

}  // namespace lgs::oracle
