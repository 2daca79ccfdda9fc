// Traces from texts that must be good, and what is said of those that are not.
#pragma once

#include "oracle/trace/player.h"
#include "oracle/trace/trace.h"

#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

namespace lgs::oracle {

inline Trace mustParse(const std::string& text) {
  ParsedTrace parsed = parseTrace(text);
  EXPECT_FALSE(parsed.error) << message(*parsed.error, "trace");
  return std::move(parsed.trace);
}

/// The message that `lgs replay bad.trace` would give, empty if there is none.
inline std::string faultOf(const std::string& text) {
  const ParsedTrace parsed = parseTrace(text);
  Player player(parsed.trace.preserve);
  if (const auto played = play(parsed.trace, player); !played) return message(played.error(), "bad.trace");
  return parsed.error ? message(*parsed.error, "bad.trace") : "";
}

struct BadText {
  std::string text;
  std::string begin;  ///< of the message
};

inline void expectFaults(const std::vector<BadText>& rows) {
  for (const BadText& row : rows) {
    const std::string fault = faultOf(row.text);
    EXPECT_TRUE(fault.starts_with(row.begin)) << "got   " << fault << "\nwant  " << row.begin;
    EXPECT_EQ(fault.empty(), row.begin.empty()) << fault;
  }
}

}  // namespace lgs::oracle
