// The rocks of a Ground: those in the air, those that become ground, and those of other moments, to be undone or redone.
#pragma once

#include <lgs/ground_window.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace lgs::detail {

inline Rock atRest(Body ground) {
  const DoublePoint at{static_cast<double>(ground.origin.i), static_cast<double>(ground.origin.j)};
  return {std::move(ground), {.origin = at}};
}
/// Where it lies.
inline Rock stopped(Rock rock) {
  rock.velocity = {};
  rock.spin = 0;
  return rock;
}

/// It owns their bodies. Marks have numbers, as Ground gives them. What puts a rock into the ground is an edit, behind
/// which its caller drops the future and commits.
template <class Host>
class GroundRocks {
 public:
  using Handle = typename Host::Handle;

  GroundRocks(World& world, Host& host) : world_(world), host_(host) {}

  // --- Bodies

  /// A rock that was taken in the stretch after the mark `took`. What falls as soon as a rock became ground tries as that
  /// did, as it would fall again.
  void add(Rock rock, std::int64_t took) {
    rocks_.push_back({std::move(rock), {}, took, kNever, true, heirs_});
    ++added_;
  }
  /// Their bodies.
  void makeAdded() {
    for (; added_ > 0; --added_) make(rocks_[rocks_.size() - added_]);
    heirs_ = {};
  }
  /// What the game destroyed is not ground any more.
  void dropGone() {
    if (!host_.dropGone()) return;
    std::erase_if(rocks_, [&](const Fallen& f) { return f.isInAir && !isNull(f.handle) && !host_.has(f.handle); });
  }
  void destroyAll() {
    dropGone();
    for (const Fallen& f : rocks_)
      if (f.isInAir) destroy(f);
    rocks_.clear();
  }
  void forget(Handle handle) {
    std::erase_if(rocks_, [&](const Fallen& f) { return f.parts == 0 && is(f, handle); });
  }

  // --- Looking

  template <class Visit>
  void forEach(const Visit& visit) const {
    for (const Fallen& f : rocks_)
      if (f.isInAir) visit(f.handle, f.parts == 0 ? f.rock.ground : f.inParts->rest(f.parts).ground);
  }
  /// Whether something became a rock, or ground, in the stretch after a mark.
  bool anyOf(std::int64_t mark) const {
    return std::ranges::any_of(rocks_, [&](const Fallen& f) {
      return f.took == mark || f.settled == mark || std::ranges::binary_search(f.puts, mark);
    });
  }
  /// Whether an island may be a part of a rock of which the rest will hold it.
  bool willHold(const IslandFacts& island) const {
    return std::ranges::any_of(rocks_, [&](const Fallen& f) {
      return f.isInAir && f.parts > 0 && f.inParts->isNear(island.outer.min, island.outer.max);
    });
  }
  /// Those in the air. One of which a part is ground becomes ground in `whole`, as far as that takes it.
  std::vector<Rock> values(World& whole, const Shelf& shelf) const {
    std::vector<Rock> values;
    for (const Fallen& f : rocks_) {
      if (!f.isInAir) continue;
      if (f.parts == 0) {
        Rock is = isNull(f.handle) ? f.rock : host_.read(f.handle);
        values.push_back(isSound(is) ? std::move(is) : f.rock);
        continue;
      }
      std::size_t most = std::numeric_limits<std::size_t>::max();
      static_cast<void>(reloadInside(whole, f.inParts->chunks(), shelf, most));
      if (!f.inParts->put(whole, f.parts, f.inParts->count())) values.push_back(f.inParts->rest(f.parts));
    }
    return values;
  }

  // --- Settling, after the mark `now`

