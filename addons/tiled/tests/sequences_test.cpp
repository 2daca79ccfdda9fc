// The importer in random sequences: what it makes of hostile maps goes into worlds that are edited at random, and the
// model says what must come of it. Where the ground is clear, all of it must be accepted.
#include "hostile_maps.h"

#include "oracle/calls/draw.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/call_text.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"
#include "proptests/support/arbitrary.h"
#include "proptests/support/law.h"
#include "proptests/support/played.h"

#include <lgs/tiled/import.h>

#include <gtest/gtest.h>

#include <ostream>

namespace lgs::tiled {
namespace {

using oracle::Call;

constexpr std::size_t kMost = 200;  // polygons of a map: the model compares each with each

/// A call, or a map whose polygons are placed.
struct Step {
  Call call;
  std::optional<HostileMap> map;
  bool clearsFirst = false;  ///< and then places them: both or neither
};

struct Steps {
  std::vector<Step> list;
  static rc::Gen<Steps> arbitrary();
};

void showValue(const Steps& steps, std::ostream& out) {
  for (const Step& step : steps.list)
    out << (step.map ? (step.clearsFirst ? "clears, then imports\n" : "imports\n") + step.map->inWords()
                     : printCall(step.call))
        << '\n';
}

rc::Gen<Steps> Steps::arbitrary() {
  const rc::Gen<std::vector<Step>> lists = [](rc::Random random, int size) {
    oracle::Random choices(random.next());
    std::vector<Step> made;
    for (int k = choices.below(size / 4 + 2); k > 0; --k) {
      Step step;
      if (choices.chance(40))
        step = {{}, HostileMap::draw(choices), choices.chance(60)};
      else
        step.call = drawCall(choices, withLoads(oracle::Habits()));
      made.push_back(std::move(step));
    }
    return rc::shrinkable::shrinkRecur(
        std::move(made), [](const std::vector<Step>& longer) { return rc::shrink::removeChunks(longer); });
  };
  return rc::gen::map(lists, [](std::vector<Step>&& made) { return Steps{std::move(made)}; });
}

/// Of a map's upper left cell: the lattice of maps counts rows upwards from there.
constexpr std::int32_t kRows = 4;

Call placed(const ImportedMap& map) {
  Call call;
  call.kind = Call::Kind::addMany;
  for (const MapPolygon& p : map.placements) {
    oracle::Coming coming{{p.cell.i, p.cell.j + kRows}, {}, p.block, 0};
    coming.shape.push_back(map.shapes[p.shape]);
    call.comes.push_back(std::move(coming));
  }
  return call;
}

/// Clears the cells that a map reaches, and then places it.
Call inPlaceOfAll(const Call& placing) {
  CellRect reach{{0, 0}, {-1, -1}};
  for (const oracle::Coming& coming : placing.comes) {
    if (isEmpty(reach)) reach = {coming.cell, coming.cell};
    reach.min = {std::min(reach.min.i, coming.cell.i), std::min(reach.min.j, coming.cell.j)};
    reach.max = {std::max(reach.max.i, coming.cell.i), std::max(reach.max.j, coming.cell.j)};
  }
  Call clear;
  clear.kind = Call::Kind::clear;
  clear.cells = reach;
  Call group;
  group.kind = Call::Kind::group;
  group.group = {clear, placing};
  group.keeps = Call::Keeps::ifAll;
  return group;
}

LGS_LAW(TiledSequences, WhatIsImportedStandsAmongOtherEdits, 2'000, (const Steps& steps)) {
  oracle::Player player({});
  const auto make = [&](const Call& call) {
    const auto done = player.apply(call);
    if (!done && done.error().isWrong) test::failIf(done.error().text);
  };
  const auto commit = [&] {
    player.commit();
    test::expectSame(naiveOutline(player.scene()), oracle::outlineOf(player.world()));
  };
  for (const Step& step : steps.list) {
    if (!step.map) {
      make(step.call);
      continue;
    }
    const auto map = step.map->import();
    if (!map) {
      test::failUnless(!map.error().what.empty() && !map.error().file.empty(), "a refusal does not say what is wrong");
      continue;
    }
    if (map->placements.size() > kMost) continue;
    const Call placing = placed(*map);
    make(step.clearsFirst ? inPlaceOfAll(placing) : placing);
    const auto isPlaced = [&](const oracle::Told& last) {
      return last.call.kind == Call::Kind::addMany && !last.outcome.refusal;
    };
    test::failUnless(!step.clearsFirst || (!player.past().empty() && isPlaced(*player.past().back())),
                     "what is imported does not fit together");
    commit();
  }
  commit();
}

}  // namespace
}  // namespace lgs::tiled
