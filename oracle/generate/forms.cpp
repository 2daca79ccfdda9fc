#include "oracle/generate/forms.h"

#include <algorithm>
#include <set>
#include <vector>

namespace lgs::oracle {

using Kind = Call::Kind;

namespace {

using Edits = std::span<const Call>;

constexpr std::size_t kLongest = 300;  // edits of one call: enough to fill a cell

template <class Goes>
std::size_t lengthOf(Edits edits, Goes goesOn) {
  return static_cast<std::size_t>(std::ranges::find_if_not(edits, goesOn) - edits.begin());
}

std::size_t removesAt(Edits edits) {
  return lengthOf(edits, [](const Call& edit) { return edit.kind == Kind::remove; });
}

std::size_t addsAt(Edits edits, bool toOneCell) {
  return lengthOf(edits, [&](const Call& edit) {
    if (edit.kind != Kind::add) return false;
    const Coming& first = edits.front().comes[0];
    return !toOneCell || (edit.comes[0].cell == first.cell && edit.comes[0].block == first.block);
  });
}

// How many of the next edits one call is to make.
std::size_t lengthOfRow(Edits edits, Random& random) {
  if (!random.chance(75)) return 1;
  const std::size_t removes = removesAt(edits);
  const std::size_t adds = addsAt(edits.subspan(removes), removes > 0 || random.chance(50));
  const std::size_t length = removes == 0 ? adds : removes + (random.chance(60) ? adds : 0);
  return std::clamp<std::size_t>(random.chance(20) ? std::min<std::size_t>(length, 3) : length, 1, kLongest);
}

CellRect boxOf(const std::set<Cell>& cells) {
  CellRect box{*cells.begin(), *cells.begin()};
  for (const Cell cell : cells) {
    box.min = {std::min(box.min.i, cell.i), std::min(box.min.j, cell.j)};
    box.max = {std::max(box.max.i, cell.i), std::max(box.max.j, cell.j)};
  }
  return box;
}

// Makes a rectangle larger where that adds no polygons to it.
CellRect widened(CellRect cells, const Standing& standing, Random& random) {
  constexpr std::array<std::int32_t, 4> kCells{0, 0, 1, 40};
  for (std::int32_t Cell::*const axis : {&Cell::i, &Cell::j}) {
    for (const bool isUp : {false, true}) {
      CellRect larger = cells;
      const std::int32_t by = kCells[random.below(kCells.size())];
      isUp ? larger.max.*axis += by : larger.min.*axis -= by;
      if (inRange(larger.min) && inRange(larger.max) && standing.polygonsIn(larger) == standing.polygonsIn(cells))
        cells = larger;
    }
  }
  return cells;
}

// A row of removes, then adds, as one call.
class Row {
 public:
  Row(Edits edits, const Standing& standing, Random& random)
      : edits_(edits),
        removes_(edits.first(removesAt(edits))),
        adds_(edits.subspan(removes_.size())),
        standing_(standing),
        random_(random) {
    for (const Call& edit : removes_) {
      if (!standing.isAlive(edit.name())) continue;
      cells_.insert(standing.cellOf(edit.name()));
      ++alive_;
    }
    for (const Call& edit : adds_) cells_.insert(edit.comes[0].cell);
    const auto isOfBlock = [&](const Call& edit) { return edit.comes[0].block == adds_.front().comes[0].block; };
    isOneBlock_ = std::ranges::all_of(adds_, isOfBlock);
  }

  Call call() {
    for (int attempt = 0; attempt < 3; ++attempt)
      if (Call call = inForm(random_.pick(kinds())); call.kind != Kind::commit) return call;
    return edits_.front();  // as it is
  }

 private:
  // Those that may be able to make it.
  std::vector<Kind> kinds() const {
    using enum Call::Kind;
    const std::size_t removes = removes_.size(), adds = adds_.size();
    if (removes == 1 && adds == 1) return {setBlock, setBlock, setBlock, replace, exchange};
    if (removes > 0 && adds > 0) return {replace, exchange};
    if (removes > 1) return {clear, removeMany, exchange};
    if (removes == 1) return {remove, remove, remove, clear, removeMany, exchange};
    if (adds > 1 && cells_.size() == 1 && isOneBlock_) return {addShape, addShape, replace, addMany, exchange, fill};
    if (adds > 1) return {fill, fill, addMany};
    return {add, add, add, add, add, addShape, addShape, fill, replace, addMany, exchange};
  }

