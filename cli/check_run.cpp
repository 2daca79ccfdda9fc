#include "cli/check_run.h"

#include "oracle/check/isolated.h"
#include "oracle/check/shell.h"
#include "oracle/draw/draw.h"
#include "oracle/reference/words.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"

#include <fmt/format.h>

namespace lgs::cli {

using namespace oracle;

namespace {

void printSummary(const CheckArguments& arguments, const Totals& totals) {
  const CheckStats& s = totals.stats;
  fmt::print("no mismatch\n");
  const std::uint64_t edits = s.edits - totals.built;
  const double seconds = totals.seconds();
  if (totals.built > 0) fmt::print("built by   {}\n", counted(totals.built, "edit"));
  fmt::print("edits      {}, {} of them refused as they must be\n", edits, s.refused);
  fmt::print("commits    {}\n", s.commits);
  fmt::print("compared   {} times with CGAL, {} with the naive reference; {} times the whole world\n", s.cgal, s.naive,
             s.whole);
  fmt::print("segments   {} compared\n", s.segments);
  if (s.brushed > 0) fmt::print("brushes    {} measured against CGAL's exact result\n", s.brushed);
  if (!arguments.engine.isGiven()) {
    fmt::print("calls      {}\n", callsInWords(s));
  }
  fmt::print("time       {:.1f} s, {:.0f} edits/s\n", seconds, static_cast<double>(edits) / seconds);
  if (!arguments.map.empty() || !arguments.suites.empty() || arguments.world.can.regions) return;
  fmt::print("cases      {}; of these had\n{}", totals.cases.cases, table(totals.cases));
}

}  // namespace

std::chrono::milliseconds shrinkTime(const CheckArguments& arguments) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(arguments.shrinkSeconds * 1'000));
}

ReportOptions reportOptions(const CheckArguments& arguments, const Checked& checked) {
  return {arguments.out,         checked.name,       checked.reproduce,
          shrinkTime(arguments), thisProgram("lgs"), arguments.engine.print(),
          checked.areFollowed,   arguments.site};
}

CheckOptions caseOptions(const CheckArguments& arguments) {
  CheckOptions options = arguments.options;
  options.skipRefused = true;
  options.wholeEvery = 1;
  return options;
}

std::string lengthOf(const CheckArguments& arguments) {
  return arguments.seconds ? fmt::format(" --time {}", *arguments.seconds)
                           : fmt::format(" --edits {}", arguments.edits);
}

// The command of an engine may mean files of this folder.
std::string commandAgain(const CheckArguments& arguments, bool brushes, bool views) {
  std::string lgs = thisProgram("lgs") + " check";
  if (brushes) lgs += " --brushes";
  if (views) lgs += " --views";
  if (!arguments.engine.isGiven()) return lgs;
  return fmt::format("cd {} && {}{}", thisFolder(), lgs, arguments.engine.print());
}

Status isolated(const CheckArguments& arguments, const CheckOptions& options, const std::function<Status()>& check,
                const std::function<Checked()>& playing) {
  if (arguments.engine.isGiven()) return check();  // it is isolated enough, or whoever calls this sees to that
  const Shared<Status> status;
  const auto crash = crashOf([&] { *status = flushed(check()); });
  if (!crash) return *status;
  const Checked checked = playing();
  CheckOptions again = options;
  again.views = checked.areFollowed;
  reportCrash(*crash, checked.trace, again, reportOptions(arguments, checked));
  return Status::mismatch;
}

Status finish(const CheckArguments& arguments, const Totals& totals, const Scene& last) {
  printSummary(arguments, totals);
  return drawLast(arguments, last);
}

Status drawLast(const CheckArguments& arguments, const Scene& last) {
  if (arguments.svg.empty()) return Status::fine;
  Player player(last.preserve);  // builds the world anew, because history does not matter
  for (const ScenePolygon& polygon : last.polygons) {
    const std::string name = fmt::format("{}", player.standing().polygons());
    if (const auto done = player.apply(Call::add(name, polygon)); !done) return complain(done.error().text);
  }
  player.commit();
  DrawOptions options;
  options.title = !arguments.map.empty()
                      ? fmt::format("{}, dug and refilled by {}", arguments.map, counted(arguments.edits, "edit"))
                  : !arguments.suites.empty() ? "lgs check, the last case of the suites"
                                              : fmt::format("lgs check, seed {}", arguments.seed);
  const Status written = write(arguments.svg, drawWorld(last, outlineOf(player.world()), options));
  if (written == Status::fine && arguments.svg != "-") fmt::print("picture    {}\n", arguments.svg);
  return written;
}

}  // namespace lgs::cli
