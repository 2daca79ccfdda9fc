// The Box2D adapter: after every commit the fixtures are the world's segments, vertex by vertex, with their ghosts, no
// more and no fewer. Where segments are too short for Box2D, or merged, the rules of <lgs/box2d/edges.h> say what stands
// for them: then the terrain that was kept up to date must equal one made anew.
#include "fuzz/target.h"
#include "oracle/trace/player.h"

#include <box2d/box2d.h>
#include <fmt/format.h>
#include <lgs/box2d/terrain.h>
#include <algorithm>
#include <array>
#include <set>
#include <tuple>

namespace lgs::fuzz {
namespace {

using box2d::Terrain;
using box2d::TerrainOptions;

constexpr std::array kActions{Action::replace, Action::replace, Action::place,  Action::hull,
                              Action::fill,    Action::remove,  Action::remove, Action::clear};

constexpr double kCellSize = 64;  // metres: a lattice unit is a fifth of what Box2D takes for nothing

// v0, v1, v2, v3 and where the body is.
using Placed = std::array<float, 10>;

std::multiset<Placed> fixturesOf(const b2World& physics) {
  std::multiset<Placed> all;
  for (const b2Body* body = physics.GetBodyList(); body; body = body->GetNext()) {
    for (const b2Fixture* fixture = body->GetFixtureList(); fixture; fixture = fixture->GetNext()) {
      const auto& edge = static_cast<const b2EdgeShape&>(*fixture->GetShape());
      all.insert({edge.m_vertex0.x, edge.m_vertex0.y, edge.m_vertex1.x, edge.m_vertex1.y, edge.m_vertex2.x,
                  edge.m_vertex2.y, edge.m_vertex3.x, edge.m_vertex3.y, body->GetPosition().x, body->GetPosition().y});
    }
  }
  return all;
}

class Run {
 public:
  Run(const oracle::Trace& trace, TerrainOptions options) : player_(trace.preserve), options_(std::move(options)) {
    terrain_.emplace(physics_, player_.world(), options_);
  }

  std::string commit() {
    terrain_->sync(player_.commit());
    const World& world = player_.world();
    const std::multiset<Placed> fixtures = fixturesOf(physics_);
    b2World otherPhysics({0, 0});
    const Terrain fresh(otherPhysics, world, options_);
    if (fixtures != fixturesOf(otherPhysics)) {
      return fmt::format("{} fixtures, {} in a terrain made anew, or others\n", fixtures.size(),
                         fixturesOf(otherPhysics).size());
    }
    if (options_.merge) return {};
    const std::int64_t shortest = terrain_->edges().options().shortest;
    std::vector<Segment> segments;
    for (const SegmentId id : world.segments()) segments.push_back(*world.segment(id));
    const auto isShort = [&](const Segment& s) {
      const std::int64_t x = s.end.x - s.start.x;
      const std::int64_t y = s.end.y - s.start.y;
      return x * x + y * y < shortest * shortest;
    };
    if (std::any_of(segments.begin(), segments.end(), isShort)) return {};
    if (fixtures.size() != segments.size()) {
      return fmt::format("{} fixtures for {} segments\n", fixtures.size(), segments.size());
    }
    for (const Segment& s : segments) {
      if (std::string text = compare(s); !text.empty()) return text;
    }
    return {};
  }

  oracle::Player& player() { return player_; }

 private:
  std::string compare(const Segment& s) {
    const b2Fixture* const fixture = terrain_->fixture(s.id);
    const auto name = [&] { return fmt::format("segment {} ({}, {})", s.id.value, s.start.x, s.start.y); };
    if (!fixture) return name() + " has no fixture\n";
    const auto hit = terrain_->hit(*fixture);
    if (!hit || hit->segment != s.id || hit->polygon != s.polygon || hit->block != s.block || hit->cell != s.cell) {
      return name() + ": its fixture stands for another one\n";
    }
    const auto& edge = static_cast<const b2EdgeShape&>(*fixture->GetShape());
    const auto down = [&](std::int32_t index) {
      const std::int32_t n = options_.chunkCells;
      return std::int64_t{index / n - (index % n < 0 ? 1 : 0)} * n * kUnitsPerCell;
    };
    const auto is = [&](const b2Vec2& v, Point p) {
      const auto metres = [](std::int64_t units) {
        return static_cast<float>(static_cast<double>(units) * kCellSize / kUnitsPerCell);
      };
      return v.x == metres(p.x - down(s.cell.i)) && v.y == metres(p.y - down(s.cell.j));
    };
    if (!edge.m_oneSided || !is(edge.m_vertex1, s.start) || !is(edge.m_vertex2, s.end)) {
      return name() + ": its fixture lies elsewhere\n";
    }
    if ((s.predecessor && !is(edge.m_vertex0, s.ghost1)) || (s.successor && !is(edge.m_vertex3, s.ghost2))) {
      return name() + ": its fixture has another ghost\n";
    }
    return {};
  }

  oracle::Player player_;
  b2World physics_{{0, 0}};
  TerrainOptions options_;
  std::optional<Terrain> terrain_;
};

std::optional<Finding> checkWith(TerrainOptions options, const oracle::Trace& trace, oracle::CheckStats& stats) {
  Run run(trace, std::move(options));
  const auto judge = [&](std::size_t edits) -> std::optional<Finding> {
    ++stats.commits;
    std::string text = run.commit();
    if (text.empty()) return std::nullopt;
    oracle::Mismatch mismatch;
    mismatch.kind = oracle::Mismatch::Kind::changes;
    mismatch.text = text;
    mismatch.edits = edits;
    mismatch.scene = run.player().scene();
    return Finding{std::move(text), std::move(mismatch)};
  };
  for (std::size_t k = 0; k < trace.edits.size(); ++k) {
    const oracle::Edit& edit = trace.edits[k];
    if (edit.kind != oracle::Edit::Kind::commit) {
      ++stats.edits;
      if (!run.player().apply(edit)) ++stats.refused;
    } else if (auto finding = judge(k + 1)) {
      return finding;
    }
  }
  return judge(trace.edits.size());
}

std::optional<Finding> checkTrace(const oracle::Trace& trace, oracle::CheckStats& stats) {
  auto finding = checkWith({.cellSize = kCellSize, .chunkCells = 1}, trace, stats);
  return finding ? finding : checkWith({.cellSize = kCellSize, .chunkCells = 3, .merge = true}, trace, stats);
}

std::optional<Finding> check(Bytes input, oracle::CheckStats& stats) { return checkTrace(decode(input), stats); }

}  // namespace

const Target kBox2d{
    "box2d", "the Box2D adapter: fixtures are the world's segments", check, decode, checkTrace, kActions, {}};

}  // namespace lgs::fuzz
