// What the checker must see in the answers of strokes, of what is pending, of chunks that leave memory, and of views: lies
// are told to it, each of which it must call by its name.
#include "checking.h"
#include "oracle/cgal/brushed.h"
#include "oracle/trace/model.h"
#include "oracle/views/beyond_check.h"

#include <gtest/gtest.h>

namespace lgs::oracle::lying {
namespace {

using test::U;
using Kind = Call::Kind;
using Ring = std::vector<Point>;

Call carved(Ring ring) { return Call::byBrush({.rings = {std::move(ring)}}); }

Call of(Kind kind, CellRect cells = {}) {
  Call call = Call::of(kind);
  call.cells = cells;
  return call;
}

// --- The model

// Cells (0, 0) and (40, 0), whose chunk is not in memory.
class CheckModel : public testing::Test {
 protected:
  CheckModel() {
    for (const Call& call : {square("a", {0, 0}), square("b", {40, 0}), Call::commit()}) EXPECT_TRUE(model_.play(call));
  }

  void unload() { EXPECT_TRUE(model_.play(of(Kind::unload, {{32, 0}, {63, 31}}))); }
  std::string refused(const Call& call, Error error) const {
    Outcome outcome;
    outcome.refusal = error;
    return model_.wrongAnswer(call, model_.judge(call), outcome, World());
  }
  // Whether followCells() must be accepted; nothing if it may as well be refused.
  std::optional<bool> mayFollow() const {
    const Verdict verdict = model_.judge(Call::of(Kind::follow));
    return verdict.isOpen ? std::nullopt : std::optional(verdict.accepted);
  }

  Model model_;
};

TEST_F(CheckModel, AStrokeWithRoomIsAccepted) {
  const Call small = carved({{0, 0}, {9, 0}, {9, 9}});
  EXPECT_TRUE(model_.judge(small).accepted);
  EXPECT_FALSE(model_.judge(small).isOpen);
  EXPECT_EQ(refused(small, {.code = ErrorCode::capacity, .cell = {0, 0}}).substr(0, 21), "refused, but is good:");
  Ring star;
  for (std::int64_t k = 0; k < 20; ++k) star.push_back({k * 997 % 20, k * k % 17});
  EXPECT_TRUE(model_.judge(carved(star)).isOpen);
}

TEST_F(CheckModel, AStrokeIsRefusedForACellThatIsAway) {
  const Call wide = carved({{0, 0}, {41 * U, 0}, {41 * U, U}});
  EXPECT_FALSE(model_.judge(wide).isOpen);
  unload();
  EXPECT_EQ(refused(wide, {.code = ErrorCode::unloaded, .cell = {40, 0}}), "");
  EXPECT_EQ(refused(wide, {.code = ErrorCode::unloaded, .cell = {20, 0}}), "blames another cell");
  EXPECT_EQ(refused(wide, {.code = ErrorCode::unloaded, .cell = {40, 3}}), "blames another cell");
  EXPECT_EQ(refused(wide, {.code = ErrorCode::capacity, .cell = {20, 0}}), "refused as capacity instead of unloaded");
}

TEST_F(CheckModel, AStrokeIsRefusedForAVertex) {
  const Call far = carved({{0, 0}, {9, 0}, {9, 9}, {kMaxCoordinate + 1, 9}});
  EXPECT_EQ(refused(far, {.code = ErrorCode::outOfReach, .polygon = 0, .vertex = 3}), "");
  EXPECT_EQ(refused(far, {.code = ErrorCode::outOfReach, .polygon = 0, .vertex = 2}),
            "the refusal blames another vertex");
}

TEST_F(CheckModel, WhatIsPendingIsKnownOrNot) {
  EXPECT_EQ(mayFollow(), true);
  EXPECT_TRUE(model_.play(of(Kind::clear, {{7, 7}, {7, 7}})));
  EXPECT_EQ(mayFollow(), std::nullopt) << "it takes nothing away";
  EXPECT_TRUE(model_.play(Call::remove("a")));
  EXPECT_EQ(mayFollow(), false);
  EXPECT_TRUE(model_.play(Call::commit()));
  EXPECT_EQ(mayFollow(), true);
  unload();
  EXPECT_EQ(mayFollow(), std::nullopt);
}

// A square at (0, 0), one that touches it with a corner, and one apart.
class CheckBodies : public testing::Test {
 protected:
  CheckBodies() {
    for (const Call& call : {square("a", {0, 0}), square("b", {1, 1}), square("c", {4, 0}), Call::commit()})
      EXPECT_TRUE(model_.play(call));
    named_.goes = {{.how = Named::How::name, .name = "b"}};
  }
  std::string said(std::vector<Body> bodies) const {
    const Call call = model_.resolved(named_);
    Outcome outcome;
    outcome.bodies = std::move(bodies);
    return model_.wrongAnswer(call, model_.judgeResolved(call), outcome, World());
  }
  static Body body(Cell origin, std::vector<Cell> cells) {
    Body body{.origin = origin, .cells = {origin, origin}, .polygons = {}, .mass = {}};
    for (const Cell cell : cells) {
      body.polygons.push_back({cell, 1, test::unitSquare()});
      body.cells.max = {origin.i + cell.i, origin.j + cell.j};
    }
    return body;
  }

