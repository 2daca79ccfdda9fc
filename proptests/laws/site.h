// A site: some cells of a world under edits of all kinds, through every door that World has: shapes of several
// polygons, reals, rectangles, stale handles, and all else that must be refused. RapidCheck makes the edits and makes
// them few; each must come to what a model says.
#pragma once

#include "bad_edits.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/model.h"
#include "proptests/support/worlds.h"

#include <rapidcheck.h>
#include <rapidcheck/state.h>

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <vector>

namespace lgs::test {

/// What must stand where, by the naive rules. Cells are counted from the site's corner.
struct SiteModel {
  oracle::Model standing;
  std::size_t added = 0;    ///< polygons, since the start
  std::size_t removed = 0;  ///< of these

  /// Why a shape must be refused in a cell; nothing if it must be accepted.
  std::optional<ErrorCode> refusal(Cell cell, const std::vector<LocalPolygon>& shape) const;
  void add(Cell cell, const std::vector<LocalPolygon>& shape, Block block);
  void clear(Cell cell);
};

/// Where a site lies, and what is preserved there.
struct Setting {
  Cell corner;
  oracle::PreservePairs preserve;
};
void showValue(const Setting& setting, std::ostream& out);

/// How a site takes edits.
enum class Manner {
  asTheyAre,
  cellByCell,      ///< rectangles as single edits
  withoutRefused,  ///< what must be refused is not tried
};

struct Site {
  Site(Setting where, Manner how);

  Setting setting;
  Manner manner;
  Stage stage;
  std::vector<PolygonHandle> removed;

  /// All that was given and shown so far, refusals apart.
  struct Story {
    std::vector<PolygonHandle> handles;
    std::vector<oracle::Outline> outlines;  ///< after each commit, as the next two
    std::vector<ChangeLists> changes;
    std::vector<Snapshot> snapshots;
    friend bool operator==(const Story&, const Story&) = default;
  };
  Story story;

  Cell at(Cell cell) const { return {setting.corner.i + cell.i, setting.corner.j + cell.j}; }
};

using SiteEdit = rc::state::Command<SiteModel, Site>;

struct SiteEdits {
  rc::state::Commands<SiteEdit> list;
};
void showValue(const SiteEdits& edits, std::ostream& out);

/// Makes the edits on a new site. Fails the running case when an edit does not do what the model says.
Site::Story storyOf(const SiteEdits& edits, const Setting& setting, Manner manner = Manner::asTheyAre);

}  // namespace lgs::test

namespace rc {

template <>
struct Arbitrary<lgs::test::Setting> {
  static Gen<lgs::test::Setting> arbitrary();
};
template <>
struct Arbitrary<lgs::test::SiteEdits> {
  static Gen<lgs::test::SiteEdits> arbitrary();
};

}  // namespace rc
