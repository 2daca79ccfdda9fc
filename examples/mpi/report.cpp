#include "report.h"

#include <array>
#include <unordered_map>

namespace mpi {
namespace {

using lgs::Point;
using lgs::Segment;
using lgs::SegmentId;
using regions::Message;
using regions::Name;

constexpr std::size_t kWords = 14;

/// Start, end, block, both ghosts; then the id, and the names of both links.
using Seen = std::array<std::int64_t, 9>;

Seen seen(const Segment& s) {
  const Point before = s.predecessor ? s.ghost1 : Point{};
  const Point after = s.successor ? s.ghost2 : Point{};
  return {s.start.x, s.start.y, s.end.x, s.end.y, s.block, before.x, before.y, after.x, after.y};
}

struct Told {
  SegmentId id;
  Name predecessor;
  Name successor;
};

Told told(const Message& report, std::size_t at) {
  const auto id = [&](std::size_t k) { return SegmentId{static_cast<std::uint32_t>(report[at + k])}; };
  return {id(9), {static_cast<int>(report[at + 10]), id(11)}, {static_cast<int>(report[at + 12]), id(13)}};
}

/// Which segment of the one world each segment of the ranks is.
class Twins {
 public:
  Twins(const lgs::World& one, const std::vector<Message>& reports) : ids_(reports.size()) {
    std::unordered_map<std::uint64_t, std::vector<SegmentId>> byEnds;  // of the one world, by some of start and end
    const auto key = [](const std::int64_t* s) {
      return (static_cast<std::uint64_t>(s[0]) * 0x9e37'79b9'7f4a'7c15U) ^ static_cast<std::uint64_t>(s[1]);
    };
    for (const SegmentId id : one.segments()) byEnds[key(seen(*one.segment(id)).data())].push_back(id);
    for (std::size_t rank = 0; rank < reports.size(); ++rank)
      for (std::size_t at = 0; at < reports[rank].size(); at += kWords) {
        const std::int64_t* words = reports[rank].data() + at;
        for (const SegmentId id : byEnds[key(words)]) {
          const Seen there = seen(*one.segment(id));
          if (std::equal(there.begin(), there.end(), words)) put(rank, told(reports[rank], at).id, id);
        }
      }
  }

  /// The twin of the segment with this name; null if it has none.
  SegmentId of(const Name& name) const {
    const auto& ids = ids_[static_cast<std::size_t>(name.rank)];
    return name.id.value < ids.size() ? ids[name.id.value] : SegmentId{};
  }

 private:
  void put(std::size_t rank, SegmentId id, SegmentId twin) {
    if (ids_[rank].size() <= id.value) ids_[rank].resize(id.value + std::size_t{1});
    ids_[rank][id.value] = twin;
  }

  std::vector<std::vector<SegmentId>> ids_;  // by rank and id
};

}  // namespace

Message reportOf(const regions::Region& region) {
  Message report;
  for (const SegmentId id : region.world().segments()) {
    if (!region.isOwn(id)) continue;
    const Segment s = *region.world().segment(id);
    const Seen words = seen(s);
    report.insert(report.end(), words.begin(), words.end());
    const Name before = region.nameOf(s.predecessor);
    const Name after = region.nameOf(s.successor);
    report.insert(report.end(), {id.value, before.rank, before.id.value, after.rank, after.id.value});
  }
  return report;
}

Verdict compare(const lgs::World& one, const std::vector<Message>& reports) {
  Verdict verdict;
  const Twins twins(one, reports);
  std::vector<bool> met(one.maxSegmentId() + std::size_t{1});
  for (std::size_t rank = 0; rank < reports.size(); ++rank) {
    for (std::size_t at = 0; at < reports[rank].size(); at += kWords) {
      const Told here = told(reports[rank], at);
      const SegmentId twin = twins.of({static_cast<int>(rank), here.id});
      const std::string who = "segment " + std::to_string(here.id.value) + " of rank " + std::to_string(rank);
      if (!twin || met[twin.value]) return {who + " is not one of the one world, or is there twice", 0, 0};
      met[twin.value] = true;
      const Segment there = *one.segment(twin);
      if (twins.of(here.predecessor) != there.predecessor || twins.of(here.successor) != there.successor)
        return {who + " has a wrong link", 0, 0};
      ++verdict.segments;
      for (const Name& link : {here.predecessor, here.successor})
        verdict.linksAcross += link.id && link.rank != static_cast<int>(rank) ? 1U : 0U;
    }
  }
  if (verdict.segments != one.segments().size()) verdict.wrong = "segments of the one world are missing";
  return verdict;
}

}  // namespace mpi
