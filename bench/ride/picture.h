// Rides as a picture: the ground, the path of each, a ring where one was kicked, and the speeds below.
#pragma once

#include "bench/ride/ride.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"

#include <string>
#include <vector>

namespace lgs::oracle {

struct NamedTrack {
  Way way = Way::terrain;
  Track track;
};

/// The first track is drawn last, on top. At most three.
std::string drawRides(const Scene& scene, const Outline& outline, const std::vector<NamedTrack>& tracks,
                      const RideOptions& options, const std::string& title);

}  // namespace lgs::oracle
