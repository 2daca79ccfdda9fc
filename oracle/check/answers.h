// The references as a service: whoever sends the lines that an engine under the harness reads gets what a perfect engine
// would write.
#pragma once

#include "oracle/engine/engine.h"

#include <optional>
#include <string>
#include <string_view>

namespace lgs::oracle {

struct Answer {
  std::string text = {};                ///< whole lines; none where there is nothing to say
  bool isOfBadLine = false;             ///< it says what is wrong with the line, and nothing has changed
  std::optional<Failure> failure = {};  ///< why there is no answer
};

class Answers {
 public:
  explicit Answers(Engine& engine);

  /// Takes the next line, without its end. Comments and empty lines have no answer.
  Answer take(std::string_view line);

 private:
  std::string fault(std::string_view line, Answer& answer);
  std::string reset();
  std::string preserve(const PreservePairs& more);
  void commit(Answer& answer);

  Engine& engine_;
  PreservePairs preserve_;
  bool hasEdits_ = false;  // or commits, since the reset
  std::size_t lines_ = 0;
};

}  // namespace lgs::oracle
