#include "way_out.h"

#include "geometry/sort.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace lgs::box2d {

namespace {

constexpr std::size_t kDirections = 24;
constexpr double kGrowth = 1.3;                     // from ring to ring
constexpr double kFarthest = 16.0 * kUnitsPerCell;  // of a ring
constexpr int kHalvings = 5;
constexpr std::size_t kMostWork = 100'000;
constexpr std::size_t kWorkOfQuestion = 16;  // to ask what is in a place, in pieces

std::array<DoublePoint, kDirections> directions() {
  std::array<DoublePoint, kDirections> all;
  for (std::size_t k = 0; k < kDirections; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kDirections;
    all[k] = {std::cos(angle), std::sin(angle)};
  }
  return all;
}

double side(DoublePoint a, DoublePoint b, DoublePoint p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

double leftEndOf(const Piece& piece) { return static_cast<double>(std::min(piece.line.start.x, piece.line.end.x)); }

/// Whether two lines have a point in common, or nearly.
bool meet(DoublePoint a, DoublePoint b, DoublePoint c, DoublePoint d) {
  return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

}  // namespace

WayOut::WayOut(const NewGround& ground, std::span<const Form> forms, double tolerance)
    : ground_(ground), forms_(forms), tolerance_(tolerance), box_(boxOf(forms)) {}

void WayOut::Row::sort() {
  detail::sort(pieces, [](const Piece& a, const Piece& b) { return leftEndOf(a) < leftEndOf(b); });
  widest = 0;
  for (const Piece& piece : pieces)
    widest = std::max(widest, std::abs(static_cast<double>(piece.line.start.x - piece.line.end.x)));
}

/// Those that may have a point in a range of x, and maybe more.
std::span<const Piece> WayOut::Row::between(double min, double max) const {
  const auto first = std::ranges::lower_bound(pieces, min - widest, {}, leftEndOf);
  const auto last = std::ranges::upper_bound(first, pieces.end(), max, {}, leftEndOf);
  return {first, last};
}

bool WayOut::hasWork() const { return work_ < kMostWork; }

void WayOut::look(double radius) {
  if (radius <= looked_) return;
  looked_ = radius == 0 ? 0 : 2 * radius;
  ground_.linesIn({{box_.min.x - looked_, box_.min.y - looked_}, {box_.max.x + looked_, box_.max.y + looked_}},
                  now_.pieces, before_.pieces);
  now_.sort();
  before_.sort();
  work_ += now_.pieces.size() + before_.pieces.size();
}

bool WayOut::isFree(DoublePoint by) {
  look(std::max(std::abs(by.x), std::abs(by.y)));
  for (const Form& form : forms_) {
    work_ += kWorkOfQuestion;
    if (ground_.isSolid(form, moved(form.middle, by))) return false;
  }
  for (const Form& form : forms_) {
    const Box box = boxOf({&form, 1});
    const std::span<const Piece> near = now_.between(box.min.x + by.x, box.max.x + by.x);
    work_ += near.size();
    for (const Piece& piece : near) {
      const DoublePoint a = moved(real(piece.line.start), {-by.x, -by.y});
      const DoublePoint b = moved(real(piece.line.end), {-by.x, -by.y});
      if (std::max(a.x, b.x) < box.min.x || std::min(a.x, b.x) > box.max.x || std::max(a.y, b.y) < box.min.y ||
          std::min(a.y, b.y) > box.max.y)
        continue;
      if (form.holds(piece.block) && reaches(form, a, b, tolerance_)) return false;
    }
  }
  return true;
}

// A piece that is gone has no block any more, so it is in the way of every form.
bool WayOut::isOpen(DoublePoint by) {
  for (const Form& form : forms_) {
    const DoublePoint to = moved(form.middle, by);
    const auto [min, max] = std::minmax(form.middle.x, to.x);
    const std::span<const Piece> near = before_.between(min, max);
    work_ += near.size();
    for (const Piece& piece : near)
      if (meet(form.middle, to, real(piece.line.start), real(piece.line.end))) return false;
  }
  return true;
}

// A direction in which an edge is in the way stays closed on all larger rings; one that is open is open up to there.
std::optional<DoublePoint> WayOut::find() {
  static const std::array<DoublePoint, kDirections> all = directions();
  if (isFree()) return DoublePoint{0, 0};
  double core = std::numeric_limits<double>::infinity();
  for (const Form& form : forms_) core = std::min(core, coreOf(form));
  std::vector<DoublePoint> open(all.begin(), all.end());
  double inner = 0;
  for (double radius = std::max(core / 2, 64.0); radius < kFarthest && hasWork(); radius *= kGrowth) {
    look(radius);
    std::erase_if(open, [&](DoublePoint direction) {
      return !hasWork() || !isOpen({radius * direction.x, radius * direction.y});
    });
    if (open.empty()) break;
    double best = std::numeric_limits<double>::infinity();
    DoublePoint way;
    for (const DoublePoint& direction : open) {
      const auto at = [&](double r) { return DoublePoint{r * direction.x, r * direction.y}; };
      if (!hasWork() || !isFree(at(radius))) continue;
      double near = inner, far = radius;
      for (int k = 0; k < kHalvings && near < best; ++k) {
        const double r = (near + far) / 2;
        (isFree(at(r)) ? far : near) = r;
      }
      if (far < best) {
        best = far;
        way = at(far);
      }
    }
    if (best <= radius) return way;
    inner = radius;
  }
  return std::nullopt;
}

// What was in the solid before may pass through it, so it does not count.
std::optional<Catch> catchOf(const NewGround& ground, std::vector<Form> forms, Whose whose, double tolerance) {
  const auto isOverlapped = [&](const Form& form) { return ground.catches(form); };
  if (std::none_of(forms.begin(), forms.end(), isOverlapped)) return std::nullopt;
  if (whose == Whose::free) std::erase_if(forms, [&](const Form& form) { return !ground.wasFree(form); });
  Catch found;
  std::vector<Form> caught;
  std::ranges::copy_if(forms, std::back_inserter(caught), isOverlapped);
  if (caught.empty()) return std::nullopt;
  for (const Form& form : caught) found.depth = std::max(found.depth, ground.depthIn(form));  // 0, if it has no core
  found.way = WayOut(ground, forms, tolerance).find();
  return found;
}

// A way from where the middles are free crosses no edge of the outline.
std::optional<DoublePoint> releaseOf(const World& world, std::span<const Form> forms, const Box& changed,
                                     double tolerance) {
  if (!overlap(boxOf(forms), changed)) return std::nullopt;
  const NewGround ground(world);
  if (!std::all_of(forms.begin(), forms.end(), [&](const Form& form) { return ground.isFree(form); }))
    return std::nullopt;
  return WayOut(ground, forms, tolerance).find();
}

}  // namespace lgs::box2d
