// Doors of what follows a world: loops, islands and their bodies, pieces, falling ground. They have a world of their
// own, since it must have no mark when they begin; names are those of the scene.
#include "door.h"
#include "followed.h"

#include <lgs/falling.h>

#include <cmath>
#include <limits>

namespace lgs::test {

namespace {

using Edit = std::function<bool(World&)>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// What every view can go through as a value; it goes on as what it became.
template <auto kView>
void copied(Scene& s) {
  const auto copy(*(followedBy(s).*kView));
  followedBy(s).*kView = copy;
}
template <auto kView>
void assignedToItself(Scene& s) {
  const auto& same = *(followedBy(s).*kView);
  *(followedBy(s).*kView) = same;
}
template <auto kView>
void moved(Scene& s) {
  auto next(std::move(*(followedBy(s).*kView)));
  *(followedBy(s).*kView) = next;  // all that may be done to what was moved from
}
template <auto kView>
void moveAssigned(Scene& s) {
  std::remove_cvref_t<decltype(*(followedBy(s).*kView))> next(followedBy(s).other);
  next = std::move(*(followedBy(s).*kView));
  *(followedBy(s).*kView) = std::move(next);
}
/// Ends, and begins anew.
template <auto kView>
void ended(Scene& s) {
  followedBy(s).commit();
  (followedBy(s).*kView).emplace(followedBy(s).world);
}

/// Changes that a view may be told: the last ones, early ones, those of others, and what a stranger made up.
struct WhatIsTold {
  int which = 0;
  Changes in(Scene& s) const {
    const Followed& f = followedBy(s);
    const std::uint64_t now = f.world.version(), shown = f.loops->version();
    switch (which) {
      case 0:
        return f.last;
      case 1:
        return f.early;
      case 2:
        return s.reported;
      case 3:
        return {};
      case 4:
        return {s.segments, {}, {}, shown, now};
      case 5:
        return {{}, s.segments, {}, shown, now};
      case 6:
        return {{}, {}, s.segments, shown, now};
      case 7:
        return {s.segments, s.segments, s.segments, shown, shown + 1};
      case 8:
        return {{f.world.segments()[0]}, {}, {}, shown, now};
      case 9:
        return {{}, {}, {f.world.segments()[0], f.world.segments()[1]}, shown, now};
      case 10:
        return {{}, {f.world.segments()[0]}, {}, shown, now};
      default:
        return {{}, {}, {}, shown, ~std::uint64_t{0}};
    }
  }
};

std::vector<BodyPolygon> polygonsToFall() {
  return {{{0, 0}, 1, unitSquare()}, {{1, 0}, 2, ramp()}, {{1, 1}, 1, ramp()}};
}
Body bodyOf(Cell origin, std::vector<BodyPolygon> polygons) {
  return {origin, {origin, origin}, std::move(polygons), {}};
}

}  // namespace

LGS_VALUES(LoopId, fmt::format("loop {}", v.value), {1}, {0}, {2}, {3}, {999}, {0x8000'0000}, {0xffff'ffff})
LGS_VALUES(IslandId, fmt::format("island {}", v.value), {1}, {0}, {2}, {3}, {999}, {0x8000'0000}, {0xffff'ffff})
LGS_VALUES(PieceId, fmt::format("piece {} of ({}, {})", v.index, v.cell.i, v.cell.j), {{0, 0}, 0}, {{2, 4}, 0},
           {{1, 0}, 0}, {{0, 0}, 1}, {{2, 4}, 0xffff'ffff}, {{kLeast, kMost}, 0}, {{kMaxCell, -kMaxCell}, 0},
           {{kMaxCell + 1, 0}, 0})
LGS_VALUES(Part, fmt::format("part {}", static_cast<unsigned>(v)), Part::solid, Part::free, Part{2}, Part{255})
LGS_VALUES(WhatIsTold, fmt::format("changes {}", v.which), {0}, {1}, {2}, {3}, {4}, {5}, {6}, {7}, {8}, {9}, {10}, {11})
LGS_VALUES(Body, fmt::format("a body of {} from ({}, {})", v.polygons.size(), v.origin.i, v.origin.j),
           bodyOf({0, 9}, polygonsToFall()), Body{}, bodyOf({kLeast, kMost}, polygonsToFall()),
           bodyOf({0, 0}, {{{kMost, kMost}, 1, unitSquare()}, {{kLeast, kLeast}, 1, unitSquare()}}),
           bodyOf({0, 0}, {{{kMaxCell, 0}, 1, unitSquare()}, {{-kMaxCell, 0}, 1, unitSquare()}}),
           bodyOf({0, 0}, {{{0, 0}, 1, unitSquare()}, {{0, 0}, 1, unitSquare()}}), bodyOf({0, 0}, {{{0, 0}, 1, {}}}),
           bodyOf({0, 0}, {{{0, 0}, 1, {{kLeast, kLeast}, {kMost, kLeast}, {kMost, kMost}}}}),
           bodyOf({0, 0}, {{{0, 0}, 1, {{0, 0}, {0, 9}, {9, 0}}}}),
           bodyOf({0, 0}, {{{0, 0}, 1, Points(5'000, {1, 1})}}),
           bodyOf({0, 0}, std::vector<BodyPolygon>(3'000, BodyPolygon{{0, 0}, 1, ramp()})))
LGS_VALUES(Placing, fmt::format("at ({}, {}) by ({}, {})", v.origin.x, v.origin.y, v.cosine, v.sine),
           {{0.25, 9.5}, 1, 0}, {{0, 0}, 0, 0}, {{kNan, 0}, 1, 0}, {{0, 0}, kNan, 0}, {{0, kInfinite}, 1, 0},
           {{0, 0}, 1e308, -1e308}, {{1e308, -1e308}, 1, 0}, {{kMaxCell, -kMaxCell}, 0.6, 0.8}, {{0, 0}, 1e-300, 0},
           {{3, 9}, -2'000, 2'000}, {{9.3e18, 0}, -1, 0})

LGS_VALUES(
    Edit, v ? "an edit" : "no edit",
    [](World& world) {
      return world.clear(Cell{1, 3}).has_value();
    },
    [](World&) { return false; }, {},
    [](World& world) {
      return world.clear(CellRect{{-9, -9}, {9, 9}}).has_value();
    },
    [](World& world) { return world.commit().added.empty(); }, [](World& world) { return world.mark().value != 0; })

void addDoorsOfBodies(Doors& door);
void addDoorsOfPieces(Doors& door);

void addDoorsOfViews(Doors& door) {
  addDoorsOfBodies(door);
  addDoorsOfPieces(door);
  door("LoopId::operator bool() const", [](Scene&, LoopId id) { return bool{id}; });
  door("LoopFacts::isHole() const", [](Scene&, std::int64_t high, std::uint64_t low) {
    LoopFacts facts;
    facts.doubleArea = Int128(high, low);
    EXPECT_EQ(facts.isHole(), high < 0);
  });
  door("LoopFacts::area() const", [](Scene&, std::int64_t high, std::uint64_t low) {
    LoopFacts facts;
    facts.doubleArea = Int128(high, low);
    return facts.area();
  });
  door("Loops::Loops(const World&, AtEdge)", [](Scene& s, bool isOther, bool isOpen) {
    return Loops(isOther ? s.other : s.world, isOpen ? AtEdge::open : AtEdge::holds).all().size();
  });
  door("Loops::~Loops()", ended<&Followed::loops>);
  door("Loops::Loops(const Loops&)", copied<&Followed::loops>);
  door("Loops::operator=(const Loops&)", assignedToItself<&Followed::loops>);
  door("Loops::Loops(Loops&&)", moved<&Followed::loops>);
  door("Loops::operator=(Loops&&)", moveAssigned<&Followed::loops>);
  door("Loops::update(const World&, const Changes&)", [](Scene& s, bool isOther, const WhatIsTold& told) {
    const Followed& f = followedBy(s);
    Loops copy = *f.loops;  // which is out of step, if lists are made up well enough
    static_cast<void>(copy.update(isOther ? f.other : f.world, told.in(s)));
    for (const LoopId id : copy.all()) static_cast<void>(copy.loop(id));
  });
  door("Loops::changes() const", [](Scene& s) { return followedBy(s).loops->changes().added.size(); });
  door("Loops::loop(LoopId) const", [](Scene& s, LoopId id) { return followedBy(s).loops->loop(id).has_value(); });
  door("Loops::of(SegmentId) const", [](Scene& s, SegmentId id) { return followedBy(s).loops->of(id).value; });
  door("Loops::all() const", [](Scene& s) { return followedBy(s).loops->all().size(); });
  door("Loops::outline(const World&) const",
       [](Scene& s) { return followedBy(s).loops->outline(followedBy(s).world).version(); });
  door("Loops::version() const", [](Scene& s) { return followedBy(s).loops->version(); });
  door("Loops::visited() const", [](Scene& s) { return followedBy(s).loops->visited(); });

  door("IslandId::operator bool() const", [](Scene&, IslandId id) { return bool{id}; });
  door("Islands::Islands(const World&, IsAnchor, AtEdge)", [](Scene& s, bool holds, bool isOpen) {
    followedBy(s).commit();
    const IsAnchor isAnchor = [](Block, Cell) { return true; };
    const AtEdge atEdge = isOpen ? AtEdge::open : AtEdge::holds;
    return Islands(followedBy(s).world, holds ? isAnchor : IsAnchor(), atEdge).all().size();
  });
  door("Islands::~Islands()", [](Scene& s) {
    followedBy(s).commit();
    followedBy(s).islands.emplace(followedBy(s).world, [](Block block, Cell) { return isBedrock(block); });
  });
  door("Islands::Islands(const Islands&)", copied<&Followed::islands>);
  door("Islands::operator=(const Islands&)", assignedToItself<&Followed::islands>);
  door("Islands::Islands(Islands&&)", moved<&Followed::islands>);
  door("Islands::operator=(Islands&&)", moveAssigned<&Followed::islands>);
  door("Islands::update(const World&, const Changes&)", [](Scene& s, bool isOther, const WhatIsTold& told) {
    const Followed& f = followedBy(s);
    Islands copy = *f.islands;
    static_cast<void>(copy.update(isOther ? f.other : f.world, told.in(s)));
    for (const IslandId id : copy.all()) static_cast<void>(copy.island(id));
  });
  door("Islands::changes() const", [](Scene& s) { return followedBy(s).islands->changes().added.size(); });
  door("Islands::island(IslandId) const",
       [](Scene& s, IslandId id) { return followedBy(s).islands->island(id).has_value(); });
  door("Islands::of(const World&, PolygonHandle) const",
       [](Scene& s, PolygonHandle h) { return followedBy(s).islands->of(followedBy(s).world, h).value; });
  door("Islands::of(LoopId) const", [](Scene& s, LoopId id) { return followedBy(s).islands->of(id).value; });
  door("Islands::all() const", [](Scene& s) { return followedBy(s).islands->all().size(); });
  door("Islands::loose() const", [](Scene& s) { return followedBy(s).islands->loose().size(); });
  door("Islands::loops() const", [](Scene& s) { return followedBy(s).islands->loops().all().size(); });
  door("Islands::walked() const", [](Scene& s) { return followedBy(s).islands->walked(); });
  door("foresee(World&, Islands&, const function<bool (World&)>&)", [](Scene& s, const Edit& edit) {
    Followed& f = followedBy(s);
    f.commit();
    const Seen before = seenOf(f.world);
    static_cast<void>(foresee(f.world, *f.islands, edit));
    EXPECT_EQ(before.polygons, seenOf(f.world).polygons);
  });
}

void addDoorsOfBodies(Doors& door) {
  door("Int128::Int128(int64_t, uint64_t)",
       [](Scene&, std::int64_t high, std::uint64_t low) { return Int128(high, low).toDouble(); });
  door("Int128::Int128(int64_t)",
       [](Scene&, std::int64_t v) { EXPECT_EQ(Int128(v).toDouble(), static_cast<double>(v)); });
  door("Int128::isNegative() const", [](Scene&, std::int64_t v) { EXPECT_EQ(Int128(v).isNegative(), v < 0); });
  door("Int128::toDouble() const",
       [](Scene&, std::int64_t high, std::uint64_t low) { EXPECT_EQ(Int128(high, low).toDouble() < 0, high < 0); });
  door("Int128::operator+=(Int128)", [](Scene&, std::int64_t a, std::uint64_t b, std::int64_t c, std::uint64_t d) {
    Int128 sum(a, b);
    sum += Int128(c, d);
    sum -= Int128(c, d);
    EXPECT_EQ(sum, Int128(a, b));
  });
  door("Int128::operator-=(Int128)", [](Scene&, std::int64_t a, std::uint64_t b, std::int64_t c, std::uint64_t d) {
    Int128 rest(a, b);
    rest -= Int128(c, d);
    return rest.toDouble();
  });
  door("multiply(int64_t, int64_t)", [](Scene&, std::int64_t a, std::int64_t b) {
    EXPECT_EQ(multiply(a, b), multiply(b, a));
    EXPECT_EQ(multiply(a, b).isNegative(), a != 0 && b != 0 && (a < 0) != (b < 0));
  });
  door("massOf(const vector<BodyPolygon>&)", [](Scene&, const Body& body) { return massOf(body.polygons).area; });
  door("put(World&, const Body&, Cell)",
       [](Scene& s, const Body& body, Cell cell) { return put(s.world, body, cell); });
  door("take(World&, const Islands&, IslandId)", [](Scene& s, IslandId id) {
    Followed& f = followedBy(s);
    const bool isThere = f.islands->island(id).has_value();
    const auto taken = take(f.world, *f.islands, id);
    EXPECT_TRUE(isThere || !taken);
    f.commit();
  });
  door("takeApart(World&, const Islands&, IslandId)", [](Scene& s, IslandId id) {
    Followed& f = followedBy(s);
    static_cast<void>(takeApart(f.world, *f.islands, id));
    f.commit();
  });
  door("convexParts(const Body&, size_t)",
       [](Scene&, const Body& body, bool isLeast) { return convexParts(body, isLeast ? 3 : 4'096).has_value(); });
  door("putAsItLies(World&, const Body&, const Placing&)",
       [](Scene& s, const Body& body, const Placing& placing) { return putAsItLies(s.world, body, placing); });
  door("partsAsTheyLie(const Body&, const Placing&, size_t)",
       [](Scene&, const Body& body, const Placing& placing, bool isSmall) {
         return partsAsTheyLie(body, placing, isSmall ? 0 : 64).has_value();
       });
  door("putPart(World&, span<const LyingBlock>)",
       [](Scene& s, const Body& body, const Placing& placing) -> Expected<void> {
         constexpr double kLarge = 64;  // a part so many times its size is painted for minutes
         if (std::abs(placing.cosine) > kLarge || std::abs(placing.sine) > kLarge) return {};
         const auto parts = partsAsTheyLie(body, placing, 2);
         if (!parts || parts->empty()) return {};
         return putPart(s.world, parts->front());
       });
}

void addDoorsOfPieces(Doors& door) {
  door("polygonsByPieces(const World&, Cell)",
       [](Scene& s, Cell cell) { return polygonsByPieces(s.world, cell).size(); });
  door("Pieces::Pieces(const World&, PiecesOptions)", [](Scene& s, bool isLeast) {
    return Pieces(followedBy(s).other, {.maxVertices = isLeast ? std::size_t{3} : std::size_t{4'096}}).stats().cells;
  });
  door("Pieces::~Pieces()", ended<&Followed::pieces>);
  door("Pieces::Pieces(const Pieces&)", copied<&Followed::pieces>);
  door("Pieces::operator=(const Pieces&)", assignedToItself<&Followed::pieces>);
  door("Pieces::Pieces(Pieces&&)", moved<&Followed::pieces>);
  door("Pieces::operator=(Pieces&&)", moveAssigned<&Followed::pieces>);
  door("Pieces::update(const World&, const Changes&)", [](Scene& s, bool isOther, const WhatIsTold& told) {
    const Followed& f = followedBy(s);
    Pieces copy = *f.pieces;
    static_cast<void>(copy.update(isOther ? f.other : f.world, told.in(s)));
    for (const Cell cell : copy.changed()) static_cast<void>(copy.freePieces(cell));
  });
  door("Pieces::changed() const", [](Scene& s) { return followedBy(s).pieces->changed().size(); });
  door("Pieces::solidPieces(Cell) const",
       [](Scene& s, Cell cell) { return followedBy(s).pieces->solidPieces(cell).size(); });
  door("Pieces::freePieces(Cell) const", [](Scene& s, Cell cell) {
    const std::size_t count = followedBy(s).pieces->freePieces(cell).size();
    EXPECT_TRUE(inRange(cell) || count == 0);
  });
  door("Pieces::portals(PieceId) const", [](Scene& s, PieceId id) { return followedBy(s).pieces->portals(id).size(); });
  door("Pieces::portals(PieceId, vector<Portal>&) const", [](Scene& s, PieceId id) {
    std::vector<Portal> portals(3);
    followedBy(s).pieces->portals(id, portals);
    EXPECT_EQ(portals, followedBy(s).pieces->portals(id));
  });
  door("Pieces::freePieceAt(Point) const", [](Scene& s, Point p) {
    const auto piece = followedBy(s).pieces->freePieceAt(p);
    EXPECT_TRUE(inRange(p) || !piece);
  });
  door("Pieces::wholeCells(const CellRect&, Part) const", [](Scene& s, const CellRect& rect, Part part) {
    const auto columns = std::int64_t{rect.max.i} - rect.min.i, rows = std::int64_t{rect.max.j} - rect.min.j;
    if (columns > 999 || rows > 999) return std::size_t{0};  // it goes through all cells, as it says
    return followedBy(s).pieces->wholeCells(rect, part).size();
  });
  door("Pieces::maxVertices() const", [](Scene& s) { return followedBy(s).pieces->maxVertices(); });
  door("Pieces::stats() const", [](Scene& s) { return followedBy(s).pieces->stats().contents; });
}

}  // namespace lgs::test
