#include "addons/box2d/ride/ride.h"
#include "addons/box2d/ride/picture.h"
#include "cli/inputs.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>

namespace lgs::cli {

using bench::RideOptions;
using bench::Rider;
using bench::Way;
using oracle::Scene;
using oracle::ScenePolygon;

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

// Where the body starts, in metres from the lower left corner of the scene. A cell is a metre.
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

// A ride ends when the body is beside the ground, or below it.
auto stillAbove(const Scene& scene, Cell origin) {
  std::int32_t columns = 0;
  for (const ScenePolygon& p : scene.polygons) columns = std::max(columns, p.cell.i - origin.i + 1);
  return [columns](int, const b2Body& body, bench::Ground&) {
    const b2Vec2 at = body.GetPosition();
    return at.x >= 0 && at.x <= static_cast<float>(columns) && at.y >= 0;
  };
}

void printTable(const std::vector<bench::NamedTrack>& tracks, double startX) {
  fmt::print("{:<34} {:>8} {:>17} {:>17} {:>14} {:>10}\n", "the ground as", "path, m", "ghost collisions",
             "per 1,000 cells", "strongest, m/s", "came to x");
  for (const auto& [way, track] : tracks) {
    const double end = track.samples.empty() ? startX : track.samples.back().position.x;
    fmt::print("{:<34} {:>8.1f} {:>17} {:>17.0f} {:>14.2f} {:>10.1f}\n", name(way), track.length, track.kicks.size(),
               1000 * static_cast<double>(track.kicks.size()) / std::max(track.length, 1e-9), track.strongest(), end);
  }
}

Status run(RideArguments arguments) {
  if (const Status bad = tryOutputs({arguments.svg}); bad != Status::fine) return bad;
  const auto trace = readWorld(arguments.file);
  if (!trace) return complain(trace.error());
  oracle::Player player(trace->preserve);
  if (const auto done = play(*trace, player); !done) return complain(message(done.error(), arguments.file));
  const Scene scene = player.scene();
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

  std::vector<bench::NamedTrack> tracks;
  for (const Way way : {Way::terrain, Way::loose, Way::polygons, Way::merged, Way::chains}) {
    if (way == Way::chains && !materials(scene)) continue;  // CGAL can not unite it
    tracks.push_back({way, ride(player.world(), scene, way, options)});
  }
  if (arguments.svg != "-") printTable(tracks, options.start.x);
  if (arguments.svg.empty()) return Status::fine;
  tracks.resize(3);
  return write(arguments.svg, drawRides(scene, oracle::outlineOf(player.world()), tracks, options,
                                        arguments.title.empty() ? arguments.file : arguments.title));
}

void addBodyOptions(CLI::App& command, RideArguments& arguments) {
  RideOptions& options = arguments.options;
  static const std::map<std::string, Rider> kRiders{
      {"circle", Rider::circle}, {"box", Rider::box}, {"capsule", Rider::capsule}, {"polygon", Rider::polygon}};
  command
      .add_option("--rider", options.rider,
                  "The body: circle, box, capsule (a box and two circles) or\npolygon; default circle")
      ->transform(CLI::CheckedTransformer(kRiders).description(""))
      ->option_text("KIND");
  addReal(
      command, "--size", [&options](double cells) { options.size = cells; }, {0.05, 10},
      "The size of the body, in cells; default 0.7")
      ->option_text("CELLS");
  command.add_flag("--upright", options.fixedRotation, "Do not let the body turn");
  addReal(
      command, "--friction", [&options](double f) { options.friction = static_cast<float>(f); }, {0, 10},
      "The friction of the body; default 0")
      ->option_text("F");
  addReal(
      command, "--ground-friction", [&arguments](double f) { arguments.groundFriction = static_cast<float>(f); },
      {0, 10}, "The friction of the ground; default 0.2")
      ->option_text("F");
}

void addCourseOptions(CLI::App& command, RideArguments& arguments) {
  RideOptions& options = arguments.options;
  command
      .add_option_function<std::vector<std::string>>(
          "--from",
          [&arguments](const std::vector<std::string>& texts) {
            constexpr RealRange kCells{-0x1p30, 0x1p30};
            for (const std::string& text : texts) arguments.from.push_back(readReal("--from", text, kCells));
          },
          "Where the body's centre starts, in cells; default above the\nleft end of the ground")
      ->expected(2)
      ->option_text("X Y");
  addReal(
      command, "--speed", [&arguments](double speed) { arguments.speed = speed; }, {-50, 50},
      "The speed to the right at the start, in cells a second; a force\nkeeps it up; default 4")
      ->option_text("V");
  command.add_flag("--coast", arguments.coast, "No force: let the body roll or slide");
  addWholeNumber(
      command, "--steps", [&options](std::uint64_t n) { options.steps = static_cast<int>(n); }, {1, 1'000'000},
      "How many steps of 1/60 second at most; default 600. The ride also\nends where the ground ends")
      ->option_text("N");
}

constexpr const char* kRideHelp =
    "The ground is given to Box2D in five ways, and the same body rides over each: as the library's terrain,\n"
    "as the same edges without ghosts, as a fixture for each polygon, as the terrain with straight runs\n"
    "merged, and as chains of the loops of CGAL's union. The table counts the ghost collisions of each ride:\n"
    "pushes of at least 0.01 m/s in a direction that the ground does not have there, to within a degree.\n"
    "A cell is a metre. The picture shows the first three ways.\n\n"
    "Example: lgs ride level.tmx --rider capsule --upright --speed 5 --steps 1800 --svg ride.svg";

}  // namespace

void addRide(CLI::App& app, Action& chosen) {
  const auto arguments = std::make_shared<RideArguments>();
  CLI::App& command =
      *app.add_subcommand("ride", "Let a body ride over a world in Box2D, with and without ghost vertices");
  command.add_option("FILE", arguments->file, "A trace, whose last world is ridden, or a map (.tmx, .ldtk …)")
      ->required()
      ->option_text("(required)");
  addBodyOptions(command, *arguments);
  addCourseOptions(command, *arguments);
  command.add_option("--svg", arguments->svg, "Draw the paths; - is stdout, without the table")->option_text("FILE");
  command.add_option("--title", arguments->title, "The title of the picture; default the file's name")
      ->option_text("TEXT");
  command.footer(kRideHelp);
  command.callback([arguments, &chosen] { chosen = [arguments] { return run(*arguments); }; });
}

}  // namespace lgs::cli