  Model model_;
  Call named_ = Call::of(Kind::take);
};

TEST_F(CheckBodies, AreWhatHangsTogether) {
  EXPECT_EQ(said({body({0, 0}, {{0, 0}, {1, 1}})}), "");
  EXPECT_EQ(said({body({0, 0}, {{1, 1}, {0, 0}})}), "takes other polygons than those that hang together");
  EXPECT_EQ(said({body({1, 1}, {{0, 0}})}), "takes other polygons than those that hang together");
  EXPECT_EQ(said({body({0, 0}, {{0, 0}}), body({1, 1}, {{0, 0}})}), "takes 2 bodies instead of 1");
  EXPECT_EQ(said({}), "takes nothing");
  named_.nth = Call::kApart;
  EXPECT_EQ(said({body({0, 0}, {{0, 0}}), body({1, 1}, {{0, 0}})}), "");
  EXPECT_EQ(said({body({0, 0}, {{0, 0}, {1, 1}})}), "takes 1 bodies instead of 2");
}

TEST_F(CheckBodies, ComeBackWhereThereIsRoom) {
  EXPECT_TRUE(model_.play(named_));
  EXPECT_EQ(model_.standing().polygons(), 1U);
  Call comes = Call::of(Kind::put);
  comes.lies = {.by = {4, 0}, .symmetry = 0};
  EXPECT_EQ(model_.judge(comes).code, ErrorCode::overlap);
  EXPECT_EQ(model_.judge(comes).index, 0);
  comes.lies = {.by = {3, -1}, .symmetry = 0};
  EXPECT_EQ(model_.judge(comes).index, 1);
  comes.lies.symmetry = 2;  // upside down: (4, -2) is free
  EXPECT_TRUE(model_.play(comes));
  EXPECT_EQ(model_.standing().in({4, -2}).size(), 1U);
}

TEST_F(CheckModel, AnEditEndsRedo) {
  Call back = Call::of(Kind::rollBack);
  back.keeps = Call::Keeps::always;
  for (const Call& call : {Call::of(Kind::mark), square("c", {1, 0}), Call::commit(), Call::of(Kind::mark), back})
    EXPECT_TRUE(model_.play(call));
  const auto verdict = [&] { return model_.judge(Call::of(Kind::redo)); };
  EXPECT_TRUE(verdict().accepted);
  EXPECT_TRUE(model_.play(Call::remove("a")));
  EXPECT_FALSE(verdict().accepted || verdict().isOpen);
}

// --- Law 10

TEST(CheckSeams, OfWhatWasCarvedAndFilledAgain) {
  const auto box = [](std::int32_t left, std::int32_t right) {
    return ScenePolygon{{0, 0}, 1, {{left, 100}, {right, 100}, {right, 900}, {left, 900}}};
  };
  const Scene whole{{box(100, 900)}, {}};
  const BrushEdit inside{BrushEdit::Deed::fill, 1, {{{300, 300}, {500, 300}, {500, 500}}}};
  EXPECT_FALSE(seamIn(whole, inside, whole));
  EXPECT_FALSE(seamIn(whole, inside, {{box(102, 900)}, {}})) << "a unit for each stroke";
  EXPECT_TRUE(seamIn(whole, inside, {{box(103, 900)}, {}}));
  EXPECT_FALSE(seamIn(whole, inside, {{box(100, 400), box(400, 900)}, {}})) << "cut, and together again";
  EXPECT_TRUE(seamIn(whole, inside, {{box(100, 400), box(401, 900)}, {}}));
  const BrushEdit across{BrushEdit::Deed::fill, 1, {{{300, 300}, {950, 300}, {950, 500}}}};
  EXPECT_FALSE(seamIn(whole, across, whole)) << "it goes beyond";
}

// --- Views where chunks leave memory

bool isHeld(Block block, Cell) { return block == 2; }

// A row of squares, of which the last is of another chunk, that is not in memory; and the view of it.
class CheckBeyond : public testing::Test {
 protected:
  CheckBeyond() {
    EXPECT_TRUE(world_.followCells(true));
    for (const Cell cell : {Cell{26, 5}, Cell{28, 5}, Cell{31, 5}, Cell{32, 5}})
      test::place(world_, cell, test::unitSquare());
    world_.commit();
    EXPECT_TRUE(world_.unload({{32, 0}, {63, 31}}, [](Cell, std::span<const std::byte>) {}));
    world_.commit();
    islands_ = Islands(world_, isHeld);
  }

