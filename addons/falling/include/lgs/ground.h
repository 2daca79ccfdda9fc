// The ground of a game as one object: it is dug, painted and built, what is cut off falls and becomes ground again
// where it rests, all of that is undone and redone, a window of it is in memory, and all of it is saved, loaded and
// drawn.
//
//   lgs::box2d::Ground ground({.isAnchor = isBedrock, .land = hills}, physics,   // <lgs/box2d/ground.h>
//                             lgs::box2d::TerrainOptions{.cellSize = 0.5});
//   …
//   ground.window(cellsAround(player));                                          // each frame: free if it is the same
//   const lgs::Point at = ground.host().terrain().latticePoint(mouse);           // the mouse in metres
//   if (clicked) ground.dig(lgs::circle(at, 2 * lgs::kUnitsPerCell));            // a step of undo
//   if (pressed('Z')) ground.undo();
//   if (pressed('Y')) ground.redo();
//   ground.step([&] { physics.Step(1.0F / 60, 8, 3); });
//   for (const lgs::GroundDrawing& d : ground.draw()) renderer.set(d.cells, d.fills, d.lines);  // what changed
//
// lgs::Ground<> is the same without physics: its rocks are values that the game moves (ground_parts.h). It owns the
// order of calls, the marks, and the bodies that came out of the ground, and nothing else: world(), islands() and
// host() are there for questions. To edit or commit the world directly goes around it; edit() takes any edits.
//
// The rules that it keeps:
//
//  1. A stroke (edit(), dig(), paint(), place()) is one step of undo, with what it cuts off. A stroke that is refused
//     changes nothing, but for rule 5.
//  2. Matter is neither doubled nor lost. Undo over a take destroys the body and the ground is back; undo over a settle
//     takes the ground away, and the rock lies there as a body, at rest. Redo does either again.
//  3. While there is something to redo nothing falls and nothing settles, as both are edits, which end the redo. The
//     next stroke lets them.
//  4. What reaches the edge of memory is anchored (kBeyond in islands.h), unless GroundOptions::atEdge is `open`. What
//     is loose when it comes in falls. Undo and redo go on over chunks that left and came back. New land ends the redo;
//     so does an undo to before some that was made after something fell or settled, since that land is made anew.
//  5. A rock of more than GroundOptions::settleAtOnce polygons becomes ground in several frames. Until it is done its
//     body stands still, whole; forEachRock() has what is not ground yet, and in a save all of it is ground. No new
//     ground can push it: so before a stroke, but for dig(), what is left of it is ground at once, which ends the redo.
//  6. Bodies outside of the window, by the cell of their centre of mass, are disabled, the game's too, and enabled when
//     it is there again: then they are put out of ground that came to their places meanwhile.
//
// Costs: a stroke as of its edit, commit, the islands and the sync; an undo as of the strokes undone. A Ground stays
// where it is, and so does what it is made with.
#pragma once

#include <lgs/ground_rocks.h>

#include <cassert>
#include <deque>
#include <utility>
#include <vector>

namespace lgs {

/// The comment at the top of this file is its manual. `Host` is the physics: NoPhysics has what is needed of it.
template <class Host = NoPhysics>
class Ground {
 public:
  using Handle = typename Host::Handle;  ///< names the body of a rock

  /// An empty ground. What comes behind the options is given to the host, after the world.
  template <class... OfHost>
  explicit Ground(GroundOptions options, OfHost&&... ofHost)
      : options_(std::move(options)),
        world_(options_.preserve),
        host_(world_, std::forward<OfHost>(ofHost)...),
        islands_(world_, options_.isAnchor, options_.atEdge),
        rocks_(world_, host_),
        window_(options_) {
    begin();
  }
  /// The bodies of rocks go, and those of the game outside of the window are enabled.
  ~Ground() {
    if (host_.isThere()) rocks_.destroyAll();
  }
  Ground(const Ground&) = delete;
  Ground& operator=(const Ground&) = delete;

  // --- Strokes

  /// Frees a region. Refused: as by carve(), so as `unloaded` where it reaches a chunk that is not in memory; and one of
  /// which the land is not made yet, with the first cell of that.
  Expected<void> dig(const Region& region) {
    const auto cells = boundsOf(region);
    if (const auto cell = cells ? window_.firstWithoutLand(*cells) : std::nullopt)
      return tl::unexpected(Error{.code = ErrorCode::unloaded, .cell = *cell});
    return stroke([&](World& world) { return carve(world, region, options_.staying); });
  }
  /// Paints a region. Refused: as by lgs::paint().
  Expected<void> paint(const Region& region, Block block, PaintMode mode = PaintMode::fill) {
    return edit([&](World& world) { return lgs::paint(world, region, block, mode, options_.staying); });
  }
  /// Places a polygon in a cell. Refused: as by World::add().
  Expected<void> place(Cell cell, std::span<const LocalPoint> polygon, Block block) {
    return edit([&](World& world) { return world.add(cell, polygon, block); });
  }
  /// Any edits, as one stroke: make(world) returns an Expected, and if that is an error nothing is changed.
  /// Refused: as make() was.
  template <class Edit>
  Expected<void> edit(const Edit& make) {
    rocks_.dropGone();
    if (rocks_.finish(now_)) becameGround();
    return stroke(make);
  }