  /// The rocks in turn: one becomes ground, or some polygons of it, so many. One that does not fit, or would fall again,
  /// tries again later and later. Whether one did.
  bool settleNext(std::int64_t now, std::size_t atOnce) {
    ++steps_;
    for (Fallen& f : rocks_) {
      if (!f.isInAir || f.parts == 0 || steps_ < f.goesOnAt) continue;
      const bool isDone = putParts(f, f.parts + 1, now).has_value();
      if (!isDone) f.goesOnAt = steps_ + 60;
      return isDone;
    }
    for (std::size_t k = std::min<std::size_t>(rocks_.size(), 16); k > 0; --k) {
      Fallen& f = rocks_[next_++ % rocks_.size()];
      if (!f.isInAir || isNull(f.handle) || steps_ < f.tries.until) continue;
      if (!host_.lies(f.handle)) f.movedAt = steps_;
      if (steps_ - f.movedAt < kStepsOfRest || !host_.isHeld(f.handle)) continue;
      f.tries.until = steps_ + (std::uint64_t{60} << std::min(f.tries.count++, 6));
      if (isInOneOfWhichAPartIsGround(f)) continue;
      return (f.rock.ground.polygons.size() > atOnce ? beginParts(f, now, atOnce) : put(f, now)).has_value();
    }
    return false;
  }
  /// What is left of those of which a part is ground becomes ground, as far as that takes it. Whether some did.
  bool finish(std::int64_t now) {
    bool isAny = false;
    for (Fallen& f : rocks_)
      if (f.isInAir && f.parts > 0 && putParts(f, f.inParts->count(), now)) isAny = true;
    return isAny;
  }
  /// A rock, or what is left of it. Refused: staleHandle; overlap, where one lies of which a part is ground; as by the
  /// host's settle().
  Expected<void> settle(Handle handle, std::int64_t now) {
    const auto found = std::ranges::find_if(rocks_, [&](const Fallen& f) { return is(f, handle); });
    if (found == rocks_.end()) return tl::unexpected(Error{.code = ErrorCode::staleHandle});
    if (found->parts == 0 && isInOneOfWhichAPartIsGround(*found))
      return tl::unexpected(Error{.code = ErrorCode::overlap});
    return found->parts == 0 ? put(*found, now) : putParts(*found, found->inParts->count(), now);
  }

  // --- Undo

  /// The bodies of rocks that are none at a mark go; and those of rocks that are held now and were not, or were and are
  /// not.
  void leave(std::int64_t mark) {
    for (Fallen& f : rocks_) {
      const bool wasHeld = std::exchange(f.parts, partsAt(f, mark)) > 0;
      const bool isHeld = f.parts > 0 && isThere(f, mark);
      if (!f.isInAir || (isThere(f, mark) && wasHeld == isHeld)) continue;
      destroy(f);
      f.handle = {};
      f.isInAir = false;
      if (f.took >= mark) f.rock = atRest(std::move(f.rock.ground));
    }
  }
  /// Those that are rocks at a mark and have no body get one, where they lay.
  void comeBack(std::int64_t mark) {
    for (Fallen& f : rocks_) {
      if (f.isInAir || !isThere(f, mark)) continue;
      if (f.parts > 0) f.rock = stopped(f.inParts->whole());
      f.tries = {};
      make(f);
    }
  }
  void dropFuture(std::int64_t now) {
    std::erase_if(rocks_, [&](const Fallen& f) { return !f.isInAir && f.took >= now; });
    for (Fallen& f : rocks_) {
      if (!f.isInAir) continue;
      f.settled = kNever;
      f.puts.resize(f.parts);
    }
  }
  void forgetBefore(std::int64_t oldest) {
    std::erase_if(rocks_, [&](const Fallen& f) { return !f.isInAir && f.settled < oldest; });
  }

 private:
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  static constexpr std::uint64_t kStepsOfRest = 30;  // half a second, as in Box2D

