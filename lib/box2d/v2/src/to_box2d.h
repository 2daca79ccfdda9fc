#pragma once

#include <box2d/box2d.h>
#include <lgs/box2d/frame.h>

namespace lgs::box2d {

inline b2Vec2 toBox2D(Metres m) { return {m.x, m.y}; }
inline b2Vec2 toBox2D(Place p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

}  // namespace lgs::box2d