  /// Whether there is a stroke to take back.
  bool canUndo() const { return now_ > oldest_; }
  /// Whether there is one to make again.
  bool canRedo() const { return now_ + 1 < oldest_ + static_cast<std::int64_t>(marks_.size()); }
  /// Takes the last stroke back, and what fell or settled since. Whether there was one.
  bool undo() { return canUndo() && go(now_ - 1); }
  /// Makes it again. Whether there was one.
  bool redo() { return canRedo() && go(now_ + 1); }
  /// Releases all steps of undo, as after the game built a level.
  void forgetUndo() {
    dropFuture();
    while (canUndo()) forgetOldest();
  }

  // --- Time

  /// A step of the physics. Then at most one rock that rests becomes ground, or a part of it.
  template <class Step>
  void step(const Step& step) {
    host_.beforeStep();
    step();
    rocks_.dropGone();
    host_.afterStep();
    if (!canRedo() && rocks_.settleNext(now_, options_.settleAtOnce)) becameGround();
  }

  // --- Space

  /// The chunks with a cell of a rectangle are in memory from now on, and no others; until it is called the first time,
  /// all are. What a stroke makes in chunks outside of it where none were is in memory until the window is another one.
  /// With GroundOptions::land there is land there, and one chunk further. False while that is not so, and the next call
  /// goes on: there are more than GroundOptions::chunksAtOnce, or the shelf did not give a chunk, or other
  /// bytes. Cost: O(1) if the chunks are the same and all are there.
  bool window(const CellRect& cells) {
    if (!window_.moveTo(cells)) return true;
    window_.stream(world_, now_, beforeLand_);
    host_.window(window_.cells());
    commit();
    keepLand();
    return window_.isWhole();
  }

  // --- Saving

  /// All ground, in memory or on the shelf, and all rocks; no steps of undo. A rock of which a part is ground is
  /// ground. Refused: unloaded, where the shelf did not give a chunk. Cost: a copy of what is in memory, and each chunk
  /// on the shelf once.
  Expected<void> save(const ByteSink& sink) {
    rocks_.dropGone();
    World copy = world_;  // from which all leaves; and what is ground in part would fall apart after a load
    const std::vector<Rock> rocks = rocks_.values(copy, options_.shelf);
    copy.commit();
    return saveGround(std::move(copy), options_.shelf, rocks, window_.land(), sink);
  }
  /// What was saved takes the place of all that is there. What hangs in the air falls; with GroundOptions::land as soon
  /// as a window() is true, as land that is not made yet may hold it. False, and nothing is changed, if these are not
  /// the bytes of a save: cut ones, say. Damaged ones that are taken are ground and rocks like others.
  bool load(std::span<const std::byte> bytes) {
    auto loaded = loadGround(bytes, options_.preserve, window_.cells(), options_.shelf);
    if (!loaded) return false;
    rocks_.destroyAll();
    window_.restart(loaded->land);
    squares_.note(world_);
    world_ = std::move(loaded->world);
    squares_.note(world_);
    begin();
    // Rocks first, so that those in the ground are pushed out or disabled.
    for (Rock& rock : loaded->rocks) rocks_.add(std::move(rock), -1);
    rocks_.makeAdded();
    host_.showAll();
    looksAtAll_ = true;
    commit();
    return true;
  }

  // --- Looking

  /// The squares that look different since the last call, the first time all. Rocks are not in it: fillsOf() draws one.
  std::vector<GroundDrawing> draw() { return squares_.draw(world_); }
  /// Calls visit(handle, ground) for each rock in the air. A null handle has no body, as all of it is too thin. The
  /// visit collects those that it is to settle() or forget().
  template <class Visit>
  void forEachRock(const Visit& visit) const {
    rocks_.forEach(visit);
  }
  /// Puts a rock, or what is left of it, into the ground now, as it lies. Refused: staleHandle; overlap, where one lies
  /// of which a part is ground; as by the host's settle().
  Expected<void> settle(Handle handle) {
    rocks_.dropGone();
    const auto done = rocks_.settle(handle, now_);
    if (done) becameGround();
    return done;
  }
  /// For a rock whose body the game destroys or keeps: it is not the ground's any more. Nothing happens to one of which
  /// a part is ground, and to those without a body. A destroyed one that was not forgotten is found in the next step(),
  /// undo(), redo(), save(), load() or settle(), before anything of it is used.
  void forget(Handle handle) { rocks_.forget(handle); }

