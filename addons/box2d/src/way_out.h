// How a body that new ground overlaps gets out. It knows no Box2D.
//
// The way out is a straight move without a turn. In its place no edge of the outline reaches into a form by more than
// a tolerance, and each middle is free. On the way no middle touches an edge of the *old* outline: so nobody comes
// through a wall that was there before. Places are tried on rings, 24 on each; the least ring with a free place counts,
// and halving brings it nearer. The work is bounded: who has no way out by then has none.
#pragma once

#include "new_ground.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace lgs::box2d {

/// Looks for a way out of the ground.
class WayOut {
 public:
  /// For forms that move together; both must outlive it. `tolerance` is in lattice units.
  WayOut(const NewGround& ground, std::span<const Form> forms, double tolerance);

  /// The shortest way that was found, in lattice units; (0, 0) if there is no need to move.
  std::optional<DoublePoint> find();

  /// Whether nothing reaches into the forms where they are.
  bool isFree() { return isFree({0, 0}); }

 private:
  /// Pieces from left to right, so that those near a form are found without a look at all of them.
  struct Row {
    std::vector<Piece> pieces;
    double widest = 0;
    void sort();
    std::span<const Piece> between(double min, double max) const;
  };

  bool hasWork() const;
  void look(double radius);
  bool isFree(DoublePoint by);
  bool isOpen(DoublePoint by);

  const NewGround& ground_;
  std::span<const Form> forms_;
  double tolerance_;
  Box box_;             // around the forms
  double looked_ = -1;  // how far around
  Row now_;
  Row before_;
  std::size_t work_ = 0;  // pieces that were looked at
};

/// What becomes of forms that move together.
struct Catch {
  double depth = 0;                ///< how deep the ground is in them
  std::optional<DoublePoint> way;  ///< out of it, if there is one
};

/// Whose forms may be overlapped: those that were free before, or all, as bodies may have been moved meanwhile.
enum class Whose { free, all };

/// Whether new ground catches forms, and how they get out.
std::optional<Catch> catchOf(const NewGround& ground, std::vector<Form> forms, Whose whose, double tolerance);

/// The way into freedom of forms that were overlapped before; nothing if they are to stay. `changed` is where the ground is
/// different from before.
std::optional<DoublePoint> releaseOf(const World& world, std::span<const Form> forms, const Box& changed,
                                     double tolerance);

}  // namespace lgs::box2d
