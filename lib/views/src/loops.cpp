// The public face of the loops.
#include "bare_world.h"
#include "loop_view.h"

#include <cmath>
#include <optional>

namespace lgs {

struct Loops::Impl {
  detail::LoopView view;
  std::optional<detail::BareWorld> bare;  ///< under a preserve relation, or where the edge of memory is open
  std::uint64_t version = 0;
};

Loops::Loops(const World& world, AtEdge atEdge) noexcept : impl_(std::make_unique<Impl>()) {
  if (world.preserveRelation() || atEdge == AtEdge::open) impl_->bare.emplace(world, atEdge);
  impl_->view.load(outline(world));
  impl_->version = world.version();
}
Loops::~Loops() noexcept = default;
Loops::Loops(const Loops& other) noexcept : impl_(std::make_unique<Impl>(*other.impl_)) {}
Loops& Loops::operator=(const Loops& other) noexcept {
  Loops copy(other);
  impl_.swap(copy.impl_);
  return *this;
}
Loops::Loops(Loops&&) noexcept = default;
Loops& Loops::operator=(Loops&&) noexcept = default;

bool Loops::update(const World& world, const Changes& changes) noexcept {
  if (changes.before != impl_->version || changes.after != world.version()) return false;
  if (impl_->bare && (!world.followsCells() || changes.before != world.versionBeforeCellChanges())) return false;
  if (!impl_->view.update(outline(world), impl_->bare ? impl_->bare->follow(world) : changes)) return false;
  impl_->version = changes.after;
  return true;
}

const LoopChanges& Loops::changes() const noexcept { return impl_->view.changes(); }
std::optional<LoopFacts> Loops::loop(LoopId id) const noexcept {
  if (!impl_->view.isLoop(id)) return std::nullopt;
  return impl_->view.facts(id);
}
LoopId Loops::of(SegmentId segment) const noexcept { return impl_->view.of(segment); }
std::vector<LoopId> Loops::all() const noexcept { return impl_->view.all(); }
const World& Loops::outline(const World& world) const noexcept { return impl_->bare ? impl_->bare->world() : world; }
std::uint64_t Loops::version() const noexcept { return impl_->version; }
std::uint64_t Loops::visited() const noexcept { return impl_->view.visited(); }

double LoopFacts::area() const { return std::ldexp(doubleArea.toDouble(), -1 - 2 * kCellBits); }

}  // namespace lgs
