#include "bench/comparison.h"

#include "bench/edit_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace lgs::bench {
namespace {

constexpr int kRepeats = 10;                  // builds of an incremental subject in each round; one build says little
constexpr std::size_t kEdits = 1'000;         // edits in each round
constexpr std::size_t kFewEdits = 10;         // at least, if an engine of others is slow
constexpr Nanoseconds kSlow = 2'000'000'000;  // what takes longer runs only once

// Whether a subject takes many seconds. Then it runs only with ComparisonOptions::slow.
bool isSlow(std::string_view subject, const Tiles& tiles) {
  const std::size_t most = tiles.name == "full" ? 100'000 : subject == "boost" ? 1'100 : 11'000;
  return (subject == "boost" || subject == "geos") && tiles.size() > most;
}

// How many edits a subject makes in the time that is too slow for a build, the pipe included. The world stays as it is.
std::size_t editsFor(Incremental& subject, const Tiles& tiles) {
  const std::size_t cell = distinctCells(tiles, 1, 1)[0];
  subject.find(cell);
  const Nanoseconds time = timeOf([&] {
    subject.remove(cell);
    subject.add(cell, tiles.at[cell]);
  });
  return std::clamp(static_cast<std::size_t>(kSlow / std::max<Nanoseconds>(time, 1)), kFewEdits, kEdits);
}

std::int64_t twiceAreaOf(const Tiles& tiles) {
  Edges edges;
  std::vector<std::int64_t> areas;
  for (const Kind& kind : tiles.kinds) {
    edges.clear();
    for (const auto& polygon : kind.polygons) {
      Ring ring;
      for (const LocalPoint v : polygon) ring.push_back({v.x, v.y});
      addRing(std::move(ring), Winding::asItIs, edges);
    }
    areas.push_back(boundaryOf(edges).twiceArea);
  }
  std::int64_t area = 0;
  for (const std::uint16_t kind : tiles.at) area += areas[kind];
  return area;
}

}  // namespace

struct Comparison::Entry {
  SubjectInfo info;
  Row polygons;
  Row row;
  std::unique_ptr<Subject> subject;  // kept from round to round, unless it is incremental and builds
  bool isOut = false;                // it refused the input, or came to another boundary

  // Builds from nothing, so an incremental subject has to be a new one each time. False if it refuses the input.
  bool build(const Tiles& tiles) {
    if (info.isIncremental) subject = makeSubject(info.name).value();
    if (info.isIncremental || polygons.times.empty()) polygons.times.add(timeOf([&] { subject->prepare(tiles); }));
    bool isDone = false;
    const Nanoseconds time = timeOf([&] { isDone = subject->build(); });
    row.times.add(subject->ownTime().value_or(time));
    return isDone;
  }
};

void Comparison::note(const std::string& scenario, std::string_view subject, const std::string& text) {
  notes_.push_back(fmt::format("{}: {}: {}", scenario, subject, text));
}

std::vector<Comparison::Entry> Comparison::start(const std::string& scenario, const Tiles& tiles,
                                                 const std::vector<std::string_view>& names) {
  std::vector<Entry> entries;
  for (const SubjectInfo& info : subjects()) {
    if (std::find(names.begin(), names.end(), info.name) == names.end()) continue;
    if (!options_.slow && isSlow(info.name, tiles)) {
      note(scenario, info.name, "skipped, it takes many seconds");
      continue;
    }
    auto made = makeSubject(info.name);
    if (!made) {
      note(scenario, info.name, "skipped, " + made.error());
      continue;
    }
    const std::string name(info.name);
    const std::size_t cells = tiles.size();
    entries.push_back(
        {info, {"polygons-" + scenario, name, {}, cells, 0}, {scenario, name, {}, cells, 0}, std::move(*made)});
  }
  return entries;
}

Boundary Comparison::expected(const std::string& scenario, const Tiles& tiles) {
  const auto engine = makeSubject("engine-shapes").value();
  engine->prepare(tiles);
  engine->build();
  Boundary boundary = boundaryOf(engine->edges());
  checksum_ = checksum_ * 31 + boundary.checksum();
  if (boundary.twiceArea != twiceAreaOf(tiles)) {
    agree_ = false;
    note(scenario, "engine-shapes", "MISMATCH: the area inside the boundary is not that of the polygons");
  }
  return boundary;
}

