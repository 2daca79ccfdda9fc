#include "fuzz/format.h"

#include <fmt/format.h>
#include <algorithm>
#include <unordered_map>

namespace lgs::fuzz {
namespace {

using oracle::Edit;
using oracle::Trace;
using Fault = std::string;

class Encoder {
 public:
  Encoder() { bytes_.assign(kRecord, 0); }  // the header: no preserve pairs

  Fault run(const Trace& trace) {
    if (editCount(trace) >= kMaxEdits) return fmt::format("{} edits or more", kMaxEdits);
    for (const auto& [a, b] : trace.preserve.pairs()) {
      begin(Action::preserve);
      append(4, a, 4);
      append(8, b, 4);
    }
    for (const Edit& edit : trace.edits) {
      if (edit.kind == Edit::Kind::commit) {
        begin(Action::commit);
      } else if (edit.kind == Edit::Kind::brush) {
        return "there is an edit by a brush";
      } else if (edit.kind == Edit::Kind::remove) {
        const auto placed = recordOf_.find(edit.name);
        begin(Action::removeRecord);
        append(4, placed == recordOf_.end() ? kNoRecord : placed->second, 4);
      } else if (Fault fault = add(edit); !fault.empty()) {
        return fault;
      }
    }
    return {};
  }

  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  Fault add(const Edit& edit) {
    const auto& vertices = edit.polygon.vertices;
    if (vertices.size() > kMaxVertices) return fmt::format("'{}' has more than {} vertices", edit.name, kMaxVertices);
    for (std::size_t k = 0; k < vertices.size(); k += 3) {
      const std::size_t count = std::min<std::size_t>(3, vertices.size() - k);
      begin(Action::vertices, static_cast<std::uint8_t>(3 - count));
      for (std::size_t m = 0; m < count; ++m) {
        const LocalPoint p = vertices[k + m];
        constexpr std::int32_t kReach = 1 << 19;
        if (p.x < -kReach || p.x >= kReach || p.y < -kReach || p.y >= kReach) {
          return fmt::format("'{}' has a vertex more than 8 cells away from its cell", edit.name);
        }
        const auto twenty = [](std::int32_t v) { return static_cast<std::uint64_t>(v) & 0xfffff; };
        append(1 + 5 * m, twenty(p.x) | twenty(p.y) << 20, 5);
      }
    }
    recordOf_[edit.name] = static_cast<std::uint32_t>(begin(Action::raw));
    append(4, static_cast<std::uint32_t>(edit.polygon.cell.i), 4);
    append(8, static_cast<std::uint32_t>(edit.polygon.cell.j), 4);
    append(12, edit.polygon.block, 4);
    return {};
  }

  // Returns the record's number.
  std::size_t begin(Action action, std::uint8_t high = 0) {
    bytes_.push_back(static_cast<std::uint8_t>(static_cast<unsigned>(action) | high * 64U));
    bytes_.resize(bytes_.size() + kRecord - 1);
    return bytes_.size() / kRecord - 1;
  }

  void append(std::size_t at, std::uint64_t value, std::size_t size) {
    const std::size_t record = bytes_.size() - kRecord;
    for (std::size_t k = 0; k < size; ++k) bytes_[record + at + k] = static_cast<std::uint8_t>(value >> (8 * k));
  }

  std::vector<std::uint8_t> bytes_;
  std::unordered_map<std::string, std::uint32_t> recordOf_;
};

}  // namespace

tl::expected<std::vector<std::uint8_t>, std::string> encode(const Trace& trace) {
  Encoder encoder;
  if (Fault fault = encoder.run(trace); !fault.empty()) return tl::unexpected(std::move(fault));
  return encoder.take();
}

}  // namespace lgs::fuzz
