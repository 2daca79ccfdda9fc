// Doors of bodies, pieces and hashes of the C interface. What is out of step is tried with copies.
#include "c_views.h"

#include <lgs/lgs_falling.h>

#include <algorithm>
#include <array>
#include <limits>

namespace lgs::test {
namespace {

struct TurnOfC {
  double cosine = 1, sine = 0;
};
/// What becomes of the bytes of a rock.
struct DamageOfC {
  enum { none, cut, more, empty, flipped } which = none;
  std::vector<std::uint8_t> of(std::vector<std::uint8_t> bytes) const {
    if (which == cut) bytes.pop_back();
    if (which == more) bytes.push_back(0);
    if (which == empty) bytes.clear();
    if (which == flipped) bytes[bytes.size() / 2] ^= 0x81;
    return bytes;
  }
};

}  // namespace

LGS_VALUES(TurnOfC, fmt::format("turned by ({}, {})", v.cosine, v.sine), {1, 0}, {0.6, 0.8}, {-1, 0}, {0, 0},
           {1e300, -1e300}, {std::numeric_limits<double>::quiet_NaN(), 0})
LGS_VALUES(DamageOfC, fmt::format("damage {}", static_cast<int>(v.which)), {DamageOfC::none}, {DamageOfC::cut},
           {DamageOfC::more}, {DamageOfC::empty}, {DamageOfC::flipped})

namespace {

std::vector<std::uint8_t> bytesOf(const lgs_body* body) {
  const lgs_rock rock{{{1.5, 2}, 0.6, 0.8}, {3, 4}, 5};
  std::size_t count = 0;
  EXPECT_EQ(lgs_rock_save(body, &rock, nullptr, 0, &count), LGS_SHORT_BUFFER);
  std::vector<std::uint8_t> bytes(count);
  EXPECT_EQ(lgs_rock_save(body, &rock, bytes.data(), count, &count), LGS_OK);
  return bytes;
}

lgs_pieces* piecesOf(const FollowedC& f, Given given) { return given ? f.pieces.get() : nullptr; }
lgs_hashes* hashesOf(const FollowedC& f, Given given) { return given ? f.hashes.get() : nullptr; }
lgs_body* bodyOf(const FollowedC& f, Given given) { return given ? f.body.get() : nullptr; }

bool isPart(ListOfC part) { return part.number == LGS_SOLID || part.number == LGS_FREE; }

Owned<lgs_hashes> copyOf(const lgs_hashes* hashes) {
  lgs_hashes* copy = nullptr;
  EXPECT_EQ(lgs_hashes_copy(hashes, &copy), LGS_OK);
  return Owned<lgs_hashes>(copy);
}

void commitBoth(FollowedC& f, WorldOfC w) {
  if (w.which == WorldOfC::other) static_cast<void>(lgs_commit(f.other.get(), nullptr));
  f.commit();
}

void addBodies(Doors& door) {
  door("lgs_take", [](Scene& s, WorldOfC w, Given i, std::uint32_t id, Given out, Out<lgs_error> e) {
    FollowedC& f = followedInCBy(s);
    lgs_body* body = nullptr;
    const lgs_status status = lgs_take(w(f), islandsOf(f, i), islandOf(f, id), out(body), e);
    EXPECT_EQ(status == LGS_OK, body != nullptr);
    if (body) f.body.reset(body);
    if (w.which == WorldOfC::other) static_cast<void>(lgs_commit(f.other.get(), nullptr));
    f.commit();
    return checked(status, w.which != WorldOfC::none && i && out);
  });
  door("lgs_take_apart", [](Scene& s, WorldOfC w, Given i, std::uint32_t id, Given bodies, Given room,
                            Out<std::size_t> count, Out<lgs_error> e) {
    FollowedC& f = followedInCBy(s);
    std::array<lgs_body*, 4> taken{};
    const lgs_status status = lgs_take_apart(w(f), islandsOf(f, i), islandOf(f, id), bodies ? taken.data() : nullptr,
                                             room ? taken.size() : 0, count, e);
    EXPECT_TRUE(status == LGS_OK || std::ranges::count(taken, nullptr) == 4);
    for (lgs_body* const body : taken)
      if (body) f.body.reset(body);
    if (w.which == WorldOfC::other) static_cast<void>(lgs_commit(f.other.get(), nullptr));
    f.commit();
    return checked(status, w.which != WorldOfC::none && i && (bodies || !room));
  });
  door("lgs_put", [](Scene& s, WorldOfC w, Given body, Cell c, Space<lgs_polygon_id> ids, Out<lgs_error> e) {
    FollowedC& f = followedInCBy(s);
    const lgs_status status = lgs_put(w(f), bodyOf(f, body), toC(c), ids.data(), ids.size(), e);
    EXPECT_TRUE(inRange(c) || status != LGS_OK);
    commitBoth(f, w);
    return checked(status, w.which != WorldOfC::none && body && ids.isThere());
  });
  door("lgs_body_parts", [](Scene& s, Given body, int vertices, Given callback, Out<lgs_error> e) {
    const auto most = static_cast<std::size_t>(std::int64_t{vertices});  // a negative one is very large
    const lgs_part_fn look = [](void* most, lgs_block, const lgs_point* corners, std::size_t count) {
      EXPECT_TRUE(count >= 3 && count <= *static_cast<std::size_t*>(most) && corners[0].x <= corners[1].x);
    };
    std::size_t bound = most;
    const lgs_status status =
        lgs_body_parts(bodyOf(followedInCBy(s), body), most, callback ? look : nullptr, &bound, e);
    return checked(status, body && callback && most >= 3 && most <= kMaxVerticesPerCell);
  });
  door("lgs_put_as_it_lies",
       [](Scene& s, WorldOfC w, Given body, DoublePoint at, TurnOfC turn, Given placing, Out<lgs_error> e) {
         FollowedC& f = followedInCBy(s);
         const lgs_placing lying{{at.x, at.y}, turn.cosine, turn.sine};
         const lgs_status status = lgs_put_as_it_lies(w(f), bodyOf(f, body), placing ? &lying : nullptr, e);
         commitBoth(f, w);
         return checked(status, w.which != WorldOfC::none && body && placing);
       });
  door("lgs_rock_save",
       [](Scene& s, Given body, DoublePoint at, Given rock, Space<std::uint8_t> bytes, Out<std::size_t> count) {
         const lgs_rock moving{{{at.x, at.y}, 1, 0}, {at.y, at.x}, at.x};
         return checked(
             lgs_rock_save(bodyOf(followedInCBy(s), body), rock ? &moving : nullptr, bytes.data(), bytes.size(), count),
             body && rock && bytes.isThere());
       });
  door("lgs_rock_load", [](Scene& s, DamageOfC damage, Given bytes, Given out, Out<lgs_rock> rock) {
    FollowedC& f = followedInCBy(s);
    const std::vector<std::uint8_t> saved = damage.of(bytesOf(f.body.get()));
    lgs_body* body = nullptr;
    const lgs_status status = lgs_rock_load(bytes ? saved.data() : nullptr, saved.size(), out(body), rock);
    EXPECT_EQ(status == LGS_OK, body != nullptr);
    if (body) f.body.reset(body);
    return checked(status, (bytes || saved.empty()) && out);
  });
  door("lgs_body_get", [](Scene& s, Given body, Out<lgs_body_facts> out) {
    return checked(lgs_body_get(bodyOf(followedInCBy(s), body), out), body);
  });
  door("lgs_body_polygon_at", [](Scene& s, Given body, std::uint64_t index, Out<lgs_body_polygon> out) {
    const FollowedC& f = followedInCBy(s);
    lgs_body_facts facts{};
    EXPECT_EQ(lgs_body_get(f.body.get(), &facts), LGS_OK);
    return checked(lgs_body_polygon_at(bodyOf(f, body), index, out), body && index < facts.polygons);
  });
  door("lgs_body_free", [](Scene&) { lgs_body_free(nullptr); });
}

void addPieces(Doors& door) {
  door("lgs_pieces_new", [](Scene& s, WorldOfC w, int vertices, Given out) {
    const FollowedC& f = followedInCBy(s);
    lgs_pieces* made = nullptr;
    const auto most = static_cast<std::size_t>(std::int64_t{vertices});  // a negative one is very large
    const lgs_status status = lgs_pieces_new(w(f), most, out(made));
    const Owned<lgs_pieces> owner(made);
    EXPECT_EQ(status == LGS_OK, made != nullptr);
    return checked(status, w(f) && out && most >= 3 && most <= kMaxVerticesPerCell);
  });
  door("lgs_pieces_copy", [](Scene& s, Given p, Given out) {
    lgs_pieces* copy = nullptr;
    const lgs_status status = lgs_pieces_copy(piecesOf(followedInCBy(s), p), out(copy));
    const Owned<lgs_pieces> owner(copy);
    EXPECT_EQ(status == LGS_OK, copy != nullptr);
    return checked(status, p && out);
  });
  door("lgs_pieces_free", [](Scene&) { lgs_pieces_free(nullptr); });
  door("lgs_pieces_update", [](Scene& s, Given p, WorldOfC w, Given told, Given list, Given out) {
    const FollowedC& f = followedInCBy(s);
    lgs_pieces* made = nullptr;  // it may be told what was in another world
    EXPECT_EQ(lgs_pieces_new(f.world.get(), 8, &made), LGS_OK);
    const Owned<lgs_pieces> owner(made);
    const lgs_changes changes = f.last.asChanges();
    const lgs_cell* cells = nullptr;
    std::size_t count = 0;
    const lgs_status status =
        lgs_pieces_update(p ? made : nullptr, w(f), told ? &changes : nullptr, list(cells), out(count));
    for (std::size_t k = 0; k < count && cells; ++k)
      static_cast<void>(lgs_pieces_portals(made, cells[k], 0, nullptr, 0, nullptr));
    return checked(status, p && w(f) && told);
  });
  door("lgs_pieces_count", [](Scene& s, Given p, Cell c, ListOfC part, Given out) {
    std::size_t count = 0;
    const lgs_status status = lgs_pieces_count(piecesOf(followedInCBy(s), p), toC(c), part.number, out(count));
    EXPECT_TRUE(inRange(c) || count == 0);
    return checked(status, p && isPart(part));
  });
  door("lgs_pieces_get", [](Scene& s, Given p, WorldOfC w, Cell c, ListOfC part, std::uint64_t index,
                            Space<lgs_local_point> vertices, Given out) {
    const FollowedC& f = followedInCBy(s);
    lgs_polygon_id polygon{};
    std::size_t count = 0, pieces = 0;
    static_cast<void>(lgs_pieces_count(f.pieces.get(), toC(c), part.number, &pieces));
    return checked(lgs_pieces_get(piecesOf(f, p), w(f), toC(c), part.number, index, vertices.data(), vertices.size(),
                                  out(count), out(polygon)),
                   p && w(f) && isPart(part) && index < pieces && vertices.isThere());
  });
  door("lgs_pieces_portals",
       [](Scene& s, Given p, Cell c, std::uint32_t index, Space<lgs_portal> portals, Out<std::size_t> out) {
         return checked(
             lgs_pieces_portals(piecesOf(followedInCBy(s), p), toC(c), index, portals.data(), portals.size(), out),
             p && portals.isThere());
       });
}

void addHashes(Doors& door) {
  door("lgs_hashes_new", [](Scene& s, WorldOfC w, Given out) {
    const FollowedC& f = followedInCBy(s);
    lgs_hashes* made = nullptr;
    const lgs_status status = lgs_hashes_new(w(f), out(made));
    const Owned<lgs_hashes> owner(made);
    EXPECT_EQ(status == LGS_OK, made != nullptr);
    return checked(status, w(f) && out);
  });
  door("lgs_hashes_copy", [](Scene& s, Given h, Given out) {
    FollowedC& f = followedInCBy(s);
    lgs_hashes* copy = nullptr;
    const lgs_status status = lgs_hashes_copy(hashesOf(f, h), out(copy));
    if (copy) f.hashes.reset(copy);
    return checked(status, h && out);
  });
  door("lgs_hashes_free", [](Scene&) { lgs_hashes_free(nullptr); });
  door("lgs_hashes_update", [](Scene& s, Given h, WorldOfC w, Given told) {
    const FollowedC& f = followedInCBy(s);
    const Owned<lgs_hashes> copy = copyOf(f.hashes.get());
    const lgs_changes changes = f.last.asChanges();
    std::size_t count = 0;
    const lgs_status status = lgs_hashes_update(h ? copy.get() : nullptr, w(f), told ? &changes : nullptr);
    static_cast<void>(lgs_hashes_whole(copy.get(), nullptr));
    static_cast<void>(lgs_hashes_differences(copy.get(), f.hashes.get(), nullptr, 0, &count));
    return checked(status, h && w(f) && told);
  });
  door("lgs_hashes_whole", [](Scene& s, Given h, Out<lgs_hashed_square> out) {
    return checked(lgs_hashes_whole(hashesOf(followedInCBy(s), h), out), h);
  });
  door("lgs_hashes_in",
       [](Scene& s, Given h, const CellRect& r, int level, Space<lgs_hashed_square> squares, Given out) {
         std::size_t count = 0;
         const lgs_status status =
             lgs_hashes_in(hashesOf(followedInCBy(s), h), toC(r), level, squares.data(), squares.size(), out(count));
         EXPECT_TRUE((level >= 0 && level <= 14 && !isEmpty(r)) || count == 0);
         return checked(status, h && squares.isThere());
       });
  door("lgs_hashes_differences", [](Scene& s, Given a, Given b, bool isOther, Space<lgs_cell_rect> cells, Given out) {
    const FollowedC& f = followedInCBy(s);
    lgs_hashes* ofOther = nullptr;
    EXPECT_EQ(lgs_hashes_new(f.other.get(), &ofOther), LGS_OK);
    const Owned<lgs_hashes> owner(ofOther);
    std::size_t count = 0;
    const lgs_status status = lgs_hashes_differences(hashesOf(f, a),
                                                     !b        ? nullptr
                                                     : isOther ? ofOther
                                                               : f.hashes.get(),
                                                     cells.data(), cells.size(), out(count));
    EXPECT_TRUE(isOther || count == 0);
    return checked(status, a && b && cells.isThere());
  });
}

}  // namespace

void addDoorsOfIslandsInC(Doors& door);

void addDoorsOfViewsInC(Doors& door) {
  addDoorsOfIslandsInC(door);
  addBodies(door);
  addPieces(door);
  addHashes(door);
}

}  // namespace lgs::test
