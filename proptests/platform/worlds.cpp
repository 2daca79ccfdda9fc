// Parts that edit worlds: by all calls, under relations, on an executor, back and forth.
#include "editor.h"
#include "parts.h"

#include <array>
#include <cstddef>

namespace platform {
namespace {

/// Commits now and then, and reads everything more seldom.
void play(Editor& editor, Random& choices, int rounds) {
  for (int k = 0; k < rounds; ++k) {
    editor.edits(choices.between(1, 8));
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
void loadDamaged(Hash& hash, Random& choices, std::vector<std::byte> bytes) {
  if (choices.chance(50)) {
    bytes[choices.below(static_cast<std::uint32_t>(bytes.size()))] ^= std::byte{1} << choices.below(8);
  } else {
    bytes.resize(choices.below(static_cast<std::uint32_t>(bytes.size())));
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
    Random choices(seed + 1'000);
    Editor editor(hash, seed);
    play(editor, choices, 1'500);
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
    Random choices(++seed + 1'000);
    Editor editor(hash, seed, lgs::World(relation));
    play(editor, choices, 900);
  }
}

void executor(Hash& hash) {
  const lgs::Executor lastFirst = [](std::size_t count, const std::function<void(std::size_t)>& job) {
    while (count != 0) job(--count);
  };
  oracle::Habits overSixChunks = Editor::kHabits;
  overSixChunks.width = 48;
  overSixChunks.height = 12;
  for (std::uint64_t seed = 200; seed < 212; ++seed) {
    Editor editor(hash, seed, lgs::World(), overSixChunks, {-8, -8});
    editor.edits(500);
    put(hash, oracle::copyOf(editor.world().commit(lastFirst)));
    hash.step();
    editor.readAll();
    editor.edits(5);
    editor.commit();
  }
}

void rollBack(Hash& hash) {
  Random choices(1'300);
  Editor editor(hash, 300, lgs::World(), withMarks(Editor::kHabits));
  for (int k = 0; k < 2'000; ++k) {
    editor.edits(choices.between(0, 4));
    if (choices.chance(50)) editor.commit();
    hash.step();
    if (k % 200 == 199) editor.readAll();
  }
}

void saves(Hash& hash) {
  Random choices(1'400);
  Editor editor(hash, 400);
  lgs::World& world = editor.world();
  for (int k = 0; k < 250; ++k) {
    editor.edits(choices.between(1, 30));
    editor.commit();
    const std::vector<std::byte> bytes = saved(world);
    putBytes(hash, bytes);
    loadDamaged(hash, choices, bytes);
    auto loaded = lgs::World::load(bytes);
    hash.byte(loaded && lgs::samePolygons(world, *loaded) ? 1 : 0);
    if (loaded && choices.chance(50)) world = std::move(*loaded);
    hash.step();
  }
  editor.readAll();
}

void unloading(Hash& hash) {
  Random choices(1'500);
  Editor editor(hash, 500);
  lgs::World& world = editor.world();
  for (int k = 0; k < 250; ++k) {
    editor.edits(choices.between(1, 30));
    std::vector<std::vector<std::byte>> gone;
    const std::int32_t i = choices.between(-2, 0), j = choices.between(-2, 0);  // some of the four chunks
    const lgs::CellRect away{{i * 32, j * 32}, {31, 31}};
    putResult(hash, world.unload(away, [&](lgs::Cell corner, std::span<const std::byte> bytes) {
      put(hash, corner);
      putBytes(hash, bytes);
      gone.emplace_back(bytes.begin(), bytes.end());
    }));
    if (choices.chance(50)) editor.commit();
    editor.edits(choices.between(0, 8));
    editor.commit();
    if (k % 50 == 49) editor.readAll();
    while (!gone.empty()) {
      const auto corner = world.reload(gone.back());
      put(hash, corner ? *corner : lgs::Cell{});
      gone.pop_back();
      if (choices.chance(30)) editor.commit();
    }
    editor.commit();
  }
  editor.readAll();
}

}  // namespace platform