  const World& world() const { return world_; }        ///< for questions
  const Islands& islands() const { return islands_; }  ///< for questions
  Host& host() { return host_; }                       ///< the physics, with the terrain

 private:
  void begin() {
    world_.commit();
    [[maybe_unused]] const auto follows = world_.followCells(true);
    assert(follows);
    islands_ = Islands(world_, options_.isAnchor, options_.atEdge);
    marks_ = {world_.mark()};
    oldest_ = now_ = 0;
  }

  template <class Edit>
  Expected<void> stroke(const Edit& make) {
    Transaction group = world_.edit();
    if (const auto done = make(world_); !done) return tl::unexpected(done.error());
    group.keep();
    dropFuture();
    commit();
    marks_.push_back(world_.mark());
    ++now_;
    if (marks_.size() - 1 > options_.undoSteps) forgetOldest();
    return {};
  }

  // --- Commits

  void show(const Changes& changes) {
    host_.show(changes);
    if (!islands_.update(world_, changes)) islands_ = Islands(world_, options_.isAnchor, options_.atEdge);
    for (const CellChange& change : world_.cellChanges()) squares_.note(change.cell);
    if (options_.follow) options_.follow(world_, changes);
  }
  /// With what falls by it.
  void commit() {
    rocks_.dropGone();
    show(world_.commit());
    while (takeLoose()) show(world_.commit());
    // options_.follow() may destroy bodies, and the new ones may have their addresses.
    rocks_.dropGone();
    rocks_.makeAdded();
  }
  bool takeLoose() {
    if (!options_.isAnchor) return false;
    if (canRedo() || window_.mayLackLand()) {
      looksAtAll_ = true;
      return false;
    }
    bool isAny = false;
    for (const IslandId id : std::exchange(looksAtAll_, false) ? islands_.all() : islands_.loose()) {
      const IslandFacts facts = *islands_.island(id);
      if (facts.anchors > 0) continue;
      if (rocks_.willHold(facts)) {
        looksAtAll_ = true;
      } else if (auto body = take(world_, islands_, id)) {
        rocks_.add(detail::atRest(std::move(*body)), now_);
        isAny = true;
      }
    }
    return isAny;
  }
  void becameGround() {
    dropFuture();
    commit();
  }

  // --- Undo

  bool go(std::int64_t to) {
    rocks_.dropGone();
    const Mark mark = marks_[static_cast<std::size_t>(to - oldest_)];
    const bool went = (to < now_ ? world_.rollBack(mark, Undone::keep) : world_.redo(mark)).has_value();
    if (!went) return false;
    now_ = to;
    rocks_.leave(now_);
    // What came in since may hang in the air, or its anchors have left.
    looksAtAll_ = true;
    show(world_.changesOfRollBack());
    squares_.noteBesideUnloaded(world_, window_.cells());
    rocks_.dropGone();  // as in commit()
    rocks_.comeBack(now_);
    if (window_.remakeLand(world_, now_, beforeLand_)) commit();
    if (!canRedo()) commit();
    return true;
  }
  /// Before an edit: what was undone can not come back, and what was made again stays.
  void dropFuture() {
    marks_.resize(static_cast<std::size_t>(now_ - oldest_) + 1);
    rocks_.dropFuture(now_);
  }
  void forgetOldest() {
    static_cast<void>(world_.forget(marks_.front()));
    marks_.pop_front();
    ++oldest_;
    rocks_.forgetBefore(oldest_);
    window_.forgetBefore(oldest_);
  }
  /// Where nothing else has happened since the last mark, it is made anew behind the land: so the undo of the next
  /// stroke does not take that away.
  void keepLand() {
    if (!window_.hasNew(now_) || rocks_.anyOf(now_)) return;
    static_cast<void>(world_.forget(std::exchange(marks_.back(), world_.mark())));
    window_.keepNew(now_);
    window_.forgetBefore(oldest_);
  }

  GroundOptions options_;
  World world_;
  Host host_;
  Islands islands_;
  detail::GroundRocks<Host> rocks_;    // of now, and of what can be undone or redone
  detail::GroundWindow window_;        // what is in memory, and which land was made
  ChangedSquares squares_;             // to be drawn
  std::deque<Mark> marks_;             // after each stroke; those behind now_ are ahead
  std::int64_t oldest_ = 0, now_ = 0;  // the numbers of the first mark, and of that at or after which the world is
  bool looksAtAll_ = false;            // something may hang in the air that no update will name
  const detail::BeforeLand beforeLand_ = [this](const CellRect& chunk) {
    dropFuture();
    squares_.noteSides(chunk);  // it may leave at once, and then none of its cells is named
  };
};

}  // namespace lgs
