// Doors of islands of the C interface. The views of a scene go on as a game's would; what is out of step, of another
// world or made up is tried with copies.
#include "c_views.h"

#include <algorithm>
#include <array>

namespace lgs::test {
namespace {

/// An anchor's word, which may be none, or change.
struct AnchorOfC {
  enum { honest, none, lying, reading } which = honest;
  lgs_anchor_fn function() const {
    switch (which) {
      case honest:
        return [](void*, lgs_block block, lgs_cell) -> std::int32_t { return isBedrock(block) ? 1 : 0; };
      case none:
        return nullptr;
      case lying:
        return [](void*, lgs_block, lgs_cell) -> std::int32_t {
          static std::uint32_t calls = 0;
          return ++calls % 3 == 0 ? INT32_MIN : 0;
        };
      default:
        return [](void* user, lgs_block, lgs_cell cell) -> std::int32_t {
          std::int32_t isEmpty = 0;
          static_cast<void>(lgs_is_empty(static_cast<const lgs_world*>(user), cell, &isEmpty));
          return isEmpty;
        };
    }
  }
};

/// What becomes of a world before its views are told.
struct EditOfC {
  enum { build, clear, all, rollBack, nothing, pending, isNotFollowed } which = build;
  static constexpr lgs_cell_rect kRock{{1, 2}, {1, 4}};