  // A commit, if that kind can not make it.
  Call inForm(Kind kind) {
    Call call = Call::of(kind);
    const bool isOneCell = cells_.size() == 1, areAlive = alive_ == removes_.size();
    constexpr std::array kNotations{Notation::lattice, Notation::list, Notation::floats, Notation::doubles};
    call.notation = kNotations[random_.below(kNotations.size())];
    call.offset = random_.below(kSpoiltOffset);
    call.room = random_.below(4U);
    for (const Call& edit : removes_) call.goes.push_back(edit.goes[0]);
    bool fits = areAlive && !cells_.empty();
    switch (kind) {
      case Kind::add:
      case Kind::remove:
        fits = edits_.size() == 1;
        if (kind == Kind::add && fits) comeEach(call);
        break;
      case Kind::addShape:
        fits = fits && isOneCell && isOneBlock_ && removes_.empty();
        if (fits) comeTogether(call, adds_.size(), true);
        break;
      case Kind::replace:
        fits = fits && isOneCell && isOneBlock_ && !adds_.empty() &&
               removes_.size() == standing_.in(*cells_.begin()).size();
        call.goes.clear();
        if (fits) comeTogether(call, adds_.size(), true);
        break;
      case Kind::addMany:
        comeEach(call);
        break;
      case Kind::exchange:
        fits = fits && isOneCell;
        if (fits) call.cells = {*cells_.begin(), *cells_.begin()};
        comeEach(call);
        break;
      case Kind::fill: {
        const std::size_t inCell = addsAt(adds_, true);
        fits = fits && isOneBlock_ && isRectangle(inCell);
        if (!fits) break;
        call.cells = boxOf(cells_);
        comeTogether(call, inCell, false);
        break;
      }
      case Kind::clear:
        fits = fits && standing_.polygonsIn(boxOf(cells_)) == removes_.size();
        call.goes.clear();
        if (fits) call.cells = widened(boxOf(cells_), standing_, random_);
        break;
      case Kind::setBlock:
        fits = fits && isOneCell && standing_[removes_[0].name()].vertices == adds_[0].comes[0].shape[0];
        call.comes = {{.block = adds_[0].comes[0].block}};
        break;
      default:
        break;
    }
    return fits ? tidied(std::move(call)) : Call();
  }

  // As one shape, or one by one.
  void comeTogether(Call& call, std::size_t count, bool areNamed) const {
    Coming& coming = call.comes.emplace_back(adds_.front().comes[0]);
    coming.shape.clear();
    coming.names.clear();
    for (const Call& edit : adds_.first(count)) {
      coming.shape.push_back(edit.comes[0].shape[0]);
      if (areNamed) coming.names.push_back(edit.name());
    }
  }
  void comeEach(Call& call) const {
    for (const Call& edit : adds_) call.comes.push_back(edit.comes[0]);
  }

  // Whether the same polygons come to each cell of a rectangle.
  bool isRectangle(std::size_t inCell) const {
    if (adds_.empty() || adds_.size() % inCell != 0 || adds_.size() / inCell != cells_.size()) return false;
    for (std::size_t k = 0; k < adds_.size(); ++k) {
      const Coming& coming = adds_[k].comes[0];
      if (coming.cell != adds_[k - k % inCell].comes[0].cell || coming.shape != adds_[k % inCell].comes[0].shape)
        return false;
    }
    const CellRect box = boxOf(cells_);
    const auto length = [](std::int32_t min, std::int32_t max) { return std::int64_t{max} - min + 1; };
    const auto area = static_cast<std::uint64_t>(length(box.min.i, box.max.i) * length(box.min.j, box.max.j));
    return area == cells_.size();
  }

  Edits edits_, removes_, adds_;
  const Standing& standing_;
  Random& random_;
  std::set<Cell> cells_;
  std::size_t alive_ = 0;  // of what is removed
  bool isOneBlock_ = true;
};

}  // namespace

Call withoutFreshNames(Call call, const Model& model) {
  for (Named& named : call.goes) {
    if (named.how != Named::How::name || !named.name.starts_with('#') || !model.isAlive(named.name)) continue;
    const Cell cell = model.standing().cellOf(named.name);
    const auto& there = model.standing().in(cell);
    const auto at = std::ranges::find(there, named.name, &Standing::Placed::name) - there.begin();
    named = {.how = Named::How::standing, .cell = cell, .nth = static_cast<std::uint32_t>(at)};
  }
  return call;
}

void makeInForms(Edits edits, Model& model, Random& random, const std::function<void(Call)>& put) {
  const auto make = [&](Call call) {
    call = withoutFreshNames(std::move(call), model);
    const bool isAccepted = model.play(call);
    put(std::move(call));
    return isAccepted;
  };
  while (!edits.empty()) {
    if (edits.front().kind == Kind::commit) {
      Call commit;
      commit.nth = random.below(4U);
      make(std::move(commit));
      edits = edits.subspan(1);
      continue;
    }
    const Edits row = edits.first(lengthOfRow(edits, random));
    Call call = Row(row, model.standing(), random).call();
    const bool isAll = row.size() == 1 || !isPlain(call);
    if (!make(std::move(call)) && isAll && row.size() > 1)
      for (const Call& edit : row) make(edit);
    edits = edits.subspan(isAll ? row.size() : 1);
  }
}

}  // namespace lgs::oracle
