#pragma once

#include <lgs/box2d/terrain.h>

namespace lgs::box2d {

inline float slop() { return 0.005F * b2GetLengthUnitsPerMeter(); }  // B2_LINEAR_SLOP is public from 3.2 on

inline b2Vec2 toBox2D(Metres m) { return {m.x, m.y}; }

inline Position toBox2D(Place p) {
  using Real = decltype(Position::x);
  return {static_cast<Real>(p.x), static_cast<Real>(p.y)};
}

}  // namespace lgs::box2d
