#include "oracle/trace/player.h"

#include <fmt/format.h>

namespace lgs::oracle {
namespace {

PreserveRelation relationOf(const PreservePairs& pairs) {
  if (pairs.empty()) return {};
  return [pairs](Block a, Block b) { return pairs(a, b); };
}

tl::unexpected<TraceError> nameFault(std::string text) { return tl::unexpected(TraceError{0, std::move(text), {}}); }

// A line of a trace is one polygon, and the engine's handles mean nothing to whoever reads it.
std::string inTrace(Error error, const std::string& other) {
  if (error.code == ErrorCode::overlap && !other.empty()) {
    return fmt::format("cell ({}, {}): its interior overlaps '{}'", error.cell.i, error.cell.j, other);
  }
  error.polygon = -1;
  return message(error);
}

}  // namespace

Player::Player(PreservePairs preserve) : world_(relationOf(preserve)) { scene_.preserve = std::move(preserve); }

tl::expected<void, TraceError> Player::apply(const Edit& edit) {
  auto done = edit.kind == Edit::Kind::add ? add(edit.name, edit.polygon) : remove(edit.name);
  if (done) {
    pending_ = true;
  } else {
    done.error().line = edit.line;
  }
  return done;
}

const Changes& Player::commit() {
  pending_ = false;
  return world_.commit();
}

tl::expected<void, TraceError> Player::add(const std::string& name, const ScenePolygon& polygon) {
  if (isAlive(name)) {
    return nameFault(fmt::format("the name '{}' is in use; remove that polygon first, or choose another", name));
  }
  const auto handle = world_.add(polygon.cell, std::span<const LocalPoint>(polygon.vertices), polygon.block);
  if (!handle) {
    std::string other;
    for (const auto& [placedName, placed] : placed_) {
      if (handle.error().other && placed.handle == handle.error().other) other = placedName;
    }
    return tl::unexpected(TraceError{0, inTrace(handle.error(), other), handle.error().code});
  }
  placed_.emplace(name, Placed{*handle, names_.size()});
  names_.push_back(name);
  scene_.polygons.push_back(polygon);
  return {};
}

tl::expected<void, TraceError> Player::remove(const std::string& name) {
  const auto found = placed_.find(name);
  if (found == placed_.end()) return nameFault(fmt::format("there is no polygon named '{}' to remove", name));
  if (const auto done = world_.remove(found->second.handle); !done) {
    return tl::unexpected(TraceError{0, message(done.error()), done.error().code});
  }
  const std::size_t hole = found->second.index;
  placed_.erase(found);
  if (hole + 1 < names_.size()) {  // the last one fills the hole
    placed_.at(names_.back()).index = hole;
    names_[hole] = std::move(names_.back());
    scene_.polygons[hole] = std::move(scene_.polygons.back());
  }
  names_.pop_back();
  scene_.polygons.pop_back();
  return {};
}

tl::expected<void, TraceError> play(const Trace& trace, Player& player, const CommitCallback& afterCommit) {
  const auto commit = [&] {
    const Changes& changes = player.commit();
    return !afterCommit || afterCommit(player, changes);
  };
  for (const Edit& edit : trace.edits) {
    if (edit.kind == Edit::Kind::commit) {
      if (!commit()) return {};
    } else if (const auto done = player.apply(edit); !done) {
      return done;
    }
  }
  if (player.pending()) commit();
  return {};
}

}  // namespace lgs::oracle
