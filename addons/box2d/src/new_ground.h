// Ground that changes under bodies: which of them it catches. It knows no Box2D.
//
// A form of a body *was free* if its middle was outside of the solid before. It is *overlapped* if it was free, and if its
// middle is in the solid now, or if a new piece of the outline reaches deeper than half its core. (Box2D pushes a body
// out that is less deep. One that is deeper may pass through an edge.) Whether a middle was free follows from the
// segments that came and went: the outline runs around each solid once, so its winding number changes by one where free
// becomes solid.
#pragma once

#include "form.h"

#include <lgs/box2d/edges.h>

#include <optional>
#include <span>
#include <vector>

namespace lgs::box2d {

/// A piece of the outline.
struct Piece {
  Line line;
  Block block = 0;  ///< 0 for pieces of before
};

/// What a commit, a roll-back or a load did to the ground.
class NewGround {
 public:
  /// Nothing.
  explicit NewGround(const World& world) : world_(world) {}
  /// What changes did. `before` has not been told of them yet.
  NewGround(const World& world, const EdgeSet& before, const Changes& changes);
  /// All that is different from the edges, whatever was done to the world.
  NewGround(const World& world, const EdgeSet& before);

  /// Around all that came or went; a middle that is elsewhere was as free as it is. Nothing if nothing changed.
  const std::optional<Box>& box() const { return box_; }
  /// A box around each piece that came or went. Those of an outline that is closed are one place (placesOf()).
  std::vector<Box> boxes() const;

  /// Whether the middle of a form is outside of what holds it.
  bool isFree(const Form& form) const;
  /// Whether it was, before the change.
  bool wasFree(const Form& form) const;
  /// Whether a form that was free is overlapped.
  bool catches(const Form& form) const;
  /// How deep the ground is in a form that is overlapped: from half its core to all of it.
  double depthIn(const Form& form) const;

  /// The outline now, and what was the outline before and is not any more: what lies in or near a box.
  void linesIn(const Box& box, std::vector<Piece>& now, std::vector<Piece>& before) const;

  /// Whether a point is in ground that collides with a form.
  bool isSolid(const Form& form, DoublePoint p) const;

 private:
  void add(std::vector<Piece>& list, const Piece& piece);
  bool isKnown(Point p, int turns) const;
  std::optional<int> becameSolid(Point p) const;  // 1 if it did, -1 if it became free; on no edge

  const World& world_;
  std::vector<Piece> came_;
  std::vector<Piece> went_;
  std::vector<SegmentId> cameIds_;  // sorted
  std::optional<Box> box_;
};

/// Whether a middle came through ground in one step. Who moves by less than the thickness of its form can not: what is
/// seen then between two places may be a corner around which it went.
bool hasCrossed(const World& world, std::span<const Form> before, std::span<const Form> now);

}  // namespace lgs::box2d
