#include "proptests/halo/ranks.h"

#include <algorithm>
#include <numeric>

namespace lgs::test {

using regions::Outbox;

std::pair<Key, Row> rowOf(const World& world, SegmentId id) {
  const Segment s = *world.segment(id);
  const auto polygon = world.polygon(s.polygon);
  failUnless(polygon.has_value(), "a segment has no polygon");
  Row row{s.block, s.cell, {polygon->vertices.begin(), polygon->vertices.end()}, {}, {}};
  if (s.predecessor) row.ghost1 = s.ghost1;
  if (s.successor) row.ghost2 = s.ghost2;
  return {{s.start, s.end}, row};
}

Rows rowsOf(const World& world) {
  Rows rows;
  const auto keyOf = [&](SegmentId id) { return id ? std::optional(rowOf(world, id).first) : std::nullopt; };
  for (const SegmentId id : world.segments()) {
    const Segment s = *world.segment(id);
    const auto [key, row] = rowOf(world, id);
    const bool isNew = rows.emplace(key, LinkedRow{row, keyOf(s.predecessor), keyOf(s.successor)}).second;
    failUnless(isNew, "two segments have the same ends");
  }
  return rows;
}

Ranks::Ranks(const regions::Cutting& cutting, const PreserveRelation& preserve)
    : cutting_(cutting), copies_(cutting.size()) {
  for (std::size_t rank = 0; rank < cutting.size(); ++rank)
    regions_.emplace_back(cutting, static_cast<int>(rank), preserve);
}

void Ranks::propose(std::size_t from, const regions::Edit& edit) {
  const auto owner = regions::ownerOf(cutting_, edit.cell);
  failUnless(owner.has_value(), "a cell has no owner");
  Outbox out(size());
  append(out[static_cast<std::size_t>(*owner)], edit);
  send(Kind::proposals, from, out);
}

void Ranks::send(Kind kind, std::size_t from, Outbox& out) {
  for (std::size_t to = 0; to < out.size(); ++to) {
    if (out[to].empty()) continue;
    failUnless(kind == Kind::proposals || from != to, "a rank tells itself what it knows");
    mail_[{from, to}].push_back({kind, std::move(out[to])});
  }
}

void Ranks::deliver(std::size_t from, std::size_t to) {
  const auto box = mail_.find({from, to});
  const Letter letter = std::move(box->second.front());
  box->second.pop_front();
  if (box->second.empty()) mail_.erase(box);
  regions::Region& region = regions_[to];
  if (letter.kind == Kind::names) return region.learn(static_cast<int>(from), letter.message);
  Outbox edits(size());
  for (const regions::Edit& edit : regions::readEdits(letter.message)) {
    if (letter.kind == Kind::edits)
      region.follow(edit);
    else
      refused_ += region.decide(edit, edits) ? 0U : 1U;
  }
  send(Kind::edits, to, edits);
}

void Ranks::commit(std::size_t rank) {
  Outbox names(size());
  copies_[rank].update(regions_[rank].world(), regions_[rank].commit(names), listed_);
  send(Kind::names, rank, names);
}

void Ranks::step(oracle::Random& random) {
  if (mail_.empty() || random.chance(30)) return commit(random.below(size()));
  deliverAny(random);
}

void Ranks::deliverAny(oracle::Random& random) {
  const auto [from, to] = std::next(mail_.begin(), static_cast<std::ptrdiff_t>(random.below(mail_.size())))->first;
  deliver(from, to);
}

void Ranks::deliverAll(oracle::Random& random) {
  while (!mail_.empty()) deliverAny(random);
}

void Ranks::finish(oracle::Random& random) {
  deliverAll(random);
  std::vector<std::size_t> order(size());
  std::iota(order.begin(), order.end(), 0);
  random.shuffle(order);
  for (const std::size_t rank : order) commit(rank);
  deliverAll(random);
}

Rows Ranks::rows() const {
  Rows rows;
  for (std::size_t rank = 0; rank < size(); ++rank) {
    const regions::Region& region = regions_[rank];
    const World& world = region.world();
    const auto keyOf = [&](SegmentId link) -> std::optional<Key> {
      if (!link) return {};
      const regions::Name name = region.nameOf(link);
      failUnless(static_cast<bool>(name.id), "a link has no name");
      const regions::Region& other = regions_[static_cast<std::size_t>(name.rank)];
      failUnless(other.isOwn(name.id), "a link leads to no segment of the rank that it names");
      return rowOf(other.world(), name.id).first;
    };
    std::size_t own = 0;
    for (const SegmentId id : world.segments()) {
      if (!region.isOwn(id)) continue;
      ++own;
      const Segment s = *world.segment(id);
      const auto [key, row] = rowOf(world, id);
      const auto copied = copies_[rank].rows().find(id);
      failUnless(copied != copies_[rank].rows().end() && copied->second == std::pair(key, row),
                 "the lists of changes do not give the own segments");
      const bool isNew = rows.emplace(key, LinkedRow{row, keyOf(s.predecessor), keyOf(s.successor)}).second;
      failUnless(isNew, "two ranks have a segment with the same ends");
    }
    failUnless(own == copies_[rank].rows().size(), "the lists of changes leave segments that are not there");
  }
  for (std::size_t rank = 0; rank < size(); ++rank) {
    const auto isInHalo = [&](const auto& entry) {
      const Cell cell = entry.second.row.cell;
      return regions::needs(cutting_[rank], cell) && !contains(cutting_[rank], cell);
    };
    const auto expected = static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), isInHalo));
    failUnless(regions_[rank].namesOfNeighbours() == expected, "a rank knows other names than those of its halo");
  }
  return rows;
}

}  // namespace lgs::test
