// What an engine can do. What it can not do is not held against it: the harness makes only worlds that the engine can
// have, and compares only what it puts out.
#pragma once

#include "oracle/reference/brush_edit.h"
#include "oracle/reference/scene.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace lgs::oracle {

struct Capabilities {
  bool ghosts = false;                   ///< it puts out ghosts
  bool blocks = false;                   ///< it puts out the block of each segment
  bool several = false;                  ///< several polygons in a cell
  bool slants = false;                   ///< edges that are not parallel to an axis
  bool squares = false;                  ///< only whole squares
  bool preserve = false;                 ///< a preserve relation
  bool refuses = false;                  ///< it refuses the edits that must be refused
  bool merged = false;                   ///< it joins collinear neighbours
  bool islands = false;                  ///< it puts out the islands
  bool delta = false;                    ///< it puts out what changed instead of the whole outline (delta.h)
  bool time = false;                     ///< it says how long it took
  bool regions = false;                  ///< it takes strokes of brushes, and no polygons of cells
  std::int32_t lattice = kUnitsPerCell;  ///< coordinates are multiples of 1/lattice cell
  std::int32_t cells = kMaxCell;         ///< cells lie within ±cells
  std::int32_t round = 0;                ///< lattice units that its outline of regions may be off the exact edges
  friend bool operator==(const Capabilities&, const Capabilities&) = default;

  /// What the laws ask for: everything.
  static constexpr Capabilities all() {
    return {.ghosts = true, .blocks = true, .several = true, .slants = true, .preserve = true, .refuses = true};
  }

  /// Whether the whole outline is compared, as it is.
  bool putsOutAll() const { return ghosts && blocks && !merged; }
};

/// Reads the words of the protocol: "ghosts blocks lattice=8". The error says which word is wrong.
tl::expected<Capabilities, std::string> parseCapabilities(std::string_view words);

/// The same words.
std::string print(const Capabilities& can);

/// Which worlds the harness makes for these: "several polygons a cell, any edges, …".
std::string worldsInWords(const Capabilities& can);

/// What is compared: "segments, ghosts and blocks".
std::string comparedInWords(const Capabilities& can);

/// Why an engine can not have this polygon, as a phrase; empty if it can. Whether the polygon is good is not asked.
std::string whyNot(const ScenePolygon& polygon, const Capabilities& can);

/// The same of a stroke, for an engine that takes them.
std::string whyNot(const BrushEdit& stroke, const Capabilities& can);

}  // namespace lgs::oracle
