// polygon-clipping, an npm package. It runs under Node in a child process, for as long as the subject lives. The time
// of a build includes two short messages, some 50 µs.
#include "bench/subjects/libraries.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace lgs::bench {
namespace {

constexpr const char* kScript = LGS_SOURCE_DIR "/bench/subjects/union.mjs";

// A child process that answers each line with a line.
class Node {
 public:
  Node() {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    std::string name = "node";
    std::string script = kScript;
    std::array<char*, 3> arguments{name.data(), script.data(), nullptr};
    if (::posix_spawnp(&child_, "node", &actions, nullptr, arguments.data(), environ) != 0) child_ = 0;
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    socket_ = ends[0];
  }
  ~Node() {
    if (socket_ >= 0) ::close(socket_);
    if (child_ > 0) ::waitpid(child_, nullptr, 0);
  }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  void send(std::string line) const {
    line += '\n';
    for (std::size_t sent = 0; sent < line.size();) {
      const ssize_t n = ::send(socket_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL);
      if (n <= 0) return;  // the child is gone, which receive() finds out
      sent += static_cast<std::size_t>(n);
    }
  }

  /// One line; empty if the child ended.
  std::string receive() const {
    std::string line;
    std::array<char, 65'536> buffer{};
    while (!line.ends_with('\n')) {
      const ssize_t n = ::recv(socket_, buffer.data(), buffer.size(), 0);
      if (n <= 0) return {};
      line.append(buffer.data(), static_cast<std::size_t>(n));
    }
    line.pop_back();
    return line;
  }

 private:
  int socket_ = -1;
  pid_t child_ = 0;
};

class PolygonClipping final : public Subject {
 public:
  explicit PolygonClipping(std::unique_ptr<Node> node) : node_(std::move(node)) {}

  void prepare(const Tiles& tiles) override {
    nlohmann::json polygons = nlohmann::json::array();
    for (const oracle::ScenePolygon& p : tiles.scene().polygons) {
      nlohmann::json& ring = polygons.emplace_back(nlohmann::json::array());
      for (const LocalPoint v : p.vertices) {
        const Point at = toWorld(p.cell, v);
        ring.push_back({at.x, at.y});
      }
    }
    node_->send(polygons.dump());
  }

  bool build() override {
    node_->send("build");
    return node_->receive() == "built";
  }

  Edges edges() const override {
    node_->send("read");
    Edges edges;
    for (const auto& polygon : nlohmann::json::parse(node_->receive())) {
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        Ring ring;
        for (const auto& point : polygon[k]) {
          ring.push_back({std::llround(point[0].get<double>()), std::llround(point[1].get<double>())});
        }
        addRing(std::move(ring), k == 0 ? Winding::counterClockwise : Winding::clockwise, edges);
      }
    }
    return edges;
  }

 private:
  std::unique_ptr<Node> node_;
};

}  // namespace

Made makePolygonClipping() {
  auto node = std::make_unique<Node>();
  if (node->receive() != "ready") {
    return tl::unexpected(std::string("needs Node and its package: npm ci --prefix examples/engines"));
  }
  return std::make_unique<PolygonClipping>(std::move(node));
}

}  // namespace lgs::bench
