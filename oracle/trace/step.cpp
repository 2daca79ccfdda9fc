#include "oracle/trace/step.h"

#include <algorithm>
#include <string>

namespace lgs::oracle {

const char* describe(Door door) {
  switch (door) {
    case Door::points:
      return "points";
    case Door::floats:
      return "floats";
    case Door::doubles:
      return "doubles";
    case Door::shape:
      return "shape";
    case Door::handles:
      return "handles";
    case Door::several:
      return "several";
    case Door::fill:
      return "fill";
    case Door::remove:
      return "remove";
    case Door::clear:
      return "clear";
    case Door::replace:
      return "replace";
    case Door::setBlock:
      return "setBlock";
    case Door::brush:
      return "brush";
  }
  return "";
}

std::string_view lettersOf(std::string_view name) {
  return name.substr(name.find_last_of("0123456789") + 1);  // without a digit: all of it
}

std::uint64_t chanceOf(std::string_view name) {
  const std::string_view letters = lettersOf(name);
  if (letters.empty()) return 0;
  std::uint64_t hash = 14'695'981'039'346'656'037U;  // FNV-1a, then the last steps of splitmix64
  for (const char c : letters) hash = (hash ^ static_cast<unsigned char>(c)) * 1'099'511'628'211U;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9U;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebU;
  return hash ^ (hash >> 31);
}

std::string randomLetters(std::uint64_t number) {
  std::string letters;
  for (int k = 0; k < 3; ++k, number /= 26) letters += static_cast<char>('a' + number % 26);
  return letters;
}

Door doorOf(const Edit& edit) {
  if (edit.kind == Edit::Kind::brush) return Door::brush;
  if (edit.kind != Edit::Kind::add) return Door::remove;
  constexpr std::array kDoorsOfOne{Door::points, Door::points, Door::floats,  Door::doubles,
                                   Door::shape,  Door::shape,  Door::handles, Door::fill};
  return kDoorsOfOne[chanceOf(edit.name) % kDoorsOfOne.size()];
}

std::span<const Edit> Step::removes() const {
  const auto isRemove = [](const Edit& edit) { return edit.kind == Edit::Kind::remove; };
  return {edits.begin(), std::find_if_not(edits.begin(), edits.end(), isRemove)};
}

}  // namespace lgs::oracle
