// What the two ends of a line send to each other. Any message may be lost, come twice, or come late.
#pragma once

#include "ground.h"
#include "squares.h"

#include <optional>

namespace in_step {

/// What a client requests. A server's turn is the number of its commits.
struct Question {
  enum class Kind : std::uint8_t {
    parts,   ///< the hashes of the parts of a square above kLeaf
    ground,  ///< what stands in a chunk, or in a leaf
  };
  Kind kind = Kind::parts;
  Square square;
  friend auto operator<=>(const Question&, const Question&) = default;
};

/// What a server says. All of it is as of one turn.
struct News {
  enum class Kind : std::uint8_t {
    edits,   ///< what the commit of this turn changed; to all clients. Without cells it is a sign of life.
    parts,   ///< an answer
    ground,  ///< an answer
  };
  Kind kind = Kind::edits;
  std::uint64_t turn = 0;
  std::uint64_t hash = 0;  ///< of the world
  Square square;           ///< edits: the least one that all ground lies in; of answers: which one was requested
  Ground ground;           ///< edits: the cells that were changed; ground: the cells of the square that hold something
  Parts parts;
};

Bytes bytesOf(const Question& question);
std::optional<Question> readQuestion(std::span<const std::byte> bytes);
Bytes bytesOf(const News& news);
std::optional<News> readNews(std::span<const std::byte> bytes);

}  // namespace in_step
