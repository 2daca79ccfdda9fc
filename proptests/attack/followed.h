// Worlds with all that follows them, in C++ and in C, and what they must show. They are worlds of their own, since a view
// has to be told each commit. The doors leave them in step; what is said out of step is said to a copy.
#pragma once

#include "scene.h"

#include <lgs/hashes.h>
#include <lgs/islands.h>
#include <lgs/lgs_views.h>
#include <lgs/pieces.h>

#include <optional>

namespace lgs::test {

/// A floor of two blocks, with a hole in it, and a rock above it; cut once. And another world with its views.
struct Followed {
  Followed();
  void follow(const Changes& changes);
  /// As a game does it: each commit is told to all.
  void commit() { follow(Changes(world.commit())); }

  World world, other;
  Changes early, last;
  std::optional<Loops> loops;
  std::optional<Islands> islands;
  std::optional<Pieces> pieces;
  std::optional<GroundHashes> hashes;
};
/// That of a scene; made when it is asked for.
Followed& followedBy(Scene& scene);

struct FreeView {
  void operator()(lgs_islands* view) const { lgs_islands_free(view); }
  void operator()(lgs_pieces* view) const { lgs_pieces_free(view); }
  void operator()(lgs_hashes* view) const { lgs_hashes_free(view); }
  void operator()(lgs_body* body) const { lgs_body_free(body); }
  void operator()(lgs_foreseen* foreseen) const { lgs_foreseen_free(foreseen); }
};
template <class T>
using Owned = std::unique_ptr<T, FreeView>;

/// The lists of a commit, which are kept.
struct ListsOfC {
  ListsOfC() = default;
  explicit ListsOfC(const lgs_changes& changes);
  lgs_changes asChanges() const;

  std::vector<lgs_segment_id> removed, added, relinked;
  std::uint64_t before = 0, after = 0;
};

/// The same ground behind the C interface.
struct FollowedC {
  FollowedC();
  /// Commits, and tells it to all.
  void commit();
  /// Makes views anew.
  void begin(lgs_anchor_fn isAnchor);
  lgs_island_id anIsland() const;

  CWorld world, other;
  lgs_shape_id square{};
  Owned<lgs_islands> islands;
  Owned<lgs_pieces> pieces;
  Owned<lgs_hashes> hashes;
  Owned<lgs_body> body;
  ListsOfC early, last;
};
FollowedC& followedInCBy(Scene& scene);

/// What holds an island in these worlds.
inline bool isBedrock(Block block) { return block == 1; }

/// That all views show what is recomputed from the ground, by code that shares nothing with them; those of C what those
/// of C++ show that begin now.
void expectViewsAreRight(const Scene& scene);

}  // namespace lgs::test
