// The colours: told apart by people with any kind of colour vision, and calm where they fill areas.
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
inline constexpr std::string_view kNotMutual = "2 2";  // dashes of links that only one side knows
inline constexpr std::string_view kEdited = "#b7791f";
inline constexpr std::string_view kExpected = "#0b5fb0";
inline constexpr std::string_view kActual = "#d1490c";

/// A fill for each block of a scene. Up to nine blocks differ; a block keeps its colour from picture to picture as long
/// as no other wants it too.
std::map<Block, std::string_view> fillsOf(const Scene& scene);

}  // namespace lgs::oracle::drawing