  /// How often one did not become ground by itself, or nothing held it then; and the step before which it does not try.
  struct Tries {
    int count = 0;
    std::uint64_t until = 0;
  };
  /// A rock, and between which marks it is one.
  struct Fallen {
    Rock rock;
    Handle handle{};
    std::int64_t took = 0;
    std::int64_t settled = kNever;
    bool isInAir = true;
    Tries tries{};
    std::uint64_t movedAt = 0;  ///< the step at which it moved last, as far as that was seen
    /// Of one that becomes ground in parts: after which mark each of them did, also those that are undone.
    std::vector<std::int64_t> puts{};
    std::size_t parts = 0;                         ///< how many of them are ground now; then its body is held
    std::shared_ptr<const RockInParts> inParts{};  ///< these
    std::uint64_t goesOnAt = 0;                    ///< the step before which the next one does not try
  };

  static bool isNull(Handle handle) { return Host::isSame(handle, Handle{}); }
  /// One without a body is named by none.
  static bool is(const Fallen& f, Handle handle) {
    return f.isInAir && !isNull(handle) && Host::isSame(f.handle, handle);
  }
  static bool isThere(const Fallen& f, std::int64_t mark) { return f.took < mark && f.settled >= mark; }
  /// How many parts of a rock are ground at a mark.
  static std::size_t partsAt(const Fallen& f, std::int64_t mark) {
    return static_cast<std::size_t>(std::ranges::lower_bound(f.puts, mark) - f.puts.begin());
  }
  void make(Fallen& f) {
    f.handle = host_.make(f.rock);
    if (f.parts > 0 && !isNull(f.handle)) host_.hold(f.handle);
    f.movedAt = steps_;
    f.isInAir = true;
  }
  void destroy(const Fallen& f) {
    if (!isNull(f.handle)) host_.destroy(f.handle);
  }

  /// Its ground would be lost where the rest of that comes. That will push it out.
  bool isInOneOfWhichAPartIsGround(const Fallen& f) const {
    const auto isHeld = [](const Fallen& other) { return other.isInAir && other.parts > 0; };
    if (std::ranges::none_of(rocks_, isHeld)) return false;
    const auto placing = host_.placingOf(f.handle);
    if (!placing) return false;
    const auto lying = RockInParts::of(host_.read(f.handle), *placing, f.rock.ground.polygons.size());
    return lying && std::ranges::any_of(rocks_, [&](const Fallen& other) {
             return isHeld(other) && other.inParts->isNear(lying->min(), lying->max());
           });
  }
  Expected<void> put(Fallen& f, std::int64_t now) {
    f.rock = stopped(host_.read(f.handle));
    const auto done = host_.settle(f.handle);
    if (done) becomeGround(f, now);
    return done;
  }
  Expected<void> beginParts(Fallen& f, std::int64_t now, std::size_t atOnce) {
    const auto placing = host_.placingOf(f.handle);
    if (!placing) return tl::unexpected(placing.error());
    auto parts = RockInParts::of(host_.read(f.handle), *placing, std::max<std::size_t>(atOnce, 1));
    if (!parts) return tl::unexpected(parts.error());
    f.inParts = std::make_shared<const RockInParts>(std::move(*parts));
    f.puts.clear();
    return putParts(f, 1, now);
  }
  /// Puts parts of a rock until so many are ground.
  Expected<void> putParts(Fallen& f, std::size_t to, std::int64_t now) {
    if (const auto done = f.inParts->put(world_, f.parts, to); !done) return done;
    if (f.parts == 0) {
      f.rock = stopped(f.inParts->whole());
      host_.hold(f.handle);
    }
    f.puts.resize(f.parts);
    f.puts.resize(to, now);
    f.parts = to;
    if (to < f.inParts->count()) return {};
    destroy(f);
    becomeGround(f, now);
    return {};
  }
  void becomeGround(Fallen& f, std::int64_t now) {
    f.handle = {};
    f.isInAir = false;
    f.settled = now;
    heirs_ = f.tries;
  }

  World& world_;
  Host& host_;
  std::vector<Fallen> rocks_;
  std::size_t added_ = 0;    // the last ones, which have no bodies yet
  Tries heirs_;              // of those that are added
  std::uint64_t steps_ = 0;  // how often rocks could settle
  std::size_t next_ = 0;     // which of them looks first whether it can settle
};

}  // namespace lgs::detail
