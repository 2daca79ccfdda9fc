// Makes the edits of a brush in a world.
#pragma once

#include "cell_edit.h"
#include "cells.h"

namespace lgs::brush {

/// Brushes all cells. Called within a transaction: what is made before a refusal is undone by the caller.
Expected<void> apply(World& world, const Coverage& coverage, const Stroke& stroke, BrushResult& result);

}  // namespace lgs::brush
