// The colours. People with any kind of colour vision can tell them apart, and those that fill areas are calm.
#pragma once

#include "oracle/reference/scene.h"

#include <map>
#include <string_view>

namespace lgs::oracle::drawing {

inline constexpr std::string_view kPage = "#fbfaf6";
inline constexpr std::string_view kPaper = "#ffffff";
inline constexpr std::string_view kInk = "#1f2a3d";
inline constexpr std::string_view kMuted = "#667085";
inline constexpr std::string_view kGrid = "#98a2b3";
inline constexpr std::string_view kLink = "#b5267b";
inline constexpr std::string_view kNotMutual = "2 2";  // the dashes of a link that only one of its segments has
inline constexpr std::string_view kEdited = "#b7791f";
inline constexpr std::string_view kExpected = "#0b5fb0";
inline constexpr std::string_view kActual = "#d1490c";

/// A fill for each block of a scene. Up to nine blocks get different ones. A block keeps its colour from picture to
/// picture, unless another block of the scene has that colour too.
std::map<Block, std::string_view> fillsOf(const Scene& scene);

}  // namespace lgs::oracle::drawing
