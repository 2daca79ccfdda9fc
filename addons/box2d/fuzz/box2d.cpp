// The Box2D adapter: after every commit the fixtures are the world's segments, vertex by vertex, with the ways to their
// ghosts, no more and no fewer, and a fixture that is hit says which segment that is. Where segments are too short for
// Box2D, or merged, the rules of <lgs/box2d/edges.h> say what stands for them: then the terrain that was kept up to
// date must equal one made anew. An input whose first byte is kBodies or more is a game with bodies (bodies.h).
#include "addons/box2d/fuzz/bodies.h"
#include "fuzz/check_edits.h"
#include "oracle/check/refusal.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"

#include <box2d/box2d.h>
#include <fmt/format.h>
#include <lgs/box2d/terrain.h>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

namespace lgs::fuzz {
namespace box2d_target {
namespace {

using box2d::Edge;
using box2d::EdgeId;
using box2d::Hit;
using box2d::Terrain;
using box2d::TerrainOptions;

constexpr double kCellSize = 64;  // metres: a lattice unit is a fifth of what Box2D takes for nothing

// Of a ghost only the direction counts: one that gets longer or shorter is left as it was.
b2Vec2 towards(b2Vec2 near, b2Vec2 ghost) {
  b2Vec2 way = ghost - near;
  way.Normalize();
  return way;
}
bool isSameWay(b2Vec2 a, b2Vec2 b) { return b2DistanceSquared(a, b) < 1e-6F; }

struct Placed {
  box2d::Chunk chunk;          // far away, floats of two bodies are equal
  std::array<float, 4> place;  // v1 and v2, relative to the body
  b2Vec2 body;
  b2Vec2 before, after;  // the ways to the ghosts
  friend bool operator==(const Placed& a, const Placed& b) {
    return a.chunk == b.chunk && a.place == b.place && a.body == b.body && isSameWay(a.before, b.before) &&
           isSameWay(a.after, b.after);
  }
};

Placed placeOf(const Terrain& terrain, const b2Fixture& fixture, EdgeId id) {
  const auto& edge = static_cast<const b2EdgeShape&>(*fixture.GetShape());
  const b2Vec2 start = edge.m_vertex1, end = edge.m_vertex2;
  const box2d::EdgeSet& edges = terrain.edges();
  return {edges.chunk(edges.edge(id).chunk),
          {start.x, start.y, end.x, end.y},
          fixture.GetBody()->GetPosition(),
          towards(start, edge.m_vertex0),
          towards(end, edge.m_vertex3)};
}

std::optional<Placed> placeOf(const Terrain& terrain, const Segment& s) {
  const b2Fixture* const fixture = terrain.fixture(s.id);
  if (!fixture) return std::nullopt;
  return placeOf(terrain, *fixture, terrain.edges().edgeOf(s.id));
}

// Those that the terrain knows.
std::vector<Placed> placesOf(const Terrain& terrain) {
  std::vector<Placed> all;
  for (const EdgeId id : terrain.edges().edges())
    if (const b2Fixture* const fixture = terrain.fixture(id)) all.push_back(placeOf(terrain, *fixture, id));
  std::ranges::sort(all, {}, [](const Placed& p) { return std::pair(p.chunk, p.place); });
  return all;
}

// Those that physics has.
std::size_t countFixtures(const b2World& physics) {
  std::size_t count = 0;
  for (const b2Body* body = physics.GetBodyList(); body; body = body->GetNext())
    for (const b2Fixture* fixture = body->GetFixtureList(); fixture; fixture = fixture->GetNext()) ++count;
  return count;
}

bool isShorter(const Segment& s, std::int64_t length) {
  const std::int64_t x = s.end.x - s.start.x;
  const std::int64_t y = s.end.y - s.start.y;
  return x * x + y * y < length * length;
}

bool isParallel(const Segment& s, const Edge& edge) {
  return (s.end.x - s.start.x) * (edge.end.y - edge.start.y) == (s.end.y - s.start.y) * (edge.end.x - edge.start.x);
}

bool isHit(const std::optional<Hit>& hit, const Segment& s) {
  return hit && hit->segment == s.id && hit->polygon == s.polygon && hit->block == s.block && hit->cell == s.cell;
}

std::string name(const Segment& s) { return fmt::format("segment {} ({}, {})", s.id.value, s.start.x, s.start.y); }

struct Complaint {
  std::string text;
  oracle::Outline about = {};
  oracle::Mismatch::Kind kind = oracle::Mismatch::Kind::terrain;
};
using MayComplain = std::optional<Complaint>;

Complaint about(const Segment& s, const std::string& text) {
  return {fmt::format("{}{}\n", name(s), text), {oracle::outlineSegment(s)}};
}

class Run {
 public:
  Run(const oracle::Trace& trace, TerrainOptions options) : player_(trace.preserve), options_(std::move(options)) {
    terrain_.emplace(physics_, player_.world(), options_);
  }

