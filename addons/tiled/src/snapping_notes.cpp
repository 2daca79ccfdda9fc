#include "snapping_notes.h"

#include <cmath>
#include <string>
#include <utility>

namespace lgs::tiled {

void noteSnapping(const CollisionObject& object, const Snapped& snapped, std::vector<Note>& notes) {
  using Object = CollisionObject::Kind;
  const auto note = [&](NoteKind kind, double amount, std::string text) {
    notes.push_back({kind, object.id, amount, 0, {}, std::move(text)});
  };
  if (object.kind == Object::ellipse || object.kind == Object::capsule) {
    note(NoteKind::approximated, 0,
         std::string(object.kind == Object::ellipse ? "an ellipse" : "a capsule") + " became a polygon of " +
             std::to_string(kCurveVertices) + " vertices");
  }
  if (object.thickness > 0) {
    note(NoteKind::approximated, 0, "a one-way polyline became a polygon, " + pixels(object.thickness) + " thick");
  }
  if (object.hidden) note(NoteKind::hidden, 0, "is hidden, and counts all the same; --visible leaves it out");
  if (snapped.takenBack) {
    note(NoteKind::takenBack, snapped.furthest,
         "stays as drawn: snapping by up to " + pixels(snapped.furthest) +
             " would press sides of it together. A smaller --tolerance may snap the rest");
  } else if (snapped.moved > 0) {
    note(NoteKind::snapped, snapped.furthest,
         std::to_string(snapped.moved) + (snapped.moved == 1 ? " coordinate" : " coordinates") +
             " put on the grid, by up to " + pixels(snapped.furthest));
  }
  if (snapped.nearMiss > 0) {
    note(NoteKind::nearMiss, snapped.nearMiss,
         "a vertex misses a corner by " + pixels(snapped.nearMiss) + ": a tolerance of " +
             pixels(std::ceil(snapped.nearMiss * 10) / 10) + " would join it");
  }
}

std::string pixels(double value) {
  const auto hundredths = std::llround(std::fmin(value, 1e9) * 100);
  std::string result = std::to_string(hundredths / 100);
  if (const auto rest = hundredths % 100; rest != 0) {
    result += rest < 10 ? ".0" : ".";
    result += std::to_string(rest % 10 == 0 ? rest / 10 : rest);
  }
  return result + " px";
}

}  // namespace lgs::tiled
