#include "oracle/reference/scene.h"

#include <algorithm>
#include <map>

namespace lgs::oracle {

void PreservePairs::add(Block a, Block b) { pairs_.insert(std::minmax(a, b)); }

bool PreservePairs::operator()(Block a, Block b) const { return pairs_.contains(std::minmax(a, b)); }

std::uint32_t Materials::of(Block block) const {
  return std::lower_bound(ofBlocks.begin(), ofBlocks.end(), std::pair<Block, std::uint32_t>(block, 0))->second;
}

std::optional<Materials> materials(const Scene& scene) {
  // Each block of the scene, with its rivals: the other blocks of the scene that it is preserved against.
  std::map<Block, std::vector<Block>> rivalsOf;
  for (const ScenePolygon& polygon : scene.polygons) rivalsOf[polygon.block];
  for (const auto& [a, b] : scene.preserve.pairs()) {
    if (!rivalsOf.contains(a) || !rivalsOf.contains(b)) continue;
    if (a == b) return std::nullopt;  // not even reflexive
    rivalsOf[a].push_back(b);
    rivalsOf[b].push_back(a);
  }
  for (auto& entry : rivalsOf) std::sort(entry.second.begin(), entry.second.end());

  // Blocks of one material have the same rivals, so each group of blocks with equal lists is a candidate. It is a
  // material if its rivals are all the blocks outside the group. (No rival is inside: a block is never its own rival.)
  Materials result;
  std::map<std::vector<Block>, std::uint32_t> numberOf;
  std::vector<std::size_t> members;
  for (const auto& [block, rivals] : rivalsOf) {
    const auto [entry, isNew] = numberOf.try_emplace(rivals, result.count);
    if (isNew) {
      ++result.count;
      members.push_back(0);
    }
    ++members[entry->second];
    result.ofBlocks.emplace_back(block, entry->second);
  }
  for (const auto& [rivals, number] : numberOf) {
    if (rivals.size() + members[number] != rivalsOf.size()) return std::nullopt;
  }
  return result;
}

}  // namespace lgs::oracle
