#include "oracle/check/refusal.h"

#include "oracle/reference/blame.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

std::string inWords(Cell cell) { return cell == Error::kNoCell ? "no cell" : fmt::format("({}, {})", cell.i, cell.j); }

std::string nameOf(std::optional<ErrorCode> code) { return code ? name(*code) : "a bad name"; }

// The polygon that is named as overlapped must be there, and must be overlapped.
std::string wrongOther(const Error& error, const Step& step, const Model& model, const World& world) {
  const auto other = world.polygon(error.other);
  if (!other || world.cellOf(error.other) != error.cell) return "names a polygon that is not in the cell";
  if (other->block != error.otherBlock) return "names another block than that of the polygon";
  const LocalPolygon there(other->vertices.begin(), other->vertices.end());
  const auto& placed = model.in(error.cell);
  if (std::none_of(placed.begin(), placed.end(), [&](const Model::Placed& p) { return p.vertices == there; }))
    return "names a polygon that was not placed";
  if (error.polygon < 0 || static_cast<std::size_t>(error.polygon) >= step.inCell) return "does not say which polygon";
  const Edit& edit = step.edits[static_cast<std::size_t>(error.polygon)];
  return overlap(there, edit.polygon.vertices) ? "" : "names a polygon that is not overlapped";
}

std::string wrongRefusal(const Error& error, const Step& step, const Model& model, const World& world) {
  const Verdict& verdict = step.verdict;
  if (error.code != verdict.code) return fmt::format("says {} instead of {}", name(error.code), name(*verdict.code));
  if (error.cell != verdict.cell)
    return fmt::format("names cell {} instead of {}", inWords(error.cell), inWords(verdict.cell));
  if (message(error).empty()) return "says nothing";
  if (error.code == ErrorCode::capacity) return error.vertex == -1 ? "" : "names a vertex, which is not to blame";
  if (step.edits.size() == 1) {
    if (std::string wrong = wrongBlame(error, step.edits.front().polygon.vertices); !wrong.empty()) return wrong;
  }
  const bool withPlaced = error.code == ErrorCode::overlap && error.cell != Error::kNoCell;
  return withPlaced ? wrongOther(error, step, model, world) : "";
}

}  // namespace

std::string inWords(const Step& step) {
  std::string text = fmt::format("{} of '{}'", describe(step.door), step.edits.front().name);
  if (step.edits.size() > 1) text += fmt::format(" to '{}'", step.edits.back().name);
  return text;
}

std::string wrongAnswer(const Step& step, const tl::expected<void, TraceError>& done, const Model& model,
                        const World& world) {
  const auto& [accepted, code, cell, index] = step.verdict;
  if (accepted) {
    if (done) return "";
    const char* const how = done.error().refusal ? "refused, but is good" : "answered wrongly";
    return fmt::format("{}: {}: {}", how, inWords(step), done.error().text);
  }
  if (done) return fmt::format("accepted, but must be refused as {}: {}", nameOf(code), inWords(step));
  const auto& [line, text, refusal] = done.error();
  if (refusal.has_value() != code.has_value())
    return fmt::format("must be refused as {}, but is answered: {}: {}", nameOf(code), inWords(step), text);
  const std::string wrong = refusal ? wrongRefusal(*refusal, step, model, world) : "";
  return wrong.empty() ? "" : fmt::format("the refusal {}: {}: {}", wrong, inWords(step), text);
}

std::string wrongRefusals(const std::vector<RefusedEdit>& expected, const std::vector<RefusedEdit>& actual) {
  const auto at = std::ranges::mismatch(expected, actual, {}, &RefusedEdit::name, &RefusedEdit::name);
  const auto isMoreIn = [](const std::vector<RefusedEdit>& one, const std::vector<RefusedEdit>& other,
                           const RefusedEdit& edit) {
    return std::ranges::count(one, edit.name, &RefusedEdit::name) >
           std::ranges::count(other, edit.name, &RefusedEdit::name);
  };
  if (at.in2 != actual.end() && isMoreIn(actual, expected, *at.in2))
    return fmt::format("refused, but is good: '{}': {}", at.in2->name, at.in2->reason);
  if (at.in1 != expected.end() && isMoreIn(expected, actual, *at.in1))
    return fmt::format("accepted, but must be refused as {}: '{}'", at.in1->reason, at.in1->name);
  const bool isOver = at.in1 == expected.end() && at.in2 == actual.end();
  return isOver ? "" : fmt::format("the refusal of '{}' is not told in the order of the edits", at.in2->name);
}

}  // namespace lgs::oracle
