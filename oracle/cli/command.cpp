#include "oracle/cli/command.h"

#include "oracle/cli/imported.h"
#include "oracle/trace/file.h"

#include <fmt/format.h>
#include <cstdio>

namespace lgs::oracle {

Status complain(std::string_view text) {
  fmt::print(stderr, "{}\n", text);
  return Status::badInput;
}

Status write(const std::string& path, std::string_view content) {
  const auto done = writeFile(path, content);
  return done ? Status::fine : complain(message(done.error(), path));
}

tl::expected<Trace, std::string> readWorld(const std::string& path) {
  if (path.ends_with(".tmx")) {
    const auto map = tiled::importMap(path);
    if (!map) return tl::unexpected(tiled::message(map.error()));
    return traceOf(*map);
  }
  auto trace = readTrace(path);
  if (!trace) return tl::unexpected(message(trace.error(), path));
  return std::move(*trace);
}

void addOracleOption(CLI::App& command, CheckOptions& options) {
  command
      .add_option_function<std::string>(
          "--oracle",
          [&options](const std::string& which) {
            options.naive = which != "cgal";
            options.cgal = which != "naive";
          },
          "cgal: the exact union of all polygons; naive: the laws word\nby word; default both")
      ->check(CLI::IsMember({"cgal", "naive", "both"}))
      ->option_text("cgal|naive|both");
}

}  // namespace lgs::oracle
