// A report on a whole engine: all findings of a run by kind, with the smallest trace and the picture of each.
#pragma once

#include "oracle/check/report.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <string>

namespace lgs::oracle {

class Survey {
 public:
  /// `options` names the engine. Traces, pictures and pages go to the folder as they are found.
  Survey(CheckOptions options, std::string folder, std::chrono::milliseconds shrinkFor)
      : options_(std::move(options)), folder_(std::move(folder)), shrinkFor_(shrinkFor) {}

  /// Takes a mismatch that checkTrace() has found. The first ones of a kind are shrunk; the smallest is kept.
  void add(const Mismatch& found, const Trace& trace);

  bool isEmpty() const { return kinds_.empty(); }

  /// Writes report.md and report.html, which say the same. `again` is the command that does all of it again. Whether
  /// they could be written.
  bool write(const CheckStats& stats, const std::string& again) const;

 private:
  struct Entry {
    std::uint64_t count = 0;
    Trace trace;       // the smallest
    std::string text;  // what is wrong with it
  };

  void keep(const std::string& kind, Entry& entry, const Mismatch& found, const Trace& trace);

  CheckOptions options_;
  std::string folder_;
  std::chrono::milliseconds shrinkFor_;
  std::map<std::string, Entry> kinds_;
};

}  // namespace lgs::oracle
