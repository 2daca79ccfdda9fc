// Rides as a picture: the ground, the path of each ride with a ring at each kick, and the speeds below.
#pragma once

#include "addons/box2d/ride/ride.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"

#include <string>
#include <vector>

namespace lgs::bench {

struct NamedTrack {
  Way way = Way::terrain;
  Track track;
};

/// Draws up to three tracks. The first one is on top.
std::string drawRides(const oracle::Scene& scene, const oracle::Outline& outline, const std::vector<NamedTrack>& tracks,
                      const RideOptions& options, const std::string& title);

}  // namespace lgs::bench
