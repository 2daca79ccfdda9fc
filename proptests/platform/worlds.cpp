// Parts that edit worlds: by all calls, under relations, on an executor, back and forth.
#include "editor.h"
#include "parts.h"

#include <array>
#include <cstddef>

namespace platform {
namespace {

/// Commits now and then, and reads everything more seldom.
void play(Editor& editor, Random& random, int rounds) {
  for (int k = 0; k < rounds; ++k) {
    editor.edits(random.between(1, 8));
    editor.commit();
    if (k % 64 == 63) editor.readAll();
  }
  editor.readAll();
}

std::vector<std::byte> saved(const lgs::World& world) {
  std::vector<std::byte> bytes;
  const auto done =
      world.save([&](std::span<const std::byte> piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); });
  if (!done) bytes.clear();
  return bytes;
}

void putBytes(Hash& hash, std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes) hash.byte(std::to_integer<std::uint8_t>(byte));
  hash.number(bytes.size());
}

/// Damaged in one byte, or cut: the error says where it was noticed.
void loadDamaged(Hash& hash, Random& random, std::vector<std::byte> bytes) {
  if (random.oneIn(2)) {
    bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] ^= std::byte{1} << random.below(8);
  } else {
    bytes.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
  }
  const auto loaded = lgs::World::load(bytes);
  hash.byte(loaded ? 1 : 0);
  if (loaded) return;
  hash.number(static_cast<std::uint64_t>(loaded.error().what));
  hash.number(loaded.error().offset);
  hash.text(lgs::message(loaded.error()));
}

}  // namespace

void edits(Hash& hash) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    lgs::World world;
    Random random(seed);
    Editor editor(world, hash, seed);
    play(editor, random, 1'500);
  }
}

void relations(Hash& hash) {
  const std::array<lgs::PreserveRelation, 3> relations{
      [](lgs::Block, lgs::Block) { return true; },
      [](lgs::Block a, lgs::Block b) { return a % 2 != b % 2; },
      [](lgs::Block a, lgs::Block b) { return (a + b) % 3 == 0; },
  };
  std::uint64_t seed = 100;
  for (const lgs::PreserveRelation& relation : relations) {
    lgs::World world(relation);
    Random random(++seed);
    Editor editor(world, hash, seed);
    play(editor, random, 900);
  }
}

void executor(Hash& hash) {
  const lgs::Executor lastFirst = [](std::size_t count, const std::function<void(std::size_t)>& job) {
    while (count != 0) job(--count);
  };
  for (std::uint64_t seed = 200; seed < 212; ++seed) {
    lgs::World world;
    Editor here(world, hash, seed), there(world, hash, seed + 100, {25, 26});
    here.edits(250);
    there.edits(250);
    put(hash, world.commit(lastFirst));
    hash.step();
    here.readAll();
    there.edits(5);
    there.commit();
  }
}

void goingBack(Hash& hash) {
  lgs::World world;
  Random random(300);
  Editor editor(world, hash, 300);
  std::vector<lgs::Mark> marks;
  for (int k = 0; k < 2'000; ++k) {
    editor.edits(random.between(0, 4));
    if (random.oneIn(2)) editor.commit();
    switch (random.below(8)) {
      case 0:
        if (marks.size() < 20) marks.push_back(world.checkpoint());
        break;
      case 1:
      case 2:
        if (marks.empty()) break;
        if (putResult(hash, world.rollBack(random.of(marks)))) put(hash, world.changesOfRollBack());
        break;
      case 3:
        if (marks.size() < 10) break;
        for (const lgs::Mark mark : marks) putResult(hash, world.forget(mark));
        marks.clear();
        break;
      case 4:
        world = lgs::World(world);
        break;
      default:
        break;
    }
    hash.step();
    if (k % 200 == 199) editor.readAll();
  }
}

void saves(Hash& hash) {
  lgs::World world;
  Random random(400);
  Editor editor(world, hash, 400);
  for (int k = 0; k < 250; ++k) {
    editor.edits(random.between(1, 30));
    editor.commit();
    const std::vector<std::byte> bytes = saved(world);
    putBytes(hash, bytes);
    loadDamaged(hash, random, bytes);
    auto loaded = lgs::World::load(bytes);
    hash.byte(loaded && lgs::samePolygons(world, *loaded) ? 1 : 0);
    if (loaded && random.oneIn(2)) world = std::move(*loaded);
    hash.step();
  }
  editor.readAll();
}

}  // namespace platform
