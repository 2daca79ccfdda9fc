#include "bench/ride/ride.h"

#include "bench/ride/picture.h"
#include "cli/command.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>

namespace lgs::oracle {
namespace {

struct RideArguments {
  std::string file;
  std::string svg;
  std::string title;
  std::vector<double> from;
  double speed = 4;
  bool coast = false;
  float groundFriction = 0.2F;
  RideOptions options;
};

// Metres from the lower left corner of the scene; a cell is a metre.
b2Vec2 startOf(const RideArguments& arguments, const Scene& scene, Cell origin) {
  if (!arguments.from.empty()) {
    return {static_cast<float>(arguments.from[0] - origin.i), static_cast<float>(arguments.from[1] - origin.j)};
  }
  std::int32_t top = origin.j;
  for (const ScenePolygon& p : scene.polygons) {
    if (p.cell.i <= origin.i + 1) top = std::max(top, p.cell.j);
  }
  return {1, static_cast<float>(top + 1 - origin.j + arguments.options.size)};
}

Cell lowerLeft(const Scene& scene) {
  Cell least = scene.polygons[0].cell;
  for (const ScenePolygon& p : scene.polygons) least = {std::min(least.i, p.cell.i), std::min(least.j, p.cell.j)};
  return least;
}

// A ride ends where the body has left the ground behind, or below.
auto stillAbove(const Scene& scene, Cell origin) {
  std::int32_t columns = 0;
  for (const ScenePolygon& p : scene.polygons) columns = std::max(columns, p.cell.i - origin.i + 1);
  return [columns](int, const b2Body& body, Ground&) {
    const b2Vec2 at = body.GetPosition();
    return at.x >= 0 && at.x <= static_cast<float>(columns) && at.y >= 0;
  };
}

void printTable(const std::vector<NamedTrack>& tracks, double startX) {
  fmt::print("{:<34} {:>8} {:>7} {:>17} {:>14} {:>10}\n", "the ground as", "path, m", "kicks", "per 1,000 cells",
             "strongest, m/s", "came to x");
  for (const auto& [way, track] : tracks) {
    const double end = track.samples.empty() ? startX : track.samples.back().position.x;
    fmt::print("{:<34} {:>8.1f} {:>7} {:>17.0f} {:>14.2f} {:>10.1f}\n", name(way), track.length, track.kicks.size(),
               1000 * static_cast<double>(track.kicks.size()) / std::max(track.length, 1e-9), track.strongest(), end);
  }
}

Status run(RideArguments arguments) {
  if (const Status bad = tryOutputs({arguments.svg}); bad != Status::fine) return bad;
  const auto trace = readWorld(arguments.file);
  if (!trace) return complain(trace.error());
  Player player(trace->preserve);
  if (const auto done = play(*trace, player); !done) return complain(message(done.error(), arguments.file));
  const Scene& scene = player.scene();
  if (scene.polygons.empty()) return complain(arguments.file + ": nothing to ride on; the world is empty at its end");

  RideOptions& options = arguments.options;
  options.terrain.origin = lowerLeft(scene);
  options.terrain.material = [friction = arguments.groundFriction](Block) {
    return box2d::Material{.friction = friction};
  };
  options.beforeStep = stillAbove(scene, options.terrain.origin);
  options.start = startOf(arguments, scene, options.terrain.origin);
  options.velocity = {static_cast<float>(arguments.speed), 0};
  options.drive = arguments.coast ? 0 : arguments.speed;

  std::vector<NamedTrack> tracks;
  for (const Way way : {Way::terrain, Way::loose, Way::polygons, Way::merged, Way::chains}) {
    if (way == Way::chains && !materials(scene)) continue;  // CGAL can not unite it
    tracks.push_back({way, ride(player.world(), scene, way, options)});
  }
  if (arguments.svg != "-") printTable(tracks, options.start.x);
  if (arguments.svg.empty()) return Status::fine;
  tracks.resize(3);
  return write(arguments.svg, drawRides(scene, outlineOf(player.world()), tracks, options,
                                        arguments.title.empty() ? arguments.file : arguments.title));
}

}  // namespace

void addRide(CLI::App& app, Run& chosen) {
  const auto arguments = std::make_shared<RideArguments>();
  RideOptions& options = arguments->options;
  CLI::App& command = *app.add_subcommand("ride", "Let a body ride over a world in Box2D, with and without ghosts");
  command.add_option("FILE", arguments->file, "A trace, of which the end is ridden, or a Tiled map (.tmx)")->required();
  static const std::map<std::string, Rider> kRiders{
      {"circle", Rider::circle}, {"box", Rider::box}, {"capsule", Rider::capsule}, {"polygon", Rider::polygon}};
  command
      .add_option("--rider", options.rider, "circle, box, capsule (a box and two circles) or polygon;\ndefault circle")
      ->transform(CLI::CheckedTransformer(kRiders).description(""))
      ->option_text("KIND");
  command.add_option("--size", options.size, "Of the body, in cells; default 0.7")
      ->check(CLI::Range(0.05, 10.0))
      ->option_text("CELLS");
  command.add_option("--from", arguments->from, "Where its centre starts, in cells; by default above the\nleft end")
      ->expected(2)
      ->option_text("X Y");
  command
      .add_option("--speed", arguments->speed, "Cells a second to the right, at the start and driven to;\ndefault 4")
      ->check(CLI::Range(-50.0, 50.0))
      ->option_text("V");
  command.add_flag("--coast", arguments->coast, "Do not drive: it rolls or slides as it will");
  command.add_flag("--upright", options.fixedRotation, "It does not turn");
  command.add_option("--friction", options.friction, "Of the body; default 0")
      ->check(CLI::Range(0.0, 10.0))
      ->option_text("F");
  command.add_option("--ground-friction", arguments->groundFriction, "Of the ground; default 0.2")
      ->check(CLI::Range(0.0, 10.0))
      ->option_text("F");
  addWholeNumber(
      command, "--steps", [&options](std::uint64_t n) { options.steps = static_cast<int>(n); }, {1, 1'000'000},
      "Of 1/60 second, at most; it ends where the ground does;\ndefault 600")
      ->option_text("N");
  command.add_option("--svg", arguments->svg, "Draw the paths; - is stdout, without the table")->option_text("FILE");
  command.add_option("--title", arguments->title, "Of the picture; by default the file's name")->option_text("TEXT");
  command.footer(
      "The same ride over the same ground, given to Box2D in five ways: as the library's terrain, as the\n"
      "same edges without ghosts, as a fixture for each polygon, as the terrain with straight runs merged,\n"
      "and as chains of the loops of CGAL's union. A kick is a push of at least 0.01 m/s in a direction\n"
      "that the ground does not have there, to within a degree: a ghost collision. A cell is a metre.\n"
      "The picture shows the first three.\n\n"
      "Example: lgs ride level.tmx --rider capsule --upright --speed 5 --steps 1800 --svg ride.svg");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run(*arguments); }; });
}

}  // namespace lgs::oracle
