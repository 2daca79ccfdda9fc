// Which island of now is which of before, kin by kin; and how many anchors each has.
#include "island_view.h"

#include "geometry/sort.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <tuple>

namespace lgs::detail {
namespace {

/// The larger one first.
bool isLarger(const LoopFacts& a, const LoopFacts& b) {
  if (a.doubleArea != b.doubleArea) return a.doubleArea > b.doubleArea;
  return std::tie(a.west, a.id) < std::tie(b.west, b.id);
}

}  // namespace

void IslandView::nameAll(const World& world, const Loops& loops, Kin::Node beyond) {
  detail::sort(olds_, [](const Old& a, const Old& b) {
    return a.kin != b.kin ? a.kin < b.kin : isLarger(a.facts.outer, b.facts.outer);
  });
  detail::sort(news_,
               [](const New& a, const New& b) { return a.kin != b.kin ? a.kin < b.kin : isLarger(a.outer, b.outer); });
  std::vector<Kin::Node> kins;
  for (const Old& old : olds_) kins.push_back(old.kin);
  for (const New& now : news_) kins.push_back(now.kin);
  detail::sort(kins);
  kins.erase(std::unique(kins.begin(), kins.end()), kins.end());
  for (std::size_t k = 0; k < olds_.size(); ++k) islands_[olds_[k].facts.id.value].old = static_cast<std::uint32_t>(k);
  const auto ofKin = [](auto& sorted, Kin::Node kin, auto member) {
    return std::span(std::ranges::lower_bound(sorted, kin, {}, member),
                     std::ranges::upper_bound(sorted, kin, {}, member));
  };
  for (const KinShift& shift : kinShifts_)
    if (const std::span<New> news = ofKin(news_, shift.kin, &New::kin); !news.empty())
      news.front().anchors += static_cast<std::uint64_t>(shift.by);
  for (const Kin::Node kin : kins) {
    const std::span<Old> olds = ofKin(olds_, kin, &Old::kin);
    const std::span<New> news = ofKin(news_, kin, &New::kin);
    const bool isBeyond = kin == beyond;
    nameKin(olds, news, isBeyond);
    if (isAnchor_) countAnchors(world, loops, olds, news, isBeyond);
    tellKin(loops, olds, news, isBeyond);
  }
  for (auto* ids : {&changes_.added, &changes_.removed, &changes_.changed}) detail::sort(*ids);
  for (auto* pairs : {&changes_.cutOff, &changes_.joined}) detail::sort(*pairs);
  detail::sort(changes_.before, [](const IslandFacts& a, const IslandFacts& b) { return a.id < b.id; });
}

/// The island of before that had this loop; null, if none did. Loops keep their ids within one kin.
const IslandView::Old* IslandView::oldOf(LoopId outer) const {
  return of(outer) ? &olds_[islands_[of(outer).value].old] : nullptr;
}

/// The largest inherits from the largest; what is beyond is larger than all. The others keep what their loops had.
void IslandView::nameKin(std::span<const Old> olds, std::span<New> news, bool isBeyond) {
  for (New& now : news) {
    if (&now == news.data() && !isBeyond)
      now.old = olds.empty() ? nullptr : olds.data();
    else if (const Old* own = oldOf(now.outer.id); isBeyond || own != news.front().old)
      now.old = own;
    now.id = now.old ? now.old->facts.id : newId();
  }
}

/// The kin keeps its anchors, but for those that came and went: of these the largest has the sum so far. All but the
/// largest are counted. How many there are beyond the edge of memory is not known, so what comes from there is counted
/// as well.
void IslandView::countAnchors(const World& world, const Loops& loops, std::span<const Old> olds, std::span<New> news,
                              bool isBeyond) {
  if (news.empty()) return;
  if (isBeyond || (olds.empty() && !away_.empty())) {
    for (New& now : news) now.anchors = anchorsIn(world, loops, now.outer.id);
    return;
  }
  std::uint64_t sum = news.front().anchors;
  for (const Old& old : olds) sum += old.facts.anchors;
  for (New& now : news.subspan(1)) {
    now.anchors = anchorsIn(world, loops, now.outer.id);
    sum -= now.anchors;
  }
  news.front().anchors = sum;
}

void IslandView::tellKin(const Loops& loops, std::span<const Old> olds, std::span<const New> news, bool isBeyond) {
  for (const Old& old : olds) {
    islands_[old.facts.id.value] = {};
    ofLoop_[old.facts.outer.id.value] = {};
  }
  for (const New& now : news) set(now.id, now.outer.id, now.anchors);
  for (const Old& old : olds) {
    if (isIsland(old.facts.id)) continue;
    changes_.before.push_back(old.facts);
    ended_.push_back(old.facts.id);
    if (isBeyond || !news.empty())
      changes_.joined.push_back({old.facts.id, isBeyond ? kBeyond : news.front().id});
    else
      changes_.removed.push_back(old.facts.id);
  }
  for (const New& now : news) {
    if (olds.empty() && !isBeyond) {
      changes_.added.push_back(now.id);
    } else if (!now.old) {
      changes_.cutOff.push_back({isBeyond ? kBeyond : news.front().id, now.id});
    } else if (now.old->facts.outer.id != now.outer.id || now.old->facts.anchors != now.anchors ||
               std::ranges::binary_search(loops.changes().changed, now.outer.id)) {
      changes_.changed.push_back(now.id);
      changes_.before.push_back(now.old->facts);
    }
  }
}

}  // namespace lgs::detail
