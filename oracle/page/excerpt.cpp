#include "oracle/page/excerpt.h"

#include "oracle/reference/compare.h"
#include "oracle/trace/plain_edits.h"

#include <algorithm>
#include <string>
#include <unordered_map>

namespace lgs::oracle::paging {
namespace {

using Part = Excerpt::Part;

constexpr std::size_t kMostSteps = 1'000;
constexpr std::int32_t kReach = 12;  // cells to each side of the place where the trace ends

// The cell of each edit, of a brush the one in its middle; that of a commit is nothing, and so is that of an edit that
// no world can take.
std::vector<std::optional<Cell>> cellsOf(const Trace& trace, std::size_t count) {
  std::vector<std::optional<Cell>> cells(count);
  std::unordered_map<std::string, Cell> cellOf;
  for (std::size_t k = 0; k < count; ++k) {
    const Call& edit = trace.calls[k];
    if (edit.kind == Call::Kind::add && inRange(edit.polygon().cell)) {
      cells[k] = cellOf.try_emplace(edit.name(), edit.polygon().cell).first->second;
    } else if (edit.kind == Call::Kind::brush && !isOutOfReach(edit.brush)) {
      const auto [min, max] = cellsUnder(edit.brush);
      cells[k] = Cell{min.i + (max.i - min.i) / 2, min.j + (max.j - min.j) / 2};
    } else if (edit.kind == Call::Kind::remove) {
      if (const auto found = cellOf.find(edit.name()); found != cellOf.end()) {
        cells[k] = found->second;
        cellOf.erase(found);
      }
    }
  }
  return cells;
}

// Where the trace ends: at the first difference, or else at the last edit.
Cell focusOf(const std::vector<std::optional<Cell>>& cells, const std::optional<PageEnd>& end) {
  if (end) {
    const auto differences = compare(end->expected, end->actual);
    if (!differences.empty()) return cellAt(differences.front().segment().start);
  }
  const auto last = std::find_if(cells.rbegin(), cells.rend(), [](const auto& cell) { return cell.has_value(); });
  return last == cells.rend() ? Cell{} : **last;
}

}  // namespace

Excerpt excerptOf(const Trace& trace, const std::optional<PageEnd>& end) {
  const std::size_t count = end ? end->edits : trace.calls.size();
  Excerpt excerpt{std::vector(count, Part::step), {}};
  if (count <= kMostSteps) return excerpt;

  const auto cells = cellsOf(trace, count);
  const Cell focus = focusOf(cells, end);
  excerpt.cells = CellRect{{focus.i - kReach, focus.j - kReach}, {focus.i + kReach, focus.j + kReach}};
  bool changed = false;  // since the commit before
  for (std::size_t k = 0; k < count; ++k) {
    const bool isCommit = trace.calls[k].kind == Call::Kind::commit;
    const bool isNear = isCommit ? changed || k + 1 == count : cells[k] && contains(*excerpt.cells, *cells[k]);
    if (!isNear) excerpt.parts[k] = Part::hidden;
    changed = !isCommit && (changed || isNear);
  }
  std::size_t steps = 0;
  for (std::size_t k = count; k-- > 0;) {
    if (excerpt.parts[k] == Part::hidden) continue;
    // The world in which the page begins is one that was committed.
    if (++steps > kMostSteps && (steps > 2 * kMostSteps || trace.calls[k].kind == Call::Kind::commit)) {
      std::replace(excerpt.parts.begin(), excerpt.parts.begin() + static_cast<std::ptrdiff_t>(k) + 1, Part::step,
                   Part::early);
      break;
    }
  }
  return excerpt;
}

}  // namespace lgs::oracle::paging