void Comparison::check(Entry& entry, const Boundary& expected) {
  const Edges edges = entry.subject->edges();
  entry.row.segments = entry.polygons.segments = edges.size();
  const std::string what = difference(expected, boundaryOf(edges));
  if (what.empty()) return;
  entry.isOut = true;
  agree_ = false;
  note(entry.row.scenario, entry.info.name, "MISMATCH with the engine: " + what);
}

void Comparison::take(std::vector<Entry> entries) {
  for (Entry& entry : entries) {
    if (entry.isOut) continue;
    if (!entry.polygons.times.empty()) rows_.push_back(std::move(entry.polygons));
    rows_.push_back(std::move(entry.row));
  }
}

void Comparison::build(const std::string& scenario, const Tiles& tiles, const std::vector<std::string_view>& names) {
  const Boundary boundary = expected(scenario, tiles);
  std::vector<Entry> entries = start(scenario, tiles, names);
  for (int round = 0; round < options_.rounds; ++round) {
    for (Entry& entry : entries) {
      const bool isEnough = round > 0 && entry.row.times.max() > kSlow;
      if (entry.isOut || isEnough) continue;
      options_.progress(fmt::format("{}, {}", scenario, entry.info.name));
      for (int k = 0; k < (entry.info.isIncremental ? kRepeats : 1) && !entry.isOut; ++k) {
        if (k > 0 && entry.row.times.max() > kSlow) break;
        if (!entry.build(tiles)) {
          entry.isOut = true;
          note(scenario, entry.info.name, "refuses the input");
        } else if (k == 0) {
          check(entry, boundary);
        }
      }
    }
  }
  take(std::move(entries));
}

void Comparison::edit(const std::string& size, const Tiles& tiles, const std::vector<std::string_view>& names) {
  const Boundary boundary = expected("edit-" + size, tiles);
  std::vector<Entry> entries = start("edit-" + size, tiles, names);
  std::vector<Row> nearby;
  std::size_t edits = kEdits;
  for (Entry& entry : entries) {
    options_.progress(fmt::format("edit-{}, {}", size, entry.info.name));
    entry.subject->prepare(tiles);
    entry.subject->build();
    if (entry.info.isOther) edits = std::min(edits, editsFor(static_cast<Incremental&>(*entry.subject), tiles));
    nearby.push_back(entry.row);
    nearby.back().scenario = "dig-" + size;
  }
  for (int round = 0; round < options_.rounds; ++round) {
    for (const Where where : {Where::anywhere, Where::nearby}) {
      const EditPlan plan = planEdits(tiles, edits, where, static_cast<std::uint64_t>(round) + 1);
      for (std::size_t k = 0; k < entries.size(); ++k) {
        EditTimes times;
        timeRemovesAndAdds(static_cast<Incremental&>(*entries[k].subject), tiles, plan, times);
        Times& all = where == Where::anywhere ? entries[k].row.times : nearby[k].times;
        all.add(times.first);
        all.add(times.back);
      }
    }
  }
  for (std::size_t k = 0; k < entries.size(); ++k) {
    check(entries[k], boundary);
    nearby[k].segments = entries[k].row.segments;
  }
  for (std::size_t k = entries.size(); k-- > 0;) {
    if (entries[k].isOut) nearby.erase(nearby.begin() + static_cast<std::ptrdiff_t>(k));
  }
  take(std::move(entries));
  rows_.insert(rows_.end(), nearby.begin(), nearby.end());
}

void Comparison::recomputeInstead(const std::string& from, const std::string& to) {
  const std::vector<SubjectInfo> all = subjects();
  std::vector<Row> again;
  for (const Row& row : rows_) {
    const auto isThis = [&](const SubjectInfo& info) { return info.name == row.subject && !info.isIncremental; };
    if (row.scenario == from && std::any_of(all.begin(), all.end(), isThis)) again.push_back(row);
  }
  const auto isThere = [&](const Row& row) { return row.scenario == to; };
  const auto at = std::find_if(rows_.rbegin(), rows_.rend(), isThere).base();  // after the last row of `to`
  for (Row& row : again) row.scenario = to;
  rows_.insert(at, again.begin(), again.end());
}

}  // namespace lgs::bench