  /// False, if a view can not know of it: it may say anything then, but must live.
  bool isHonest() const { return which < pending; }
  void operator()(lgs_world* world, lgs_shape_id square) const {
    lgs_mark mark{};
    switch (which) {
      case build:
        static_cast<void>(lgs_add(world, {1, 2}, square, 2, nullptr, nullptr));
        break;
      case clear:
        EXPECT_EQ(lgs_clear(world, kRock, nullptr, nullptr), LGS_OK);
        break;
      case isNotFollowed:
      case all:
        if (which == isNotFollowed) static_cast<void>(lgs_follow_cells(world, 0, nullptr));
        EXPECT_EQ(lgs_clear(world, {{-9, -9}, {99, 99}}, nullptr, nullptr), LGS_OK);
        break;
      case rollBack:
        EXPECT_EQ(lgs_set_mark(world, &mark), LGS_OK);
        EXPECT_EQ(lgs_clear(world, kRock, nullptr, nullptr), LGS_OK);
        EXPECT_EQ(lgs_roll_back(world, mark, nullptr, nullptr), LGS_OK);
        EXPECT_EQ(lgs_forget(world, mark, nullptr), LGS_OK);
        break;
      default:
        break;
    }
  }
  /// What is not committed when the views are told.
  void afterCommit(lgs_world* world, lgs_shape_id square) const {
    if (which != pending) return;
    EXPECT_EQ(lgs_clear(world, {{-9, -9}, {1, 9}}, nullptr, nullptr), LGS_OK);
    static_cast<void>(lgs_add(world, {40, 40}, square, 1, nullptr, nullptr));
  }
};

/// Lists that a view is told.
struct ToldOfC {
  enum { last, none, early, empty, segments, noLists, ahead } which = last;
  void in(Scene& s, const FollowedC& f, const ListsOfC& lists, lgs_changes& changes) const {
    static std::vector<lgs_segment_id> ids;
    changes = lists.asChanges();
    switch (which) {
      case early:
        changes = f.early.asChanges();
        break;
      case empty:
        changes.removed_count = changes.added_count = changes.relinked_count = 0;
        break;
      case segments:
        ids = idsOf<lgs_segment_id>(s.segments);
        changes.removed = changes.added = changes.relinked = ids.data();
        changes.removed_count = changes.added_count = changes.relinked_count = ids.size();
        break;
      case noLists:
        changes.removed = changes.added = changes.relinked = nullptr;
        changes.added_count = SIZE_MAX;
        break;
      case ahead:
        changes.after = UINT64_MAX;
        break;
      default:
        break;
    }
  }
};

}  // namespace

LGS_VALUES(AnchorOfC, fmt::format("anchor {}", static_cast<int>(v.which)), {AnchorOfC::honest}, {AnchorOfC::none},
           {AnchorOfC::lying}, {AnchorOfC::reading})
LGS_VALUES(EditOfC, fmt::format("edit {}", static_cast<int>(v.which)), {EditOfC::build}, {EditOfC::clear},
           {EditOfC::all}, {EditOfC::rollBack}, {EditOfC::nothing}, {EditOfC::pending}, {EditOfC::isNotFollowed})
LGS_VALUES(ToldOfC, fmt::format("lists {}", static_cast<int>(v.which)), {ToldOfC::last}, {ToldOfC::none},
           {ToldOfC::early}, {ToldOfC::empty}, {ToldOfC::segments}, {ToldOfC::noLists}, {ToldOfC::ahead})

namespace {

Owned<lgs_islands> copyOf(const lgs_islands* islands) {
  lgs_islands* copy = nullptr;
  EXPECT_EQ(lgs_islands_copy(islands, &copy), LGS_OK);
  return Owned<lgs_islands>(copy);
}
CWorld copyOf(const lgs_world* world) {
  lgs_world* copy = nullptr;
  EXPECT_EQ(lgs_copy(world, &copy), LGS_OK);
  return CWorld(copy);
}

/// Asks for all that a view knows, right or wrong.
void askAll(const lgs_islands* islands, const lgs_world* world) {
  std::array<lgs_island_id, 64> ids{};
  std::array<lgs_loop_id, 64> loops{};
  std::size_t count = 0;
  for (const std::int32_t which : {LGS_ALL, LGS_ADDED, LGS_REMOVED, LGS_CHANGED, LGS_LOOSE}) {
    static_cast<void>(lgs_islands_loop_ids(islands, which, loops.data(), loops.size(), &count));
    static_cast<void>(lgs_islands_ids(islands, which, ids.data(), ids.size(), &count));
    for (std::size_t k = 0; k < std::min(count, ids.size()); ++k)
      static_cast<void>(lgs_islands_get(islands, ids[k], nullptr));
  }
  std::vector<lgs_polygon_id> polygons;
  const lgs_polygon_fn visit = [](void* user, const lgs_polygon* p, const lgs_local_point*) {
    static_cast<std::vector<lgs_polygon_id>*>(user)->push_back(p->id);
  };
  static_cast<void>(lgs_visit_polygons(world, {{kLeast, kLeast}, {kMost, kMost}}, visit, &polygons));
  for (const lgs_polygon_id polygon : polygons) static_cast<void>(lgs_islands_of(islands, world, polygon, ids.data()));
}

/// What it would do to clear a column.
Owned<lgs_foreseen> foreseenBy(Scene& s) {
  const FollowedC& f = followedInCBy(s);
  const CWorld world = copyOf(f.world.get());
  const Owned<lgs_islands> view = copyOf(f.islands.get());
  const lgs_edit_fn clear = [](void*, lgs_world* changed) -> std::int32_t {
    return lgs_clear(changed, EditOfC::kRock, nullptr, nullptr) == LGS_OK;
  };
  lgs_foreseen* would = nullptr;
  EXPECT_EQ(lgs_foresee(world.get(), view.get(), clear, nullptr, &would), LGS_OK);
  return Owned<lgs_foreseen>(would);
}

}  // namespace

void addDoorsOfIslandsInC(Doors& door) {
  door("lgs_islands_new", [](Scene& s, WorldOfC w, AnchorOfC anchor, EditOfC edit, Given out) {
    const FollowedC& f = followedInCBy(s);
    const CWorld copy = copyOf(f.world.get());
    edit.afterCommit(copy.get(), f.square);
    lgs_world* const world = w.which == WorldOfC::own ? copy.get() : w(f);
    lgs_islands* made = nullptr;
    const lgs_status status = lgs_islands_new(world, anchor.function(), world, out(made));
    const Owned<lgs_islands> view(made);
    EXPECT_EQ(status == LGS_OK, made != nullptr);
    if (made) askAll(made, world);
    // Whoever lies must not do harm later, either.
    for (const auto later : {EditOfC::clear, EditOfC::build, EditOfC::all}) {
      if (!made) break;
      lgs_changes changes{};
      EditOfC{later}(world, f.square);
      EXPECT_EQ(lgs_commit(world, &changes), LGS_OK);
      static_cast<void>(lgs_islands_update(made, world, &changes));
      askAll(made, world);
    }
    return checked(status, world && out);
  });
  door("lgs_islands_new_open", [](Scene& s, WorldOfC w, AnchorOfC anchor, Given out) {
    const FollowedC& f = followedInCBy(s);
    lgs_islands* made = nullptr;
    const lgs_status status = lgs_islands_new_open(w(f), anchor.function(), w(f), out(made));
    const Owned<lgs_islands> view(made);
    EXPECT_EQ(status == LGS_OK, made != nullptr);
    if (made) askAll(made, w(f));
    return checked(status, w(f) && out);
  });
  door("lgs_islands_copy", [](Scene& s, Given i, Given out) {
    FollowedC& f = followedInCBy(s);
    lgs_islands* copy = nullptr;
    const lgs_status status = lgs_islands_copy(islandsOf(f, i), out(copy));
    if (copy) f.islands.reset(copy);
    return checked(status, i && out);
  });
  door("lgs_islands_free", [](Scene&) { lgs_islands_free(nullptr); });
  door("lgs_islands_update", [](Scene& s, Given i, WorldOfC w, EditOfC edit, ToldOfC told) {
    FollowedC& f = followedInCBy(s);
    const CWorld world = copyOf(f.world.get());
    const Owned<lgs_islands> view = copyOf(f.islands.get());
    edit(world.get(), f.square);
    lgs_changes changes{};
    EXPECT_EQ(lgs_commit(world.get(), &changes), LGS_OK);
    const ListsOfC lists(changes);
    edit.afterCommit(world.get(), f.square);
    told.in(s, f, lists, changes);
    lgs_world* const asked = w.which == WorldOfC::own ? world.get() : w(f);
    const lgs_status status =
        checked(lgs_islands_update(i ? view.get() : nullptr, asked, told.which == ToldOfC::none ? nullptr : &changes),
                i && asked && told.which != ToldOfC::none);
    if (i && w.which == WorldOfC::own && told.which == ToldOfC::last && edit.which != EditOfC::pending) {
      EXPECT_EQ(status == LGS_OK, edit.isHonest());
    }
    if (asked) askAll(view.get(), asked);
    if (edit.isHonest()) edit(f.world.get(), f.square);
    f.commit();
    return status == LGS_OK;
  });
  door("lgs_foresee", [](Scene& s, WorldOfC w, Given i, EditOfC edit, Given callback, Given out) {
    const FollowedC& f = followedInCBy(s);
    const CWorld world = copyOf(f.world.get());
    const Owned<lgs_islands> view = copyOf(f.islands.get());
    struct Tried {
      EditOfC edit;
      lgs_shape_id square;
    } tried{edit, f.square};
    const lgs_edit_fn make = [](void* user, lgs_world* changed) -> std::int32_t {
      const auto& [kind, square] = *static_cast<const Tried*>(user);
      kind(changed, square);
      return kind.which == EditOfC::nothing ? 0 : INT32_MIN;
    };
    lgs_world* const asked = w.which == WorldOfC::own ? world.get() : w(f);
    lgs_foreseen* would = nullptr;
    const lgs_status status =
        lgs_foresee(asked, i ? view.get() : nullptr, callback ? make : nullptr, &tried, out(would));
    const Owned<lgs_foreseen> owner(would);
    EXPECT_EQ(status == LGS_OK, would != nullptr);
    if (asked) askAll(view.get(), asked);
    if (would && w.which == WorldOfC::own) {
      std::int32_t isSame = 0;
      EXPECT_TRUE(lgs_same_polygons(world.get(), f.world.get(), &isSame) == LGS_OK && isSame);
    }
    return checked(status, asked && i && callback && out);
  });
  door("lgs_foreseen_free", [](Scene&) { lgs_foreseen_free(nullptr); });
  door("lgs_foreseen_ids", [](Scene& s, Given given, ListOfC which, Space<lgs_island_id> ids, Out<std::size_t> out) {
    const Owned<lgs_foreseen> would = foreseenBy(s);
    return checked(lgs_foreseen_ids(given ? would.get() : nullptr, which.number, ids.data(), ids.size(), out),
                   given && which.number >= 0 && which.number <= LGS_LOOSE && ids.isThere());
  });
  door("lgs_foreseen_pairs", [](Scene& s, Given given, ListOfC which, Space<lgs_island_pair> pairs,
                                Out<std::size_t> out) {
    const Owned<lgs_foreseen> would = foreseenBy(s);
    return checked(lgs_foreseen_pairs(given ? would.get() : nullptr, which.number, pairs.data(), pairs.size(), out),
                   given && which.number >= 0 && which.number <= LGS_JOINED && pairs.isThere());
  });
  door("lgs_foreseen_get", [](Scene& s, Given given, std::uint32_t id, Out<lgs_island> out) {
    const Owned<lgs_foreseen> would = foreseenBy(s);
    return checked(lgs_foreseen_get(given ? would.get() : nullptr, {id}, out), given);
  });
  door("lgs_islands_ids", [](Scene& s, Given i, ListOfC which, Space<lgs_island_id> ids, Out<std::size_t> out) {
    return checked(lgs_islands_ids(islandsOf(followedInCBy(s), i), which.number, ids.data(), ids.size(), out),
                   i && which.number >= 0 && which.number <= LGS_LOOSE && ids.isThere());
  });
  door("lgs_islands_loop_ids", [](Scene& s, Given i, ListOfC which, Space<lgs_loop_id> ids, Out<std::size_t> out) {
    return checked(lgs_islands_loop_ids(islandsOf(followedInCBy(s), i), which.number, ids.data(), ids.size(), out),
                   i && which.number >= 0 && which.number < LGS_LOOSE && ids.isThere());
  });
  door("lgs_islands_pairs", [](Scene& s, Given i, ListOfC which, Space<lgs_island_pair> pairs, Out<std::size_t> out) {
    return checked(lgs_islands_pairs(islandsOf(followedInCBy(s), i), which.number, pairs.data(), pairs.size(), out),
                   i && which.number >= 0 && which.number <= LGS_JOINED && pairs.isThere());
  });
  door("lgs_islands_loop_pairs",
       [](Scene& s, Given i, ListOfC which, Space<lgs_loop_pair> pairs, Out<std::size_t> out) {
         return checked(
             lgs_islands_loop_pairs(islandsOf(followedInCBy(s), i), which.number, pairs.data(), pairs.size(), out),
             i && which.number >= 0 && which.number <= LGS_JOINED && pairs.isThere());
       });
  door("lgs_islands_get", [](Scene& s, Given i, std::uint32_t id, Out<lgs_island> out) {
    const FollowedC& f = followedInCBy(s);
    const lgs_status status = lgs_islands_get(islandsOf(f, i), islandOf(f, id), out);
    EXPECT_TRUE(id <= 2 || status != LGS_OK);
    return checked(status, i);
  });
  door("lgs_islands_loop", [](Scene& s, Given i, std::uint32_t id, Out<lgs_loop_facts> out) {
    const lgs_status status = lgs_islands_loop(islandsOf(followedInCBy(s), i), {id}, out);
    EXPECT_TRUE((id > 0 && id <= 2) || status != LGS_OK);
    return checked(status, i);
  });
  door("lgs_islands_of", [](Scene& s, Given i, WorldOfC w, PolygonHandle h, Out<lgs_island_id> out) {
    const FollowedC& f = followedInCBy(s);
    return checked(lgs_islands_of(islandsOf(f, i), w(f), toC(h), out), i && w(f));
  });
  door("lgs_islands_loop_of", [](Scene& s, Given i, WorldOfC w, SegmentId segment, Out<lgs_loop_id> out) {
    const FollowedC& f = followedInCBy(s);
    return checked(lgs_islands_loop_of(islandsOf(f, i), w(f), toC(segment), out), i && w(f));
  });
}

}  // namespace lgs::test
