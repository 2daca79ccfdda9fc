// lgs_fuzz: the targets without an engine. Runs inputs from files, changes them at random, converts and reports them.
#include "cli/command.h"
#include "fuzz/archive.h"
#include "fuzz/finding.h"
#include "fuzz/mutate.h"
#include "oracle/check/shell.h"
#include "oracle/trace/file.h"
#include "oracle/trace/model.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>

namespace lgs::fuzz {
namespace {

using cli::complain;
using cli::Status;
using oracle::CheckStats;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMaxSize = 1'024;  // of an input made here

const std::map<std::string, const Target*>& targets() {
#define LGS_FUZZ_TARGET_OF(target) {target.name, &target},
  static const std::map<std::string, const Target*> all{LGS_FUZZ_TARGETS(LGS_FUZZ_TARGET_OF)};
#undef LGS_FUZZ_TARGET_OF
  return all;
}

struct Arguments {
  std::string program;  // as a shell takes it
  std::string target;
  std::vector<std::string> paths;
  std::string output = "-";
  std::string folder = "out/fuzz";
  std::uint64_t repeat = 1;
  std::uint64_t seed = 1;
  double seconds = 5;
  double shrinkSeconds = 20;
  bool all = false;

  const Target& chosen() const { return *targets().at(target); }
  Where where() const {
    return {folder, std::chrono::milliseconds(static_cast<std::int64_t>(shrinkSeconds * 1'000)),
            fmt::format("{} report {}", program, target)};
  }
};

Bytes bytesOf(const std::string& content) {
  return {reinterpret_cast<const std::uint8_t*>(content.data()), content.size()};
}

double cpuSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Files as they are; of archives and folders all files, in order.
tl::expected<std::vector<std::string>, std::string> readAll(const std::vector<std::string>& paths) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
      files.push_back(path);
      continue;
    }
    for (const auto& entry : fs::directory_iterator(path, error)) {
      if (entry.is_regular_file(error)) files.push_back(entry.path().string());
    }
    if (error) return tl::unexpected(path + ": " + error.message());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> contents;
  for (const std::string& file : files) {
    auto content = oracle::readFile(file);
    if (!content) return tl::unexpected(message(content.error(), file));
    if (!file.ends_with(".tar")) {
      contents.push_back(std::move(*content));
      continue;
    }
    auto inputs = filesOf(*content);
    if (!inputs) return tl::unexpected(file + ": " + inputs.error());
    std::move(inputs->begin(), inputs->end(), std::back_inserter(contents));
  }
  return contents;
}

class Session {
 public:
  explicit Session(const Arguments& arguments) : arguments_(arguments), start_(cpuSeconds()) {}

  // False on a finding, which is reported.
  bool run(Bytes input) {
    ++inputs_;
    const auto finding = arguments_.chosen().check(input, stats_);
    if (finding) report(arguments_.chosen(), input, *finding, arguments_.where());
    return !finding;
  }

  void printSummary() const {
    const double seconds = std::max(cpuSeconds() - start_, 1e-6);
    fmt::print("{}: no finding\ninputs     {}\nedits      {}, {} of them refused as they must be\ncommits    {}\n",
               arguments_.target, inputs_, stats_.edits, stats_.refused, stats_.commits);
    fmt::print("time       {:.2f} s of CPU, {:.0f} inputs/s, {:.0f} commits/s\n", seconds,
               static_cast<double>(inputs_) / seconds, static_cast<double>(stats_.commits) / seconds);
  }

