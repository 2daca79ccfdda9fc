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
//     changes nothing.
//  2. Matter is neither doubled nor lost. Undo over a take destroys the body and the ground is back; undo over a settle
//     takes the ground away, and the rock lies there as a body, at rest. Redo does either again.
//  3. While there is something to redo nothing falls and nothing settles, as both are edits, which end the redo. The
//     next stroke lets them.
//  4. What reaches the edge of memory is anchored (kBeyond in islands.h), unless GroundOptions::atEdge is `open`. What
//     is loose when it comes in falls. Undo and redo go on over chunks that left and came back. New land ends the redo.
//  5. A rock of more than GroundOptions::settleAtOnce polygons becomes ground in several frames. Until it is done its
//     body stands still, whole; forEachRock() has what is not ground yet, and in a save all of it is ground.
//  6. Bodies outside of the window are disabled, the game's too, and enabled when it is there again.
//
// Costs: a stroke as of its edit, commit, the islands and the sync; an undo as of the strokes undone. A Ground stays
// where it is, and so does what it is made with.
#pragma once

#include <lgs/ground_parts.h>

#include <algorithm>
#include <cassert>
#include <deque>
#include <limits>
#include <memory>
#include <set>
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
        islands_(world_, options_.isAnchor, options_.atEdge) {
    begin();
  }
  /// The bodies of rocks go, and those of the game outside of the window are enabled.
  ~Ground() {
    if (!host_.isThere()) return;
    dropGone();
    for (const Fallen& f : fallen_)
      if (f.isInAir) destroy(f);
  }
  Ground(const Ground&) = delete;
  Ground& operator=(const Ground&) = delete;

  // --- Strokes

  /// Frees a region. Refused: as by carve(), so as `unloaded` where it reaches a chunk that is not in memory.
  Expected<void> dig(const Region& region) {
    return edit([&](World& world) { return carve(world, region, options_.staying); });
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
    dropGone();
    host_.afterStep();
    if (!canRedo()) settleNext();
  }

  // --- Space

  /// The chunks with a cell of a rectangle are in memory from now on, and no others; until it is called the first time,
  /// all are. What a stroke makes in chunks outside of it where none were is in memory until the window is another one.
  /// With GroundOptions::land there is land there, and one chunk further. False while that is not so, and the next call
  /// goes on: there are more than GroundOptions::chunksAtOnce, or the shelf did not give a chunk, or other
  /// bytes. Cost: O(1) if the chunks are the same and all are there.
  bool window(const CellRect& cells) {
    const CellRect chunks{chunkAround(cells.min).min, chunkAround(cells.max).max};
    if (chunks == window_ && isWindowWhole_) return true;
    if (chunks != window_) {
      leaving_ = boxOf(leaving_, window_);
      window_ = chunks;
    }
    std::size_t most = std::max<std::size_t>(options_.chunksAtOnce, 1);
    // Land first, as a chunk that comes in needs to know what is beside it.
    isWindowWhole_ = makeLand(most) && unloadSome(most) && reloadInside(world_, window_, options_.shelf, most);
    if (isWindowWhole_) mayLackLand_ = false;
    host_.window(chunks);
    commit();
    keepLand();
    return isWindowWhole_;
  }

  // --- Saving

  /// All ground, in memory or on the shelf, and all rocks; no steps of undo. A rock of which a part is ground is
  /// ground. Refused: unloaded, where the shelf did not give a chunk. Cost: a copy of what is in memory, and each chunk
  /// on the shelf once.
  Expected<void> save(const ByteSink& sink) {
    dropGone();
    const std::vector<Cell> land(made_.begin(), made_.end());
    if (std::ranges::none_of(fallen_, [](const Fallen& f) { return f.isInAir && f.parts > 0; }))
      return saveGround(world_, options_.shelf, rocksAsValues(nullptr), land, sink);
    World whole = world_;  // what is ground in part would fall apart after a load
    const std::vector<Rock> rocks = rocksAsValues(&whole);
    whole.commit();
    return saveGround(whole, options_.shelf, rocks, land, sink);
  }
  /// What was saved takes the place of all that is there. What hangs in the air falls; with GroundOptions::land as soon
  /// as a window() is true, as land that is not made yet may hold it. False, and nothing is changed, if these are not
  /// the bytes of a save: cut ones, say. Damaged ones that are taken are ground and rocks like others.
  bool load(std::span<const std::byte> bytes) {
    auto loaded = loadGround(bytes, options_.preserve, window_, options_.shelf);
    if (!loaded) return false;
    dropGone();
    for (const Fallen& f : fallen_)
      if (f.isInAir) destroy(f);
    fallen_.clear();
    for (Rock& rock : loaded->rocks) fallen_.push_back({std::move(rock), {}, -1});
    isWindowWhole_ = false;
    made_ = {loaded->land.begin(), loaded->land.end()};
    newLand_.clear();
    squares_.note(world_);
    world_ = std::move(loaded->world);
    squares_.note(world_);
    begin();
    // Rocks first, so that those in the ground are pushed out or disabled.
    for (Fallen& f : fallen_) make(f);
    host_.showAll();
    mayLackLand_ = static_cast<bool>(options_.land);
    looksAtAll_ = true;
    commit();
    return true;
  }

  // --- Looking

  /// The squares that look different since the last call, the first time all.
  std::vector<GroundDrawing> draw() { return squares_.draw(world_); }
  /// Calls visit(handle, ground) for each rock in the air. A null handle has no body, as all of it is too thin. The
  /// visit collects those that it is to settle() or forget().
  template <class Visit>
  void forEachRock(const Visit& visit) const {
    for (const Fallen& f : fallen_)
      if (f.isInAir) visit(f.handle, f.parts == 0 ? f.rock.ground : f.inParts->rest(f.parts).ground);
  }
  /// Puts a rock, or what is left of it, into the ground now, as it lies. Refused: staleHandle; as by the host's
  /// settle().
  Expected<void> settle(Handle handle) {
    dropGone();
    if (isNull(handle)) return tl::unexpected(Error{.code = ErrorCode::staleHandle});
    const auto found =
        std::ranges::find_if(fallen_, [&](const Fallen& f) { return f.isInAir && Host::isSame(f.handle, handle); });
    if (found == fallen_.end()) return tl::unexpected(Error{.code = ErrorCode::staleHandle});
    return found->parts == 0 ? settle(*found) : putParts(*found, found->inParts->count());
  }
  /// For a rock whose body the game destroys or keeps: it is not the ground's any more. Nothing happens to one of which
  /// a part is ground, and to those without a body. A destroyed one that was not forgotten is found in the next step(),
  /// undo(), redo(), save(), load() or settle(), before anything of it is used.
  void forget(Handle handle) {
    if (isNull(handle)) return;
    std::erase_if(fallen_,
                  [&](const Fallen& f) { return f.isInAir && f.parts == 0 && Host::isSame(f.handle, handle); });
  }

  const World& world() const { return world_; }        ///< for questions
  const Islands& islands() const { return islands_; }  ///< for questions
  Host& host() { return host_; }                       ///< the physics, with the terrain

 private:
  static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  static constexpr std::uint64_t kStepsOfRest = 30;  // half a second, as in Box2D

  /// A rock, and between which marks it is one: it was taken in the stretch after the mark `took`.
  struct Fallen {
    Rock rock;
    Handle handle{};
    std::int64_t took = 0;
    std::int64_t settled = kNever;
    bool isInAir = true;
    int tries = 0;              ///< how often it did not become ground by itself, or nothing held it then
    std::uint64_t until = 0;    ///< the step before which it does not try again
    std::uint64_t movedAt = 0;  ///< the step at which it moved last, as far as that was seen
    /// Of one that becomes ground in parts: after which mark each of them did, also those that are undone.
    std::vector<std::int64_t> puts{};
    std::size_t parts = 0;                         ///< how many of them are ground now; then its body is held
    std::shared_ptr<const RockInParts> inParts{};  ///< these
  };

  void begin() {
    world_.commit();
    [[maybe_unused]] const auto follows = world_.followCells(true);
    assert(follows);
    islands_ = Islands(world_, options_.isAnchor, options_.atEdge);
    marks_ = {world_.mark()};
    oldest_ = now_ = 0;
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
    dropGone();
    show(world_.commit());
    const std::size_t before = fallen_.size();
    while (takeLoose()) show(world_.commit());
    const std::size_t count = fallen_.size() - before;
    // options_.follow() may destroy bodies, and the new ones may have their addresses.
    dropGone();
    for (std::size_t k = fallen_.size() - count; k < fallen_.size(); ++k) make(fallen_[k]);
  }
  bool takeLoose() {
    if (!options_.isAnchor) return false;
    if (canRedo() || mayLackLand_) {
      looksAtAll_ = true;
      return false;
    }
    const std::size_t before = fallen_.size();
    for (const IslandId id : std::exchange(looksAtAll_, false) ? islands_.all() : islands_.loose()) {
      const IslandFacts facts = *islands_.island(id);
      if (facts.anchors > 0) continue;
      if (waitsForRest(facts))
        looksAtAll_ = true;
      else if (auto body = take(world_, islands_, id))
        fallen_.push_back({atRest(std::move(*body)), {}, now_});
    }
    return fallen_.size() != before;
  }
  /// Whether it may be a part of a rock of which the rest will hold it.
  bool waitsForRest(const IslandFacts& island) const {
    return std::ranges::any_of(
        fallen_, [&](const Fallen& f) { return f.isInAir && f.parts > 0 && f.inParts->isNear(island.outer); });
  }
  static Rock atRest(Body ground) {
    const DoublePoint at{static_cast<double>(ground.origin.i), static_cast<double>(ground.origin.j)};
    return {std::move(ground), {.origin = at}};
  }
  static bool isNull(Handle handle) { return Host::isSame(handle, Handle{}); }
  void make(Fallen& f) {
    f.handle = host_.make(f.rock);
    if (f.parts > 0 && !isNull(f.handle)) host_.hold(f.handle);
    f.movedAt = steps_;
    f.isInAir = true;
  }
  void destroy(const Fallen& f) {
    if (!isNull(f.handle)) host_.destroy(f.handle);
  }
  /// What the game destroyed is not ground any more.
  void dropGone() {
    if (!host_.dropGone()) return;
    std::erase_if(fallen_, [&](const Fallen& f) { return f.isInAir && !isNull(f.handle) && !host_.has(f.handle); });
  }

  // --- Settling

  /// The rocks in turn. One that does not fit, or would fall again, tries again later and later.
  void settleNext() {
    ++steps_;
    for (Fallen& f : fallen_) {
      if (!f.isInAir || f.parts == 0 || steps_ < f.until) continue;
      if (!putParts(f, f.parts + 1)) f.until = steps_ + 60;
      return;
    }
    for (std::size_t k = std::min<std::size_t>(fallen_.size(), 16); k > 0; --k) {
      Fallen& f = fallen_[next_++ % fallen_.size()];
      if (!f.isInAir || isNull(f.handle) || steps_ < f.until) continue;
      if (!host_.lies(f.handle)) f.movedAt = steps_;
      if (steps_ - f.movedAt < kStepsOfRest || !host_.isHeld(f.handle)) continue;
      f.until = steps_ + (std::uint64_t{60} << std::min(f.tries++, 6));
      if (f.rock.ground.polygons.size() > options_.settleAtOnce)
        beginSettling(f);
      else
        static_cast<void>(settle(f));
      return;
    }
  }
  void beginSettling(Fallen& f) {
    const auto placing = host_.placingOf(f.handle);
    if (!placing) return;
    auto parts = RockInParts::of(host_.read(f.handle), *placing, std::max<std::size_t>(options_.settleAtOnce, 1));
    if (!parts) return;
    f.inParts = std::make_shared<const RockInParts>(std::move(*parts));
    f.puts.clear();
    static_cast<void>(putParts(f, 1));
  }
  /// Puts parts of a rock until so many are ground.
  Expected<void> putParts(Fallen& f, std::size_t to) {
    if (const auto done = f.inParts->put(world_, f.parts, to); !done) return done;
    dropFuture();
    if (f.parts == 0) {
      f.rock = stopped(f.inParts->whole());
      host_.hold(f.handle);
    }
    f.parts = to;
    f.puts.resize(to, now_);
    if (to == f.inParts->count()) {
      destroy(f);
      becomeGround(f);
    } else {
      commit();
    }
    return {};
  }
  static Rock stopped(Rock rock) {
    rock.velocity = {};
    rock.spin = 0;
    return rock;
  }
  Expected<void> settle(Fallen& f) {
    f.rock = stopped(host_.read(f.handle));
    if (const auto done = host_.settle(f.handle); !done) return done;
    becomeGround(f);
    return {};
  }
  /// All of it is put.
  void becomeGround(Fallen& f) {
    f.handle = {};
    f.isInAir = false;
    f.settled = now_;
    const int tries = f.tries;
    const std::uint64_t until = f.until;
    dropFuture();
    const std::size_t before = fallen_.size();
    commit();
    for (std::size_t k = before; k < fallen_.size(); ++k) {  // it would fall again
      fallen_[k].tries = tries;
      fallen_[k].until = until;
    }
  }

  // --- Undo

  bool go(std::int64_t to) {
    dropGone();
    const Mark mark = marks_[static_cast<std::size_t>(to - oldest_)];
    const bool went = (to < now_ ? world_.rollBack(mark, Undone::keep) : world_.redo(mark)).has_value();
    if (!went) return false;
    now_ = to;
    const auto isThere = [&](const Fallen& f) { return f.took < now_ && f.settled >= now_; };
    for (Fallen& f : fallen_) {
      const bool wasHeld = std::exchange(f.parts, partsAt(f, now_)) > 0;
      const bool isHeld = f.parts > 0 && isThere(f);
      if (!f.isInAir || (isThere(f) && wasHeld == isHeld)) continue;
      destroy(f);
      f.handle = {};
      f.isInAir = false;
      if (f.took >= now_) f.rock = atRest(std::move(f.rock.ground));
    }
    // What came in since may hang in the air, or its anchors have left.
    looksAtAll_ = true;
    show(world_.changesOfRollBack());
    squares_.noteBesideUnloaded(world_, window_);
    dropGone();  // as in commit()
    for (Fallen& f : fallen_) {
      if (f.isInAir || !isThere(f)) continue;
      if (f.parts > 0) f.rock = stopped(f.inParts->whole());
      make(f);
    }
    remakeLand();
    if (!canRedo()) commit();
    return true;
  }
  /// Before an edit: what was undone can not come back, and what was made again stays.
  void dropFuture() {
    marks_.resize(static_cast<std::size_t>(now_ - oldest_) + 1);
    std::erase_if(fallen_, [&](const Fallen& f) { return !f.isInAir && f.took >= now_; });
    for (Fallen& f : fallen_) {
      if (!f.isInAir) continue;
      f.settled = kNever;
      f.puts.resize(f.parts);
    }
  }
  /// How many parts of a rock are ground at a mark.
  static std::size_t partsAt(const Fallen& f, std::int64_t mark) {
    return static_cast<std::size_t>(std::ranges::lower_bound(f.puts, mark) - f.puts.begin());
  }
  void forgetOldest() {
    static_cast<void>(world_.forget(marks_.front()));
    marks_.pop_front();
    ++oldest_;
    std::erase_if(fallen_, [&](const Fallen& f) { return !f.isInAir && f.settled < oldest_; });
    std::erase_if(newLand_, [&](const auto& land) { return land.second < oldest_; });
  }

  // --- The window

  /// Whether all of it is made. Until it is, none of it is in memory: what is beside land that is not made would fall.
  bool makeLand(std::size_t& most) {
    if (!options_.land) return true;
    for (const Cell corner : chunksAround(window_)) {
      if (made_.contains(corner)) continue;
      if (most == 0 || !makeChunk(corner)) return false;
      --most;
      static_cast<void>(world_.unload(chunkAround(corner), options_.shelf.put));
    }
    return true;
  }
  /// Where nothing else has happened since the last mark, it is made anew behind the land: so the undo of the next
  /// stroke does not take that away.
  void keepLand() {
    const auto isOfNow = [&](const Fallen& f) {
      return f.took == now_ || f.settled == now_ || std::ranges::binary_search(f.puts, now_);
    };
    if (newLand_.empty() || newLand_.back().second != now_ || std::ranges::any_of(fallen_, isOfNow)) return;
    static_cast<void>(world_.forget(std::exchange(marks_.back(), world_.mark())));
    for (auto& land : newLand_)
      if (land.second == now_) --land.second;
    std::erase_if(newLand_, [&](const auto& land) { return land.second < oldest_; });
  }
  /// Whether no chunk is in memory out of the window. At first, when all may be, they leave at once.
  bool unloadSome(std::size_t& most) {
    const auto isSmall = [](std::int32_t min, std::int32_t max) { return std::int64_t{max} - min < 2'048; };
    if (isSmall(leaving_.min.i, leaving_.max.i) && isSmall(leaving_.min.j, leaving_.max.j)) {
      for (const Cell corner : chunksAround(leaving_)) {
        if (contains(window_, corner)) continue;
        if (most == 0) return false;
        if (world_.unload(chunkAround(corner), options_.shelf.put).value_or(0) > 0) --most;
      }
    }
    unloadOutside(world_, window_, options_.shelf);
    leaving_ = window_;
    return true;
  }
  /// Whether it could, or the shelf has not given what is there already.
  bool makeChunk(Cell corner) {
    const CellRect chunk = chunkAround(corner);
    if (world_.firstUnloaded(chunk)) {  // an undo went over it, or the game has built there
      const auto bytes = options_.shelf.get(corner);
      if (!bytes || !world_.reload(*bytes)) return false;
    }
    dropFuture();
    made_.insert(corner);
    squares_.noteSides(chunk);  // it may leave at once, and then none of its cells is named
    newLand_.emplace_back(corner, now_);
    World land(options_.preserve);
    options_.land(land, chunk);
    bool isThere = false;
    static_cast<void>(land.unload(
        chunk, [&](Cell, std::span<const std::byte> bytes) { isThere = world_.reload(bytes).has_value(); }));
    if (isThere || !land.firstUnloaded(chunk)) return true;
    // There is a chunk. What the game has built there stays: what would overlap that is refused.
    World anew(options_.preserve);
    options_.land(anew, chunk);
    anew.forEachPolygon(
        chunk, [&](Cell cell, const PlacedPolygon& p) { static_cast<void>(world_.add(cell, p.vertices, p.block)); });
    return true;
  }
  /// An undo took away land that was made since; at that time nothing was dug there.
  void remakeLand() {
    std::vector<Cell> again;
    for (const auto& [corner, at] : newLand_)
      if (at >= now_) again.push_back(corner);
    if (again.empty()) return;
    std::erase_if(newLand_, [&](const auto& land) { return land.second >= now_; });
    for (const Cell corner : again) {
      if (makeChunk(corner)) continue;
      made_.erase(corner);  // by the next window()
      isWindowWhole_ = false;
    }
    unloadOutside(world_, window_, options_.shelf);
    commit();
  }
  /// Those of which a part is ground become ground in `world`, as far as it takes them. If there are none it may be
  /// null.
  std::vector<Rock> rocksAsValues(World* world) {
    std::vector<Rock> rocks;
    for (const Fallen& f : fallen_) {
      if (!f.isInAir) continue;
      if (f.parts == 0) {
        Rock is = isNull(f.handle) ? f.rock : host_.read(f.handle);
        rocks.push_back(isSound(is) ? std::move(is) : f.rock);
        continue;
      }
      std::size_t most = kAll;
      static_cast<void>(reloadInside(*world, f.inParts->chunks(), options_.shelf, most));
      if (!f.inParts->put(*world, f.parts, f.inParts->count())) rocks.push_back(f.inParts->rest(f.parts));
    }
    return rocks;
  }

  GroundOptions options_;
  World world_;
  Host host_;
  Islands islands_;
  std::deque<Mark> marks_;             // after each stroke; those behind now_ are ahead
  std::int64_t oldest_ = 0, now_ = 0;  // the numbers of the first mark, and of that at or after which the world is
  std::vector<Fallen> fallen_;         // rocks, of now and of what can be undone or redone
  std::uint64_t steps_ = 0;            // how often rocks could settle
  std::size_t next_ = 0;               // which of them looks first whether it can settle
  bool mayLackLand_ = false;           // after a load land that would hold what is in memory may not be made yet
  bool looksAtAll_ = false;            // something may hang in the air that no update will name
  CellRect window_{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};
  CellRect leaving_ = window_;                          // what is in memory and not in the window is in it
  bool isWindowWhole_ = false;                          // whether nothing is to come or go
  std::set<Cell> made_;                                 // chunks whose land was made
  std::vector<std::pair<Cell, std::int64_t>> newLand_;  // of these, which an undo may take away, and after which mark
  ChangedSquares squares_;                              // to be drawn
};

}  // namespace lgs
