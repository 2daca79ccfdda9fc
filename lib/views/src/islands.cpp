// The public face of the islands.
#include "geometry/sort.h"
#include "island_view.h"

#include <algorithm>
#include <utility>

namespace lgs {

struct Islands::Impl {
  Impl(const World& world, IsAnchor isAnchor, AtEdge edge)
      : atEdge(edge), loops(world, edge), view(std::move(isAnchor)) {
    view.load(ground(world), loops);
  }
  /// The world that the view looks at: in the second one nothing is unloaded.
  const World& ground(const World& world) const { return atEdge == AtEdge::open ? loops.outline(world) : world; }

  AtEdge atEdge;
  Loops loops;
  detail::IslandView view;
};

Islands::Islands(const World& world, IsAnchor isAnchor, AtEdge atEdge) noexcept
    : impl_(std::make_unique<Impl>(world, std::move(isAnchor), atEdge)) {}
Islands::~Islands() noexcept = default;
Islands::Islands(const Islands& other) noexcept : impl_(std::make_unique<Impl>(*other.impl_)) {}
Islands& Islands::operator=(const Islands& other) noexcept {
  Islands copy(other);
  impl_.swap(copy.impl_);
  return *this;
}
Islands::Islands(Islands&&) noexcept = default;
Islands& Islands::operator=(Islands&&) noexcept = default;

bool Islands::update(const World& world, const Changes& changes) noexcept {
  if (!world.followsCells() || changes.before != world.versionBeforeCellChanges()) return false;
  if (impl_->atEdge == AtEdge::holds && world.hasUncommitted()) return false;  // it walks through the polygons
  if (!impl_->loops.update(world, changes)) return false;
  impl_->view.update(impl_->ground(world), impl_->loops);
  return true;
}

const IslandChanges& Islands::changes() const noexcept { return impl_->view.changes(); }
std::optional<IslandFacts> Islands::island(IslandId id) const noexcept {
  if (!impl_->view.isIsland(id)) return std::nullopt;
  return impl_->view.facts(impl_->loops, id);
}
IslandId Islands::of(const World& world, PolygonHandle polygon) const noexcept {
  const auto found = world.polygon(polygon);
  if (!found) return found.error().code == ErrorCode::unloaded && impl_->atEdge == AtEdge::holds ? kBeyond : IslandId{};
  detail::Locator locator(impl_->loops.outline(world), impl_->loops);
  return impl_->view.ofLocated(locator.ofPolygon(*world.cellOf(polygon), found->vertices));
}
IslandId Islands::of(LoopId outer) const noexcept { return impl_->view.of(outer); }
std::vector<IslandId> Islands::all() const noexcept { return impl_->view.all(); }
std::vector<IslandId> Islands::loose() const noexcept {
  const IslandChanges& told = changes();
  std::vector<IslandId> ids = told.added;
  ids.insert(ids.end(), told.changed.begin(), told.changed.end());
  for (const IslandPair& cut : told.cutOff) ids.insert(ids.end(), {cut.from, cut.into});
  for (const IslandPair& joined : told.joined) ids.push_back(joined.into);
  detail::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::erase_if(ids, [&](IslandId id) {
    const auto facts = island(id);
    return !facts || facts->anchors > 0;
  });
  return ids;
}
const Loops& Islands::loops() const noexcept { return impl_->loops; }
std::uint64_t Islands::walked() const noexcept { return impl_->view.walked(); }

}  // namespace lgs
