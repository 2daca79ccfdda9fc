#include "turmoil.h"
#include "field.h"

#include <algorithm>
#include <functional>
#include <ostream>
#include <sstream>
#include <utility>

namespace lgs::box2d_test {

namespace {

constexpr std::size_t kMostUndo = 12;

constexpr const char* kNames[] = {"body",   "paint", "line", "carve", "tile", "dig",    "shot",
                                  "portal", "undo",  "redo", "save",  "load", "origin", "kick"};

}  // namespace

std::ostream& operator<<(std::ostream& out, const Move& move) {
  return out << kNames[static_cast<std::size_t>(move.kind)] << " at " << move.x << " " << move.y << ", size "
             << move.size << ", which " << move.which << '\n';
}

std::ostream& operator<<(std::ostream& out, const Arena& arena) {
  return out << arena.width << " x " << arena.height << " cells of " << arena.cellSize << " half metres, chunks of "
             << arena.chunkCells << (arena.merge ? ", merged, " : ", ") << arena.steps << " steps a move"
             << (arena.announces ? ", announced" : "");
}

Move randomMove(oracle::Random& random, const Arena& arena) {
  using Kind = Move::Kind;
  static const std::vector<Kind> kinds{Kind::paint, Kind::paint, Kind::paint, Kind::line,  Kind::carve,
                                       Kind::carve, Kind::carve, Kind::carve, Kind::carve, Kind::tile,
                                       Kind::tile,  Kind::dig,   Kind::dig,   Kind::kick,  Kind::kick,
                                       Kind::kick,  Kind::shot,  Kind::shot,  Kind::portal};
  static const std::vector<Kind> rare{Kind::undo, Kind::undo, Kind::redo, Kind::save, Kind::load, Kind::origin};
  return {random.pick(random.chance(6) ? rare : kinds), random.below(arena.width * 16), random.below(arena.height * 16),
          random.below(16), random.below(256)};
}

// A wall all around, ground below, and rocks above it.
Turmoil::Turmoil(const Arena& arena) : arena_(arena), square_(*world_.shape(kUnitSquare)) {
  const auto fill = [&](Cell min, Cell max, Block block) {
    static_cast<void>(world_.fill({min, max}, square_, block));
  };
  fill({-1, -1}, {arena.width, -1}, 1);
  fill({-1, arena.height}, {arena.width, arena.height}, 1);
  fill({-1, 0}, {-1, arena.height - 1}, 1);
  fill({arena.width, 0}, {arena.width, arena.height - 1}, 1);
  if (arena.height > 3) fill({0, 0}, {arena.width - 1, 1}, 2);
  world_.commit();
  box2d::TerrainOptions options{.cellSize = 0.5 * arena.cellSize, .chunkCells = arena.chunkCells, .merge = arena.merge};
  terrain_.emplace(crowd_.physics, world_, options);
  marks_ = {world_.mark()};
}

Point Turmoil::pointOf(const Move& move) const {
  return {move.x % (arena_.width * 16) * (U / 16), move.y % (arena_.height * 16) * (U / 16)};
}

// It never reaches the walls.
Region Turmoil::regionOf(const Move& move) const {
  const auto within = [](std::int64_t at, std::int64_t reach, int cells) {
    return std::clamp(at, std::min(reach, std::int64_t{cells} * U / 2), std::max<std::int64_t>(0, cells * U - reach));
  };
  const std::int64_t most = std::int64_t{std::min(arena_.width, arena_.height)} * U / 2 - 1;
  const std::int64_t radius = std::min<std::int64_t>(most, U / 4 + move.size * (U / 8));
  const Point at = pointOf(move);
  const Point a{within(at.x, radius, arena_.width), within(at.y, radius, arena_.height)};
  if (move.kind != Move::Kind::line) return circle(a, radius, 8 + move.which % 24);
  const std::int64_t thin = std::min<std::int64_t>(most, U / 16 + move.which % 8 * (U / 32));
  const double angle = move.which * 0.0245;
  const Point b{within(a.x + std::llround(3 * U * std::cos(angle)), thin, arena_.width),
                within(a.y + std::llround(3 * U * std::sin(angle)), thin, arena_.height)};
  return thickLine(std::vector{a, b}, thin, 8);
}

bool Turmoil::isFree(const Position& middle) const {
  return world_.at(terrain_->latticePoint(middle)).where == Spot::Where::outside;
}

bool Turmoil::isFree(Body body) const {
  return std::ranges::all_of(Crowd::middlesOf(body), [&](const Position& middle) { return isFree(middle); });
}

// 0.2 to 2 cells long.
bool Turmoil::addBody(const Move& move) {
  const auto size = static_cast<float>((0.2 + 0.12 * move.size) * 0.5 * arena_.cellSize);
  const auto figure = static_cast<Figure>(move.which % static_cast<int>(Figure::count));
  const Position at = terrain_->position(pointOf(move));
  const bool isShot = move.kind == Move::Kind::shot;  // it may begin with a corner in the ground
  if (!isFree(at) || (!isShot && terrain_->nearest(at, 0.75F * size))) return false;
  const Body body = crowd_.add(figure, size, at);
  if (!isFree(body)) {
    crowd_.destroy(crowd_.bodies.size() - 1);
    return false;
  }
  if (arena_.announces) Crowd::announce(*terrain_, body);
  watched_.emplace_back();
  return true;
}

// A bullet is gone, and there is another one, at 60 metres a second and more.
void Turmoil::shoot(const Move& move) {
  const auto gone = crowd_.bodies.empty() ? 0 : static_cast<std::size_t>(move.which) % crowd_.bodies.size();
  if (!crowd_.bodies.empty()) {
    crowd_.destroy(gone);
    watched_.erase(watched_.begin() + static_cast<std::ptrdiff_t>(gone));
  }
  if (!addBody(move)) return;
  shove(crowd_.bodies.back(), move);
}

void Turmoil::portal(const Move& move) {
  if (crowd_.bodies.empty()) return;
  const Body body = crowd_.bodies[static_cast<std::size_t>(move.which) % crowd_.bodies.size()];
  if (!Crowd::isEnabled(body)) return;
  const Position from = Crowd::positionOf(body);
  Crowd::put(body, terrain_->position(pointOf(move)));
  if (!isFree(body)) return Crowd::put(body, from);
  shove(body, move);
  if (arena_.announces) Crowd::announce(*terrain_, body);
}

void Turmoil::shove(Body body, const Move& move) {
  const auto angle = 0.0245F * static_cast<float>(move.which);
  Crowd::kick(body, {60 * std::cos(angle), 60 * std::sin(angle)});
}

void Turmoil::edit(const Move& move) {
  const Point at = pointOf(move);
  const Cell cell = cellAt(at);
  switch (move.kind) {
    case Move::Kind::paint:
    case Move::Kind::line:
      static_cast<void>(paint(world_, regionOf(move), 3, PaintMode::fill));
      break;
    case Move::Kind::carve:
      static_cast<void>(carve(world_, regionOf(move)));
      break;
    case Move::Kind::tile:
      static_cast<void>(world_.replace(cell, square_, 2));
      break;
    default:
      world_.clear(cell);
      break;
  }
}

void Turmoil::sync(const Changes& changes) {
  static_cast<void>(terrain_->sync(changes));
  count();
}

void Turmoil::count() {
  for (const box2d::Overlap& overlap : terrain_->overlaps()) ++(overlap.isFree ? pushes_ : holds_);
}

void Turmoil::undo(int steps) {
  if (now_ == 0) return;
  now_ -= std::min(now_, static_cast<std::size_t>(1 + steps % 3));
  static_cast<void>(world_.rollBack(marks_[now_], Undone::keep));
  sync(world_.changesOfRollBack());
}

void Turmoil::redo(int steps) {
  if (now_ + 1 == marks_.size()) return;
  now_ = std::min(marks_.size() - 1, now_ + 1 + static_cast<std::size_t>(steps % 2));
  static_cast<void>(world_.redo(marks_[now_]));
  sync(world_.changesOfRollBack());
}

void Turmoil::load() {
  if (file_.empty()) return;
  world_ = *World::load(file_);
  square_ = *world_.shape(kUnitSquare);
  marks_ = {world_.mark()};
  now_ = 0;
  terrain_->resync();
  count();
}

void Turmoil::act(const Move& move) {
  switch (move.kind) {
    case Move::Kind::body:
      return static_cast<void>(addBody(move));
    case Move::Kind::shot:
      return shoot(move);
    case Move::Kind::portal:
      return portal(move);
    case Move::Kind::undo:
      return undo(move.which);
    case Move::Kind::redo:
      return redo(move.which);
    case Move::Kind::save:
      file_.clear();
      return static_cast<void>(world_.save([&](auto bytes) { file_.insert(file_.end(), bytes.begin(), bytes.end()); }));
    case Move::Kind::load:
      return load();
    case Move::Kind::origin:
      origin_ = {move.x - 64, move.y - 64};
      return crowd_.moveOrigin(*terrain_, origin_);
    case Move::Kind::kick: {
      if (crowd_.bodies.empty()) return;
      const Body body = crowd_.bodies[static_cast<std::size_t>(move.which) % crowd_.bodies.size()];
      if (!Crowd::isEnabled(body)) return;
      const auto speed = 4.0F * static_cast<float>(move.size);
      const float angle = 0.1F * static_cast<float>(move.x);
      return Crowd::kick(body, {speed * std::cos(angle), speed * std::sin(angle)});
    }
    default:
      edit(move);
      sync(world_.commit());
      marks_.resize(now_ + 1);
      if (now_ == kMostUndo) {
        static_cast<void>(world_.forget(marks_.front()));
        marks_.erase(marks_.begin());
      }
      marks_.push_back(world_.mark());
      now_ = marks_.size() - 1;
      return;
  }
}

// The law: a middle that was free is free, unless the body is disabled, and then it does not move.
std::optional<std::string> Turmoil::look(const char* after) {
  std::optional<std::string> wrong;
  for (std::size_t k = 0; k < crowd_.bodies.size(); ++k) {
    const Body body = crowd_.bodies[k];
    Watched& watched = watched_[k];
    const bool isHeld = !Crowd::isEnabled(body);
    const Point at = terrain_->latticePoint(Crowd::positionOf(body));
    if (isHeld && watched.isHeld && std::hypot(at.x - watched.at.x, at.y - watched.at.y) > U / 100 && !wrong)
      wrong = std::string(after) + ", body " + std::to_string(k) + " moved while it was disabled";
    watched.at = at;
    const std::vector<Position> middles = Crowd::middlesOf(body);
    std::vector<bool> isFreeNow;
    for (const Position& middle : middles) isFreeNow.push_back(isFree(middle));
    for (std::size_t m = 0; m < middles.size(); ++m) {
      const bool wasFree = watched.isFree.empty() || watched.isHeld || watched.isFree[m];
      const bool isRight = isFreeNow[m] && !isOut(terrain_->latticePoint(middles[m]));
      if (isHeld || !wasFree || isRight || wrong) continue;
      std::ostringstream text;
      const Point p = terrain_->latticePoint(middles[m]);
      text << after << ", body " << k << " is in the ground, its middle " << m << " at " << double(p.x) / U << " "
           << double(p.y) / U;
      wrong = text.str();
    }
    if (std::ranges::all_of(isFreeNow, std::identity())) watched.free = at;
    watched.isFree = std::move(isFreeNow);
    watched.isHeld = isHeld;
  }
  return wrong;
}

std::optional<std::string> Turmoil::play(const Move& move) {
  act(move);
  std::optional<std::string> wrong = look("after the move");
  for (int k = 0; k < arena_.steps; ++k) {
    step();
    if (!wrong) wrong = lookAtPutBacks();
    const std::optional<std::string> later = look("after a step");
    if (!wrong) wrong = later;
  }
  return wrong;
}

void Turmoil::step() {
  if (!arena_.announces) terrain_->beforeStep();
  crowd_.step();
  putBack_ = terrain_->afterStep();
  putBacks_ += putBack_.size();
}

// Who was put back is where that very body was free last.
std::optional<std::string> Turmoil::lookAtPutBacks() const {
  for (const Body body : putBack_) {
    const auto found = std::ranges::find_if(crowd_.bodies, [&](Body b) { return Crowd::areSame(b, body); });
    const auto k = static_cast<std::size_t>(found - crowd_.bodies.begin());
    const Point at = terrain_->latticePoint(Crowd::positionOf(body)), free = watched_[k].free;
    if (std::hypot(at.x - free.x, at.y - free.y) > U / 8)
      return "body " + std::to_string(k) + " was put back to where it never was";
  }
  return {};
}

bool Turmoil::isOut(Point p) const {
  return p.x < 0 || p.y < 0 || p.x > std::int64_t{arena_.width} * U || p.y > std::int64_t{arena_.height} * U;
}

std::size_t Turmoil::lost() const {
  const auto isLost = [&](Body body) {
    if (!Crowd::isEnabled(body)) return false;
    const std::vector<Position> middles = Crowd::middlesOf(body);
    return std::none_of(middles.begin(), middles.end(),
                        [&](const Position& m) { return isFree(m) && !isOut(terrain_->latticePoint(m)); });
  };
  return static_cast<std::size_t>(std::count_if(crowd_.bodies.begin(), crowd_.bodies.end(), isLost));
}

}  // namespace lgs::box2d_test