  MayComplain commit() {
    terrain_->sync(player_.commit());
    segments_.clear();
    for (const SegmentId id : player_.world().segments()) segments_.push_back(*player_.world().segment(id));
    if (auto complaint = compareWithFresh()) return complaint;
    if (auto complaint = countChunks()) return complaint;
    if (auto complaint = hitEach()) return complaint;
    const std::int64_t shortest = terrain_->edges().options().shortest;
    const auto isShort = [&](const Segment& s) { return isShorter(s, shortest); };
    if (options_.merge || std::any_of(segments_.begin(), segments_.end(), isShort)) return std::nullopt;
    for (const Segment& s : segments_)
      if (auto complaint = compare(s)) return complaint;
    const std::size_t fixtures = terrain_->edges().edges().size();
    if (fixtures == segments_.size()) return std::nullopt;
    return Complaint{fmt::format("{} fixtures for {} segments\n", fixtures, segments_.size())};
  }

  oracle::Player& player() { return player_; }

 private:
  // A terrain made anew has the same bodies and fixtures.
  MayComplain compareWithFresh() {
    b2World physics({0, 0});
    const Terrain fresh(physics, player_.world(), options_);
    const std::vector<Placed> here = placesOf(*terrain_), there = placesOf(fresh);
    if (here != there) {
      Complaint complaint{
          fmt::format("{} fixtures, {} in a terrain made anew, or others\n", here.size(), there.size())};
      for (const Segment& s : segments_)
        if (placeOf(*terrain_, s) != placeOf(fresh, s)) complaint.about.push_back(oracle::outlineSegment(s));
      return complaint;
    }
    if (const std::size_t fixtures = countFixtures(physics_); fixtures != here.size())
      return Complaint{fmt::format("physics has {} fixtures, the terrain knows {}\n", fixtures, here.size())};
    const auto bodies = static_cast<std::size_t>(physics_.GetBodyCount());
    if (terrain_->bodyCount() == fresh.bodyCount() && bodies == fresh.bodyCount()) return std::nullopt;
    return Complaint{fmt::format("{} bodies, said to be {}, and {} in a terrain made anew\n", bodies,
                                 terrain_->bodyCount(), fresh.bodyCount())};
  }

  // A chunk that loses its last edge gives its number away at the next commit. So there are as many numbers as chunks
  // that had an edge before or after the same commit, at most.
  MayComplain countChunks() {
    const box2d::EdgeSet& edges = terrain_->edges();
    std::set<box2d::Chunk> now;
    for (const EdgeId id : edges.edges()) now.insert(edges.chunk(edges.edge(id).chunk));
    chunks_.insert(now.begin(), now.end());
    numbered_ = std::max(numbered_, chunks_.size());
    chunks_ = std::move(now);
    if (edges.chunkCount() == numbered_) return std::nullopt;
    return Complaint{fmt::format("chunkCount() is {}, but at most {} chunks had an edge before or after a commit\n",
                                 edges.chunkCount(), numbered_)};
  }

  // Each segment is found behind its fixture: the first one without a point, and each at a point in its middle.
  MayComplain hitEach() {
    const box2d::EdgeSet& edges = terrain_->edges();
    std::map<EdgeId, bool> isStraight;  // welded ones are not
    for (const Segment& s : segments_) {
      const EdgeId id = edges.edgeOf(s.id);
      if (id) isStraight.emplace(id, true).first->second &= isParallel(s, edges.edge(id));
    }
    for (const Segment& s : segments_) {
      const EdgeId id = edges.edgeOf(s.id);
      if (!id) continue;
      const b2Fixture* const fixture = terrain_->fixture(s.id);
      if (!fixture || fixture != terrain_->fixture(id)) return about(s, " has no fixture, or another edge's");
      if (edges.edge(id).first == s.id && !isHit(terrain_->hit(*fixture), s))
        return about(s, ": its fixture stands for another one");
      const Point middle{s.start.x + (s.end.x - s.start.x) / 2, s.start.y + (s.end.y - s.start.y) / 2};
      const auto hit = terrain_->hit(*fixture, terrain_->position(middle));
      if (!hit || edges.edgeOf(hit->segment) != id) return about(s, ": what is hit there is not of its fixture");
      if (isStraight[id] && isDistinct(s) && !isHit(hit, s))
        return about(s, fmt::format(": in its middle segment {} is hit", hit->segment.value));
    }
    return std::nullopt;
  }

  // Whether a float of Box2D's tells its middle from its ends: it is not too short, and not too far away.
  bool isDistinct(const Segment& s) const {
    constexpr std::int64_t kLong = 16;  // lattice units
    constexpr std::int32_t kNear = 100;
    const Cell o = options_.origin;
    const CellRect near{{o.i - kNear, o.j - kNear}, {o.i + kNear, o.j + kNear}};
    return !isShorter(s, kLong) && contains(near, s.cell);
  }

