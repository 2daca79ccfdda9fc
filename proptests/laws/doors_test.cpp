// Edits come through many doors, and mean the same through each: a polygon by its vertices, in lattice units or reals;
// a shape of one or several polygons; a rectangle of cells.
#include "proptests/support/law.h"
#include "site.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

// storyOf() holds each edit against the model, and the outline after each commit against the naive reference.
LGS_LAW(Doors, LeadToTheWorldOfTheModel, 500, (const SiteEdits& edits, const Setting& setting)) {
  storyOf(edits, setting);
}

LGS_LAW(Fill, IsTheSameAsSingleEdits, 300, (const SiteEdits& edits, const Setting& setting)) {
  failUnless(storyOf(edits, setting).outlines == storyOf(edits, setting, Manner::cellByCell).outlines,
             "the outline is another one than if rectangles are filled and cleared cell by cell");
}

}  // namespace
}  // namespace lgs::test