  static ScenePolygon at(std::int32_t i) { return {{i, 5}, 1, test::unitSquare()}; }
  std::string said(const WholeGround& whole, IsAnchor isAnchor = isHeld) const {
    return BeyondCheck(std::move(isAnchor)).begin(world_, whole, islands_);
  }

  World world_;
  Islands islands_{world_};
  const WholeGround right_{{at(26), at(28), at(31), at(32)}, {{32, 0}}};
};

TEST_F(CheckBeyond, SeesWhatIsNotBeyond) {
  EXPECT_EQ(said(right_), "");
  EXPECT_EQ(said({right_.polygons, {}}), "the polygon in cell (31, 5) is not beyond");
  EXPECT_EQ(said({{at(28), at(31)}, right_.away}), "the polygon in cell (31, 5) is not beyond");
  EXPECT_EQ(said({{at(28), {{29, 5}, 1, test::unitSquare()}}, {}}), "the polygon in cell (29, 5) is not in memory");
  const IsAnchor any = [](Block, Cell) { return true; };
  EXPECT_EQ(said(right_, any), "island 1 has 1 anchors, not 0");
}

TEST_F(CheckBeyond, SeesAnIslandThatGrew) {
  test::place(world_, {27, 5}, test::unitSquare());
  world_.commit();  // nobody tells the view
  EXPECT_EQ(said({{at(26), at(28), at(27), at(31), at(32)}, right_.away}), "island 1 has another outer loop");
}

TEST_F(CheckBeyond, SeesAChangeThatIsNotTold) {
  BeyondCheck check(isHeld);
  EXPECT_EQ(check.begin(world_, right_, islands_), "");
  EXPECT_EQ(check.update(world_, right_, islands_), "");
  test::removeAll(world_, {28, 5});
  EXPECT_TRUE(islands_.update(world_, world_.commit()));
  const WholeGround now{{at(26), at(31), at(32)}, right_.away};
  BeyondCheck late(isHeld);
  EXPECT_EQ(late.begin(world_, now, islands_), "");
  EXPECT_NE(late.update(world_, now, islands_), "") << "the island went before";
  EXPECT_EQ(check.update(world_, now, islands_), "");
}

}  // namespace
}  // namespace lgs::oracle::lying
