// What leaves the ground as a body weighs what its polygons weigh: that it is those, and that it comes back, is in the
// model. What is foreseen is what happens in a world in which it is done, and leaves no trace.
#include "oracle/check/laws/list.h"
#include "oracle/check/observed.h"
#include "oracle/views/island_check.h"

#include <lgs/islands.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace lgs::oracle {
namespace {

// Summed up about the centroid that is told, where nothing cancels: the area, how far that is off, and the moment.
bool isMassOf(const Body& body) {
  using Real = std::array<double, 2>;
  double area = 0, offX = 0, offY = 0, moment = 0, size = 1;
  for (const BodyPolygon& p : body.polygons) {
    const auto at = [&](std::size_t k) {
      const LocalPoint v = p.vertices[k % p.vertices.size()];
      return Real{p.cell.i + double{1} * v.x / kUnitsPerCell - body.mass.centroid.x,
                  p.cell.j + double{1} * v.y / kUnitsPerCell - body.mass.centroid.y};
    };
    for (std::size_t k = 0; k < p.vertices.size(); ++k) {
      const auto [ax, ay] = at(k);
      const auto [bx, by] = at(k + 1);
      const double turn = ax * by - ay * bx;
      area += turn / 2;
      offX += (ax + bx) * turn / 6;
      offY += (ay + by) * turn / 6;
      moment += (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) * turn / 12;
      size = std::max({size, std::abs(ax), std::abs(ay)});
    }
  }
  constexpr double kNear = 1e-7;
  const double most = kNear * size * std::max(area, 1e-9);
  return std::abs(area - body.mass.area) <= kNear * area && std::abs(offX) <= most && std::abs(offY) <= most &&
         std::abs(moment - body.mass.secondMoment) <= kNear * size * moment + 1e-12;
}

// The islands that changes name and that there are afterwards.
std::vector<IslandFacts> namedAfter(const Islands& islands) {
  std::set<IslandId> ids;
  const IslandChanges& changes = islands.changes();
  for (const auto* each : {&changes.added, &changes.changed}) ids.insert(each->begin(), each->end());
  for (const IslandPair& pair : changes.cutOff) ids.insert({pair.from, pair.into});
  for (const IslandPair& pair : changes.joined) ids.insert(pair.into);
  std::vector<IslandFacts> facts;
  for (const IslandId id : ids)
    if (const auto known = islands.island(id)) facts.push_back(*known);
  return facts;
}

class BodiesLaw : public Law {
 public:
  void before(Seen& seen, const Judged& judged) override {
    const Player& player = seen.library->player();
    taken_ = player.caller().bodies.size();
    if (judged.call.kind != Call::Kind::foresee) return;
    before_ = seen.world();
    Player other = player;  // in which it is done
    would_.emplace(other.world(), isAnchorOfView);
    islands_ = would_->all().size();
    for (const Call& part : judged.call.group) static_cast<void>(other.apply(part));
    if (!would_->update(other.world(), other.commit())) would_.reset();
  }

  Found after(Seen& seen, const Judged& judged, bool isRefused) override {
    if (isRefused) return std::nullopt;
    std::string wrong;
    const std::vector<Body>& bodies = seen.library->player().caller().bodies;
    if (judged.call.kind == Call::Kind::take)
      for (std::size_t k = taken_; k < bodies.size(); ++k)
        if (!isMassOf(bodies[k])) wrong = "a body has another mass than its polygons";
    if (judged.call.kind == Call::Kind::foresee) wrong = wrongForesight(seen);
    return wrong.empty() ? std::nullopt : Found(seen.mismatch(Mismatch::Kind::views, std::move(wrong)));
  }

 private:
  std::string wrongForesight(Seen& seen) const {
    const Outcome& outcome = seen.library->player().foreseen();
    const std::string difference = differenceOf(before_, seen.world());
    if (!difference.empty()) return "foresee() leaves " + difference;
    if (outcome.count != islands_) return "foresee() leaves other islands in the view";
    const std::string wrong = wrongLists(would_ ? would_->changes() : IslandChanges(), outcome.foreseen.changes);
    if (!wrong.empty()) return "foresee() foresees something else: " + wrong;
    const bool areSame = outcome.foreseen.after == (would_ ? namedAfter(*would_) : std::vector<IslandFacts>());
    return areSame ? "" : "foresee() foresees other facts";
  }

  std::size_t taken_ = 0, islands_ = 0;
  World before_;
  std::optional<Islands> would_;
};

}  // namespace

std::unique_ptr<Law> laws::bodies() { return std::make_unique<BodiesLaw>(); }

}  // namespace lgs::oracle