 private:
  const Arguments& arguments_;
  CheckStats stats_;
  std::uint64_t inputs_ = 0;
  double start_;
};

Status run(const Arguments& arguments) {
  const auto inputs = readAll(arguments.paths);
  if (!inputs) return complain(inputs.error());
  if (inputs->empty()) return complain("no input: folders and archives are empty");
  Session session(arguments);
  for (std::uint64_t round = 0; round < arguments.repeat; ++round) {
    for (const std::string& input : *inputs) {
      if (!session.run(bytesOf(input))) return Status::mismatch;
    }
  }
  session.printSummary();
  return Status::fine;
}

Status smoke(const Arguments& arguments) {
  const auto corpus = readAll(arguments.paths);
  if (!corpus) return complain(corpus.error());
  Session session(arguments);
  for (const std::string& input : *corpus) {
    if (!session.run(bytesOf(input))) return Status::mismatch;
  }
  oracle::Random random(arguments.seed);
  const auto end = Clock::now() + std::chrono::duration<double>(arguments.seconds);
  while (Clock::now() < end) {
    Buffer input;
    if (!corpus->empty() && random.chance(80)) {
      const Bytes from = bytesOf(random.pick(*corpus));
      input.assign(from.begin(), from.end());
    } else {
      input.resize(random.below(kMaxSize));
      for (std::uint8_t& byte : input) byte = static_cast<std::uint8_t>(random.below(256));
    }
    mutate(arguments.chosen(), input, std::max(kMaxSize, input.size()), random);
    if (!session.run(input)) return Status::mismatch;
  }
  session.printSummary();
  return Status::fine;
}

Status reportInput(const Arguments& arguments) {
  const auto content = oracle::readFile(arguments.paths.front());
  if (!content) return complain(message(content.error(), arguments.paths.front()));
  const Bytes input = bytesOf(*content);
  if (!crashes(arguments.chosen(), input)) return run(arguments);
  reportCrash(arguments.chosen(), input, arguments.where());
  return Status::mismatch;
}

Status toTrace(const Arguments& arguments) {
  const auto content = oracle::readFile(arguments.paths.front());
  if (!content) return complain(message(content.error(), arguments.paths.front()));
  const Target& target = arguments.chosen();
  const oracle::Trace all = target.traceOf(bytesOf(*content));
  const oracle::Trace trace = arguments.all ? all : withoutRefused(all);
  if (trace.calls.empty()) {
    std::string why = "too short for an edit";
    if (target.whyEmpty) why = target.whyEmpty(bytesOf(*content));
    if (!all.calls.empty()) why = "every edit must be refused; --all prints them";
    return complain(fmt::format("{}: no trace: {}", arguments.paths.front(), why));
  }
  return cli::write(arguments.output, printTrace(trace));
}

std::string listOfTargets() {
  std::string text = "Targets:\n";
  for (const auto& [name, target] : targets()) text += fmt::format("  {:<10} {}\n", name, target->about);
  return text;
}

// CLI11's ranges let "nan" pass.
CLI::Validator seconds(bool orZero) {
  return {[orZero](const std::string& text) {
            double value = 0;
            const bool good =
                CLI::detail::lexical_cast(text, value) && (value > 0 || (orZero && value == 0)) && value <= 1e6;
            return good
                       ? ""
                       : fmt::format("'{}' is no {}number of seconds up to a million", text, orZero ? "" : "positive ");
          },
          "SECONDS"};
}

using Command = Status (*)(const Arguments&);

class CommandLine {
 public:
  explicit CommandLine(Arguments& arguments) : arguments_(arguments) {
    app_.require_subcommand(1);
    app_.footer(listOfTargets() + "\nExit status: 0 fine, 1 a finding, 2 bad input or usage.\nMore: fuzz/README.md");
    addRun();
    addSmoke();
    addReport();
    addToTrace();
  }

  Status run(int argc, char** argv) {
    try {
      app_.parse(argc, argv);
      return chosen_(arguments_);
    } catch (const CLI::ParseError& error) {
      return app_.exit(error) == 0 ? Status::fine : Status::badInput;
    }
  }

 private:
  CLI::App& add(const char* name, const char* about, Command command) {
    CLI::App& sub = *app_.add_subcommand(name, about);
    sub.callback([this, command] { chosen_ = command; });
    return sub;
  }
  void addTarget(CLI::App& sub) {
    std::vector<std::string> names;
    for (const auto& entry : targets()) names.push_back(entry.first);
    sub.add_option("TARGET", arguments_.target, "edits, polygons, …: see lgs_fuzz --help")
        ->required()
        ->check(CLI::IsMember(names));
  }
  void addOut(CLI::App& sub) {
    sub.add_option("--out", arguments_.folder, "Folder for a finding; default out/fuzz");
    sub.add_option("--shrink", arguments_.shrinkSeconds, "Seconds to spend on shrinking; default 20")
        ->check(seconds(true));
  }
  void addOneFile(CLI::App& sub, const char* name) { sub.add_option(name, arguments_.paths)->required()->expected(1); }
  void addOutput(CLI::App& sub) { sub.add_option("-o,--output", arguments_.output, "Default: standard output"); }

  void addRun() {
    CLI::App& sub = add("run", "Run inputs: files, or all files of folders and archives (.tar)", fuzz::run);
    addTarget(sub);
    addOut(sub);
    sub.add_option("PATH", arguments_.paths)->required();
    cli::addWholeNumber(
        sub, "--repeat", [this](std::uint64_t n) { arguments_.repeat = n; }, {.min = 1, .max = 1'000'000'000},
        "Run all of them this often, for a timing")
        ->option_text("N");
  }
  void addSmoke() {
    CLI::App& sub = add("smoke", "Run inputs, then random changes of them and random ones", smoke);
    addTarget(sub);
    addOut(sub);
    sub.add_option("PATH", arguments_.paths, "Files, folders and archives to start from; none: from nothing");
    sub.add_option("--seconds", arguments_.seconds, "For how long; default 5")->check(seconds(false));
    cli::addWholeNumber(
        sub, "--seed", [this](std::uint64_t n) { arguments_.seed = n; }, {}, "Default 1")
        ->option_text("N");
  }
  void addReport() {
    CLI::App& sub = add("report", "Run an input that failed; shrink, save and draw its edits", reportInput);
    addTarget(sub);
    addOut(sub);
    addOneFile(sub, "INPUT");
  }
  void addToTrace() {
    CLI::App& sub = add("to-trace", "Print the edits of an input as a trace", toTrace);
    addTarget(sub);
    addOneFile(sub, "INPUT");
    addOutput(sub);
    sub.add_flag("--all", arguments_.all, "With the edits that must be refused, which lgs replay does not take");
  }

  CLI::App app_{
      "The fuzz targets of LocalGridSeg without a fuzzing engine: they run, change, convert and report inputs.",
      "lgs_fuzz"};
  Arguments& arguments_;
  Command chosen_ = nullptr;
};

}  // namespace
}  // namespace lgs::fuzz

int main(int argc, char** argv) {
  lgs::fuzz::Arguments arguments;
  arguments.program = lgs::oracle::thisProgram(argv[0]);
  return static_cast<int>(lgs::fuzz::CommandLine(arguments).run(argc, argv));
}
