#include "oracle/generate/generator.h"

#include "oracle/calls/shapes.h"
#include "oracle/generate/editor.h"
#include "oracle/trace/plain_edits.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

namespace lgs::oracle {
namespace {

// Where the grid of a case lies: about the origin, across the borders of chunks, at the ends of the world, anywhere.
std::int32_t randomOrigin(Random& random, std::int32_t size) {
  switch (random.below(6)) {
    case 0:
    case 1:
      return -random.below(size + 1);
    case 2:
      return 32 * (random.below(9) - 4) - random.below(size + 1);
    case 3:
      return kMaxCell - size + 1;
    case 4:
      return -kMaxCell;
    default:
      return random.below(2'000'000) - 1'000'000;
  }
}

// A first column or row from which `size` of them are within ±most; so many must fit.
std::int32_t within(std::int32_t most, std::int32_t size, std::int32_t origin) {
  if (origin >= -most && origin + size - 1 <= most) return origin;
  const std::int64_t places = 2 * std::int64_t{most} + 2 - size;
  return static_cast<std::int32_t>(-most + (std::int64_t{origin} + most) % places + (origin < -most ? places - 1 : 0));
}

std::vector<Cell> grid(Cell origin, std::int32_t width, std::int32_t height) {
  std::vector<Cell> cells;
  for (std::int32_t i = 0; i < width; ++i) {
    for (std::int32_t j = 0; j < height; ++j) cells.push_back({origin.i + i, origin.j + j});
  }
  return cells;
}

// The degenerate shapes that an engine can have; polygon by polygon, if it can have only one in a cell.
std::vector<std::vector<LocalPolygon>> shapesFor(const Capabilities& can) {
  std::vector<std::vector<LocalPolygon>> shapes;
  const auto fits = [&](const LocalPolygon& polygon) { return whyNot({{}, 0, polygon}, can).empty(); };
  for (const NamedShape& shape : degenerateShapes()) {
    if (!std::ranges::all_of(shape.polygons, fits)) continue;
    if (can.several) {
      shapes.push_back(shape.polygons);
    } else {
      for (const LocalPolygon& polygon : shape.polygons) shapes.push_back({polygon});
    }
  }
  return shapes;  // never empty: the full square is fit for all
}

std::vector<std::vector<LocalPolygon>> randomShapes(Random& random, const Capabilities& can) {
  const auto all = shapesFor(can);
  std::vector<std::vector<LocalPolygon>> shapes;
  const int percent = random.chance(50) ? 15 : 60;
  for (const auto& shape : all) {
    if (random.chance(percent)) shapes.push_back(shape);
  }
  if (shapes.empty()) shapes.push_back(random.pick(all));
  return shapes;
}

std::vector<Block> randomBlocks(Random& random) {
  const std::vector<Block> all{1, 2, 3, 0, 0xffff'ffff};
  return {all.begin(), all.begin() + 1 + random.below(5)};
}

// None, or a partition of the blocks into materials, or any pairs at all.
PreservePairs randomPreserve(Random& random, const std::vector<Block>& blocks) {
  PreservePairs pairs;
  const int kind = random.below(4);
  if (kind < 2) return pairs;
  std::vector<int> material;
  for (std::size_t k = 0; k < blocks.size(); ++k) material.push_back(random.below(3));
  for (std::size_t a = 0; a < blocks.size(); ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      const bool kept = kind == 2 ? material[a] != material[b] : random.chance(30);
      if (kept) pairs.add(blocks[a], blocks[b]);
    }
  }
  return pairs;
}

// One that has its habits, and has edited nothing yet.
Editor editorOf(const GeneratorOptions& options, Random& random) {
  EditHabits habits;
  habits.can = options.can;
  habits.shapes = randomShapes(random, options.can);
  habits.blocks = randomBlocks(random);
  // A commit that finds many edited cells in one row goes another way than one that finds a few, and buried cells
  // another than those that show: some cases are long and low, commit seldom, and are mostly filled.
  const bool isLow = random.chance(8);
  const std::int64_t most = 2 * std::int64_t{options.can.cells} + 1;
  const auto width = static_cast<std::int32_t>(std::min<std::int64_t>(isLow ? 4 * options.width : options.width, most));
  const auto height =
      static_cast<std::int32_t>(std::min<std::int64_t>(isLow ? std::min(options.height, 3) : options.height, most));
  Cell origin{randomOrigin(random, width), randomOrigin(random, height)};
  // Some cases do little else than move in time, or in memory, or are refused.
  enum { time, memory, memoryToo, refusal };
  const int mostly = options.isOfCalls ? random.below(10) : -1;
  const bool isOfMemory =
      !options.inMemory && (mostly == memory || mostly == memoryToo || (options.streams && random.chance(70)));
  const bool isAtCorner = options.isOfCalls && (isOfMemory || random.chance(40));
  if (isAtCorner) {  // of four chunks, which may leave memory; or where the last one is a column or row wide
    origin.i = random.chance(12) ? kMaxCell - width + 1 : 32 * (random.below(5) - 2) - width / 2;
    origin.j = random.chance(12) ? kMaxCell - height + 1 : 32 * (random.below(5) - 2) - height / 2;
  }
  origin = {within(options.can.cells, width, origin.i), within(options.can.cells, height, origin.j)};
  habits.cells = grid(origin, width, height);
  if (isAtCorner && random.chance(45)) {  // all of it at the corner itself
    const Cell corner{origin.i + width / 2, origin.j + height / 2};
    habits.cells = grid({corner.i - 1, corner.j - 1}, 2, 2);
  }
  habits.wander = random.chance(20);
  habits.place = 4 + random.below(10);
  habits.fill = random.below(3);
  habits.lean = random.chance(50) ? random.below(10) : 0;
  habits.scatter = random.chance(50) ? random.below(10) : 0;
  habits.remove = 1 + random.below(6);
  habits.clear = random.below(3);
  habits.replace = random.below(3);
  habits.refused = random.chance(40) ? 1 + random.below(3) : 0;
  if (options.bad) habits.refused = 100;
  if (!options.can.refuses) habits.refused = 0;
  habits.commitPercent = random.chance(50) ? 100 : 10 + random.below(60);
  if (options.isOfCalls) {
    habits.forms = random.chance(85);
    habits.any = random.chance(40) ? 2 + random.below(8) : 0;
    habits.hostilePercent = habits.any > 0 && random.chance(40) ? 10 : 0;
    habits.travel = random.chance(45) ? 1 + random.below(5) : 0;
    habits.memory = random.chance(isAtCorner ? 60 : 20) && !options.inMemory ? 1 + random.below(5) : 0;
    habits.stroke = !options.brushes ? 0 : random.chance(50) ? 10 : 50;
    if (mostly == time || isOfMemory) habits.travel = isOfMemory ? 10 : 40;
    if (isOfMemory) habits.memory = 25;
    if (mostly == refusal) habits.refused = 12;
    habits.carry = random.chance(30) ? 1 + random.below(4) : 0;
  }
  habits.strokes.blocks = habits.blocks;
  habits.strokes.can = options.can;
  if ((options.brushes || options.can.regions) && random.chance(50)) {
    const Cell middle{origin.i + width / 2, origin.j + height / 2};
    habits.strokes.tight = tightAt(toWorld(middle, {0, 0}), random);
    habits.cells = grid({middle.i - 1, middle.j - 1}, 3, 3);
    std::erase_if(habits.cells, [](Cell cell) { return !inRange(cell); });
  }
  if (isLow) {
    habits.commitPercent = 3;
    habits.shapes.insert(habits.shapes.end(), 4 * habits.shapes.size(), degenerateShapes().front().polygons);
    habits.place = 30;
  }
  if (options.can.regions) {
    for (int EditHabits::*const weight :
         {&EditHabits::place, &EditHabits::fill, &EditHabits::lean, &EditHabits::scatter, &EditHabits::remove,
          &EditHabits::clear, &EditHabits::replace})
      habits.*weight = 0;
    habits.stroke = 1;
  }
  Trace start;
  start.preserve = randomPreserve(random, habits.blocks);
  start.mayRefuse = options.isOfCalls;
  if (!options.can.preserve || options.can.regions) start.preserve = {};
  if (options.can.regions && options.can.blocks)  // the outline of each block is compared
    for (const Block a : habits.blocks)
      for (const Block b : habits.blocks)
        if (a != b) start.preserve.add(a, b);
  if (options.isOfCalls && random.chance(40)) {
    Call follow = Call::of(Call::Kind::follow);
    follow.nth = 1;
    start.calls.push_back(std::move(follow));
  }
  return Editor(std::move(start), std::move(habits), Random(random.next()));
}

}  // namespace

Trace randomCase(const GeneratorOptions& options, std::uint64_t seed) {
  Random random(seed);
  Editor editor = editorOf(options, random);
  editor.run(options.edits);
  return editor.takeTrace();
}

Trace caseOf(std::span<const std::uint8_t> bytes, const GeneratorOptions& options) {
  const auto next = [&bytes] {
    const auto record = bytes.first(std::min(bytes.size(), kRecord));
    bytes = bytes.subspan(record.size());
    return record;
  };
  std::uint64_t seed = 0;
  for (const std::uint8_t byte : next()) seed = seed * 257 + byte;
  Random habits(seed);
  Editor editor = editorOf(options, habits);
  while (!bytes.empty() && editor.edits() < options.edits) editor.operate(Random::of(next()));
  return editor.takeTrace();
}

Crowd crowdOf(std::uint64_t number, const GeneratorOptions& options) {
  if (!options.crowds) return Crowd::none;
  if (options.brushes && number % 256 == 5) return Crowd::strokes;
  if (number % 256 == 7) return Crowd::polygons;
  return number % 1024 == 23 ? Crowd::vertices : Crowd::none;  // they take longest
}

std::size_t editsOf(std::uint64_t number, const GeneratorOptions& options) {
  const bool isCrowded = crowdOf(number, options) != Crowd::none;
  return isCrowded ? std::max(options.edits, kCrowdedEdits) : options.edits;
}

Trace caseOf(std::uint64_t number, const GeneratorOptions& options, std::uint64_t seed) {
  const Crowd crowd = crowdOf(number, options);
  return crowd == Crowd::none ? randomCase(options, seed) : crowdedCase(crowd, options.edits, seed);
}

namespace {

// Of an engine that takes strokes alone.
std::string whyNotByStrokes(const Trace& trace, const Capabilities& can) {
  for (const auto& [a, b] : trace.preserve.pairs())
    if (a == b) return fmt::format("it preserves block {} against itself, and a region has no seams", a);
  std::set<Block> blocks;
  for (std::size_t k = 0; k < trace.calls.size(); ++k) {
    const Call& call = trace.calls[k];
    if (call.kind == Call::Kind::commit) continue;
    const bool isStroke = call.kind == Call::Kind::brush;
    std::string why = isStroke ? whyNot(call.brush, can) : "an engine with 'regions' takes strokes alone";
    if (why.empty() && isOutOfReach(call.brush)) why = "it is beyond the last cell, or too wide or high";
    if (isStroke && can.blocks && call.brush.deed != BrushEdit::Deed::carve)
      for (const Block other : blocks)
        if (other != call.brush.block && !trace.preserve(other, call.brush.block))
          why = fmt::format("blocks {} and {} are not preserved, so that their outlines are not whole", other,
                            call.brush.block);
    if (!why.empty()) return fmt::format("edit {}: {}", k + 1, why);
    if (call.brush.deed != BrushEdit::Deed::carve) blocks.insert(call.brush.block);
  }
  return "";
}

}  // namespace

std::string whyNot(const Trace& trace, const Capabilities& can) {
  if (!can.preserve && !trace.preserve.empty()) return "it has a preserve relation";
  if (can.regions) return whyNotByStrokes(trace, can);
  Model model;
  for (std::size_t k = 0; k < trace.calls.size(); ++k) {
    const Call& call = trace.calls[k];
    const bool isGood = model.judge(call).accepted;
    const bool isAdd = call.kind == Call::Kind::add;
    std::string why = isPlain(call) ? "" : "it is no plain edit";
    if (isAdd && why.empty()) why = whyNot(call.polygon(), can);
    if (why.empty() && !isGood && !can.refuses) why = "it must be refused";
    if (why.empty() && isGood && isAdd && !can.several && !model.standing().in(call.comes[0].cell).empty())
      why = "its cell has a polygon already";
    if (!why.empty()) return fmt::format("edit {}, '{}': {}", k + 1, call.name(), why);
    model.play(call);
  }
  return "";
}

Trace digIn(Trace start, std::size_t edits, std::uint64_t seed, const Capabilities& can, bool isOfCalls) {
  start.calls.push_back(Call::commit());
  Model world;
  for (const Call& call : start.calls) world.play(call);

  EditHabits habits;
  habits.can = can;
  std::set<std::vector<LocalPolygon>> contents;
  std::set<Block> blocks;
  std::set<Cell> cells;
  for (const auto& [cell, placed] : world.standing().cells()) {
    std::vector<LocalPolygon> polygons;
    for (const Standing::Placed& p : placed) {
      polygons.push_back(p.vertices);
      blocks.insert(p.block);
    }
    contents.insert(std::move(polygons));
    for (const Cell& near : grid({cell.i - 1, cell.j - 1}, 3, 3)) {
      const auto isWithin = [&](std::int32_t index) { return -can.cells <= index && index <= can.cells; };
      if (inRange(near) && isWithin(near.i) && isWithin(near.j)) cells.insert(near);
    }
  }
  habits.shapes.assign(contents.begin(), contents.end());
  for (const auto& shape : shapesFor(can)) habits.shapes.push_back(shape);
  habits.blocks.assign(blocks.begin(), blocks.end());
  if (blocks.empty()) habits.blocks = {1};
  habits.cells.assign(cells.begin(), cells.end());
  if (cells.empty()) habits.cells = grid({0, 0}, std::min(4, can.cells + 1), std::min(4, can.cells + 1));
  habits.wander = true;
  habits.turnShapes = false;
  habits.place = 2;
  habits.fill = 1;
  habits.lean = 1;
  habits.restore = 5;
  habits.remove = 4;
  habits.clear = 4;
  habits.replace = 1;
  habits.commitPercent = 60;
  habits.forms = start.mayRefuse = isOfCalls;
  Editor editor(std::move(start), std::move(habits), Random(seed));
  editor.run(edits);
  return editor.takeTrace();
}

}  // namespace lgs::oracle
