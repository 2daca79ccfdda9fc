// Random edits by brushes, among other edits.
#pragma once

#include "oracle/calls/call.h"
#include "oracle/calls/random.h"
#include "oracle/engine/capabilities.h"

#include <optional>
#include <span>
#include <vector>

namespace lgs::oracle {

/// All rings of a case have their vertices near one point, on a lattice with a step of its own: so each stroke meets what
/// the others have left.
struct Tight {
  Point centre;
  std::int64_t step = 1;  ///< units
};
Tight tightAt(Point centre, Random& random);

/// Rings on such a lattice: they cross, touch and overlap, and have spikes.
std::vector<std::vector<Point>> crossingRings(const Tight& lattice, Random& random);

BrushEdit::Deed anyDeed(Random& random);

/// A cell gets a patchwork or one of the degenerate shapes, as large as the cell or so small that rounding matters; and
/// round holes and spots are made in what others have left of it.
std::vector<Call> acrossShapes(Cell cell, const std::vector<Block>& blocks, Random& random);

/// A cell is emptied, gets triangles of one unit's height side by side, and a region across some: vertices of each are
/// less than a unit from the edges of others.
std::vector<Call> acrossSlivers(Cell cell, const std::vector<Block>& blocks, Random& random);

/// What strokes are made for.
struct StrokeHabits {
  std::vector<Block> blocks;        ///< at least one
  std::optional<Tight> tight = {};  ///< where all strokes are
  /// Rings of the stroke before: an edge may pass one of their corners, or a corner one of their edges.
  std::vector<std::vector<Point>> last = {};
  /// For an engine that takes regions they are even-odd, go around nothing, and are fit for what it can.
  Capabilities can = Capabilities::all();
};

/// A stroke at a cell, of one of these blocks, and around another one now and then: circles, stars, rectangles, thick
/// lines and rings that cross themselves, over several cells down to a few units; or as long as a region may be. A thick
/// line is one call, or one for each of its parts. Before some strokes the cells around are filled. The last rings are
/// those of this one afterwards.
std::vector<Call> strokeAt(Cell cell, StrokeHabits& habits, Random& random);

}  // namespace lgs::oracle
