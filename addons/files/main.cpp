// Looks at a world in a file.
//
//   lgs_world FILE                lists its chunks: place, hash, bytes
//   lgs_world FILE --check        reads each and compares it with its hash; exit status 1 if something is damaged
//   lgs_world FILE --svg PICTURE  draws it
//   lgs_world FILE --repair       removes the chunks that are damaged
#include "world_file.h"

#include <lgs/debug.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace {

int complain(const std::string& why) {
  std::fprintf(stderr, "lgs_world: %s\n", why.c_str());
  return 2;
}

void print(const world_file::Stored& stored) {
  std::printf("%d %d %016llx %zu bytes%s\n", stored.corner.i, stored.corner.j,
              static_cast<unsigned long long>(stored.hash), stored.bytes, stored.isGood ? "" : " damaged");
}

int list(const world_file::WorldFile& file) {
  const auto chunks = file.chunks();
  if (!chunks) return complain(chunks.error());
  for (const world_file::Stored& stored : *chunks) print(stored);
  return 0;
}

int check(const world_file::WorldFile& file) {
  std::string complaint;
  bool isGood = true;
  for (const world_file::Stored& stored : file.check(complaint)) {
    if (!stored.isGood) print(stored);
    isGood = isGood && stored.isGood;
  }
  if (!complaint.empty()) std::printf("SQLite: %s\n", complaint.c_str());
  if (isGood && complaint.empty()) std::printf("all is well\n");
  return isGood && complaint.empty() ? 0 : 1;
}

int draw(const world_file::WorldFile& file, const char* picture) {
  lgs::World world;
  if (const auto done = file.load(world, {{-lgs::kMaxCell, -lgs::kMaxCell}, {lgs::kMaxCell, lgs::kMaxCell}}); !done)
    return complain(done.error());
  world.commit();
  std::ofstream out(picture);
  if (!(out << lgs::writeSvg(world)).flush()) return complain(std::string("cannot write ") + picture);
  return 0;
}

int run(int count, char** values) {
  const std::string_view what = count > 2 ? values[2] : "";
  const bool isDrawn = what == "--svg" && count == 4;
  if (count < 2 || count > 4 || (count > 2 && !isDrawn && (count == 4 || (what != "--check" && what != "--repair"))))
    return complain("usage: lgs_world FILE [--check | --svg PICTURE | --repair]");
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(values[1], error);
  if (error) return complain(std::string("there is no file ") + values[1]);
  if (size == 0) return complain(std::string(values[1]) + " is empty");  // open() would make a world of it
  if (isDrawn && std::filesystem::equivalent(values[1], values[3], error)) return complain("that is the world itself");
  auto file = world_file::WorldFile::open(values[1]);
  if (!file) return complain(file.error());
  if (isDrawn) return draw(*file, values[3]);
  if (what == "--check") return check(*file);
  if (what == "--repair") {
    const auto removed = file->repair();
    if (!removed) return complain(removed.error());
    std::printf("%zu chunks were damaged, and are gone\n", *removed);
    return 0;
  }
  return list(*file);
}

}  // namespace

int main(int count, char** values) {
  const int status = run(count, values);
  return std::fflush(stdout) == 0 && !std::ferror(stdout) ? status : complain("cannot write");
}
