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

void IslandView::nameAll(const World& world, const Loops& loops) {
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
  for (const Old& old : olds_) ofLoop_[old.facts.outer.id.value] = {};
  for (const Kin::Node kin : kins) {
    const auto ofKin = [kin](auto& sorted, auto member) {
      return std::span(std::ranges::lower_bound(sorted, kin, {}, member),
                       std::ranges::upper_bound(sorted, kin, {}, member));
    };
    const std::span<Old> olds = ofKin(olds_, &Old::kin);
    const std::span<New> news = ofKin(news_, &New::kin);
    nameKin(olds, news);
    if (isAnchor_) countAnchors(world, loops, olds, news);
    tellKin(loops, olds, news);
  }
  for (auto* ids : {&changes_.came, &changes_.went, &changes_.changed}) detail::sort(*ids);
  for (auto* pairs : {&changes_.cutOff, &changes_.joined}) detail::sort(*pairs);
  detail::sort(changes_.before, [](const IslandFacts& a, const IslandFacts& b) { return a.id < b.id; });
}

/// The largest inherits from the largest. The others keep what their loops had.
void IslandView::nameKin(std::span<const Old> olds, std::span<New> news) {
  for (New& now : news) {
    if (&now == news.data()) {
      now.id = olds.empty() ? newId() : olds.front().facts.id;
      continue;
    }
    const auto own = std::ranges::find(olds, now.outer.id, [](const Old& old) { return old.facts.outer.id; });
    const bool keeps = own != olds.end() && own->facts.id != news.front().id;
    now.id = keeps ? own->facts.id : newId();
  }
}

/// The kin keeps its anchors, but for those that came and went. All but the largest are counted.
void IslandView::countAnchors(const World& world, const Loops& loops, std::span<const Old> olds, std::span<New> news) {
  if (news.empty()) return;
  std::uint64_t sum = 0;
  for (const Old& old : olds) sum += old.facts.anchors;
  for (const KinShift& shift : kinShifts_)
    if (shift.kin == news.front().kin) sum += static_cast<std::uint64_t>(shift.by);
  for (New& now : news.subspan(1)) {
    now.anchors = anchorsIn(world, loops, now.outer.id);
    sum -= now.anchors;
  }
  news.front().anchors = sum;
}

void IslandView::tellKin(const Loops& loops, std::span<const Old> olds, std::span<const New> news) {
  const auto idOf = [](const Old& old) { return old.facts.id; };
  for (const Old& old : olds) {
    if (std::ranges::count(news, old.facts.id, &New::id) > 0) continue;
    changes_.before.push_back(old.facts);
    ended_.push_back(old.facts.id);
    islands_[old.facts.id.value] = {};
    if (news.empty())
      changes_.went.push_back(old.facts.id);
    else
      changes_.joined.push_back({old.facts.id, news.front().id});
  }
  for (const New& now : news) {
    set(now.id, now.outer.id, now.anchors);
    const auto old = std::ranges::find(olds, now.id, idOf);
    if (olds.empty()) {
      changes_.came.push_back(now.id);
    } else if (old == olds.end()) {
      changes_.cutOff.push_back({news.front().id, now.id});
    } else if (old->facts.outer.id != now.outer.id || old->facts.anchors != now.anchors ||
               std::ranges::binary_search(loops.changes().changed, now.outer.id)) {
      changes_.changed.push_back(now.id);
      changes_.before.push_back(old->facts);
    }
  }
}

}  // namespace lgs::detail