  // The fixture of a segment, where each has one.
  MayComplain compare(const Segment& s) {
    const b2Fixture* const fixture = terrain_->fixture(s.id);
    if (!fixture) return about(s, " has no fixture");
    const auto& edge = static_cast<const b2EdgeShape&>(*fixture->GetShape());
    const auto down = [&](std::int32_t index) {
      const std::int32_t n = options_.chunkCells;
      return std::int64_t{index / n - (index % n < 0 ? 1 : 0)} * n * kUnitsPerCell;
    };
    const auto metres = [&](Point p) {
      const auto of = [](std::int64_t units) {
        return static_cast<float>(static_cast<double>(units) * kCellSize / kUnitsPerCell);
      };
      return b2Vec2(of(p.x - down(s.cell.i)), of(p.y - down(s.cell.j)));
    };
    const auto is = [&](const b2Vec2& v, Point p) { return v == metres(p); };
    const auto isTowards = [&](b2Vec2 near, b2Vec2 v, Point ghost) {
      return isSameWay(towards(near, v), towards(near, metres(ghost)));
    };
    if (!edge.m_oneSided || !is(edge.m_vertex1, s.start) || !is(edge.m_vertex2, s.end))
      return about(s, ": its fixture lies elsewhere");
    if ((s.predecessor && !isTowards(edge.m_vertex1, edge.m_vertex0, s.ghost1)) ||
        (s.successor && !isTowards(edge.m_vertex2, edge.m_vertex3, s.ghost2)))
      return about(s, ": its fixture has another ghost");
    return std::nullopt;
  }

  oracle::Player player_;
  b2World physics_{{0, 0}};
  TerrainOptions options_;
  std::optional<Terrain> terrain_;
  std::vector<Segment> segments_;
  std::set<box2d::Chunk> chunks_;  // that have an edge
  std::size_t numbered_ = 0;       // see countChunks()
};

class Session {
 public:
  Session(const oracle::Trace& trace, TerrainOptions options, oracle::CheckStats& stats)
      : trace_(trace), run_(trace, std::move(options)), stats_(stats) {}

  std::optional<Finding> run() {
    for (const oracle::Call& call : trace_.calls) {
      ++edits_;
      const MayComplain complaint = call.kind == oracle::Call::Kind::commit ? commit() : apply(call);
      if (complaint) return finding(*complaint);
    }
    if (const MayComplain complaint = commit()) return finding(*complaint);
    return std::nullopt;
  }

 private:
  MayComplain commit() {
    ++stats_.commits;
    ++commits_;
    return run_.commit();
  }

  MayComplain apply(const oracle::Call& call) {
    ++stats_.edits;
    const auto done = run_.player().apply(call);
    if (done) return std::nullopt;
    if (done.error().isWrong) return Complaint{done.error().text + '\n', {}, oracle::Mismatch::Kind::verdict};
    ++stats_.refused;
    return std::nullopt;
  }

  Finding finding(Complaint complaint) {
    oracle::Mismatch mismatch;
    mismatch.kind = complaint.kind;
    mismatch.text = complaint.text;
    mismatch.edits = edits_;
    mismatch.commit = commits_;
    mismatch.scene = run_.player().scene();
    mismatch.expected = mismatch.actual = oracle::outlineOf(run_.player().world());
    mismatch.marked = std::move(complaint.about);
    return Finding{std::move(complaint.text), std::move(mismatch)};
  }

  const oracle::Trace& trace_;
  Run run_;
  oracle::CheckStats& stats_;
  std::size_t edits_ = 0;
  std::size_t commits_ = 0;
};

// Where the edits are, so that floats of the physics world tell their segments apart.
Cell originOf(const oracle::Trace& trace) {
  for (const oracle::Call& edit : trace.calls)
    for (const oracle::Coming& coming : edit.comes)
      if (inRange(coming.cell)) return coming.cell;
  return {};
}

std::optional<Finding> checkTrace(const oracle::Trace& trace, oracle::CheckStats& stats) {
  TerrainOptions options{.cellSize = kCellSize, .origin = originOf(trace), .chunkCells = 1};
  if (auto finding = Session(trace, options, stats).run()) return finding;
  options.chunkCells = 3;
  options.merge = true;
  return Session(trace, options, stats).run();
}

constexpr std::uint8_t kBodies = 128;
bool hasBodies(Bytes input) { return !input.empty() && input[0] >= kBodies; }

// A terrain is told of a roll-back by a call of its own (bodies.cpp).
oracle::Trace plainEdits(Bytes input) { return oracle::caseOf(input, {.edits = 2'048}); }

oracle::Trace traceOf(Bytes input) { return hasBodies(input) ? oracle::Trace() : plainEdits(input); }

std::optional<Finding> checkInput(Bytes input, oracle::CheckStats& stats) {
  return hasBodies(input) ? checkBodies(input, stats) : check<plainEdits, checkTrace>(input, stats);
}

constexpr Target kTarget{"box2d", "the Box2D adapter: fixtures are the world's segments; bodies", checkInput, traceOf,
                         checkTrace};

}  // namespace
}  // namespace box2d_target

const Target kBox2d = box2d_target::kTarget;

}  // namespace lgs::fuzz
