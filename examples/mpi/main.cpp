// A world in several processes: each MPI rank has a region of it. Edits go to whom they concern, and links between
// segments lead across the borders by rank and id (docs/internals/beyond-one-process.md).
//
//   mpirun -n 4 ./lgs_mpi --side 1000 --rounds 20 --edits 10000 --check
//
// `--check` compares all segments and links at the end with those of one world. Exit status: 0 fine, 1 something
// differs, 2 bad arguments.
#include "exchange.h"
#include "game.h"
#include "report.h"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <string_view>

namespace mpi {
namespace {

using regions::Message;
using regions::Outbox;

struct Arguments {
  Game game;
  bool check = false;
  bool good = true;
};

Arguments argumentsOf(int argc, char** argv) {
  Arguments result;
  for (int k = 1; k < argc; ++k) {
    const std::string_view name = argv[k];
    if (name == "--check") {
      result.check = true;
      continue;
    }
    const std::string_view text = k + 1 < argc ? argv[++k] : "";
    std::int64_t value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    constexpr std::int64_t kMost = 1'000'000'000;
    if (read.ec != std::errc() || read.ptr != text.data() + text.size() || value < 0 || value > kMost)
      return {{}, {}, false};
    if (name == "--side" && value > 0)
      result.game.side = static_cast<std::int32_t>(value);
    else if (name == "--rounds")
      result.game.rounds = value;
    else if (name == "--edits")
      result.game.edits = value;
    else if (name == "--seed")
      result.game.seed = static_cast<std::uint64_t>(value);
    else
      return {{}, {}, false};
  }
  return result;
}

/// What a part of the work took: of the slowest rank.
class Clock {
 public:
  template <class Work>
  void time(const Work& work) {
    const double start = MPI_Wtime();
    work();
    seconds_ += MPI_Wtime() - start;
  }
  double seconds() const {
    double most = 0;
    MPI_Allreduce(&seconds_, &most, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    return most;
  }

 private:
  double seconds_ = 0;
};

/// What all ranks sent to others.
class Traffic {
 public:
  explicit Traffic(int rank) : rank_(rank) {}
  void add(const Outbox& out) {
    for (std::size_t to = 0; to < out.size(); ++to)
      if (to != static_cast<std::size_t>(rank_)) words_ += static_cast<std::int64_t>(out[to].size());
  }
  double kilobytes() const {
    std::int64_t sum = 0;
    MPI_Allreduce(&words_, &sum, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
    return static_cast<double>(sum) * sizeof(std::int64_t) / 1000;
  }

 private:
  int rank_;
  std::int64_t words_ = 0;
};

class Rank {
 public:
  Rank(const Game& game, int rank, int ranks)
      : game_(game),
        rank_(rank),
        ranks_(ranks),
        cutting_(regions::cutInto(game.cells(), ranks)),
        region_(cutting_, rank) {}

  void build() {
    whole_.time([&] {
      editing_.time([&] {
        const auto& [min, max] = cutting_[static_cast<std::size_t>(rank_)];
        constexpr auto kHalo = regions::kHalo;
        load(region_.world(), game_, {{min.i - kHalo, min.j - kHalo}, {max.i + kHalo, max.j + kHalo}});
      });
      commit();
    });
  }

  void play(std::int64_t round) {
    whole_.time([&] {
      editing_.time([&] { edit(round); });
      commit();
    });
  }

  const regions::Region& region() const { return region_; }

  /// What was measured since the last call, for each of some rounds: times of the slowest rank, bytes of all ranks
  /// together. All ranks call it, the first one prints.
  void print(const char* what, double rounds) {
    const std::array<double, 4> times{whole_.seconds(), editing_.seconds(), committing_.seconds(), naming_.seconds()};
    const std::array<double, 3> sent{proposed_.kilobytes(), followed_.kilobytes(), named_.kilobytes()};
    if (rank_ == 0)
      std::printf(
          "%s: %.3f ms (edits %.3f, commit %.3f, names %.3f); sent %.1f KB to owners, %.1f to halos, %.1f names\n",
          what, 1e3 * times[0] / rounds, 1e3 * times[1] / rounds, 1e3 * times[2] / rounds, 1e3 * times[3] / rounds,
          sent[0] / rounds, sent[1] / rounds, sent[2] / rounds);
    whole_ = editing_ = committing_ = naming_ = {};
    proposed_ = followed_ = named_ = Traffic(rank_);
  }

 private:
  void edit(std::int64_t round) {
    Outbox proposals(cutting_.size());
    Outbox edits(cutting_.size());
    for (const regions::Edit& edit : editsOf(game_, round, rank_, ranks_))
      append(proposals[static_cast<std::size_t>(*regions::ownerOf(cutting_, edit.cell))], edit);
    // One may be refused: somebody else had the same idea.
    for (const Message& message : exchange(proposals))
      for (const regions::Edit& edit : regions::readEdits(message)) (void)region_.decide(edit, edits);
    for (const Message& message : exchange(edits))
      for (const regions::Edit& edit : regions::readEdits(message)) region_.follow(edit);
    proposed_.add(proposals);
    followed_.add(edits);
  }

  void commit() {
    Outbox names(cutting_.size());
    committing_.time([&] { region_.commit(names); });
    naming_.time([&] {
      const std::vector<Message> told = exchange(names);
      for (std::size_t from = 0; from < told.size(); ++from) region_.learn(static_cast<int>(from), told[from]);
    });
    named_.add(names);
  }

  Game game_;
  int rank_;
  int ranks_;
  regions::Cutting cutting_;
  regions::Region region_;
  Clock whole_, editing_, committing_, naming_;
  Traffic proposed_{rank_}, followed_{rank_}, named_{rank_};
};

/// The same game in one world: which edits come first is seen from the order in which ranks are asked.
lgs::World oneWorld(const Game& game, int ranks) {
  regions::Region all({game.cells()}, 0);
  Outbox nobody(1);
  load(all.world(), game, game.cells());
  all.commit(nobody);
  for (std::int64_t round = 0; round < game.rounds; ++round) {
    for (int rank = 0; rank < ranks; ++rank)
      for (const regions::Edit& edit : editsOf(game, round, rank, ranks)) (void)all.decide(edit, nobody);
    all.commit(nobody);
  }
  return std::move(all.world());
}

bool isRight(const Rank& rank, const Game& game, int self, int ranks) {
  Outbox out(static_cast<std::size_t>(ranks));
  out[0] = reportOf(rank.region());
  const std::vector<Message> reports = exchange(out);
  if (self != 0) return true;
  const Verdict verdict = compare(oneWorld(game, ranks), reports);
  if (verdict.wrong)
    std::printf("check: %s\n", verdict.wrong->c_str());
  else
    std::printf("check: as in one world: %zu segments, %zu links from rank to rank\n", verdict.segments,
                verdict.linksAcross);
  return !verdict.wrong;
}

int run(int argc, char** argv) {
  int self = 0;
  int ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &self);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const Arguments arguments = argumentsOf(argc, argv);
  const Game& game = arguments.game;
  if (!arguments.good || game.side < 2 * ranks) {
    if (self == 0)
      std::fprintf(stderr,
                   "usage: lgs_mpi [--side CELLS] [--rounds N] [--edits N] [--seed N] [--check]\n"
                   "The side has at least two cells for each rank.\n");
    return 2;
  }
  if (self == 0) std::printf("%d ranks, %d x %d ramps\n", ranks, game.side, game.side);
  Rank rank(game, self, ranks);
  MPI_Barrier(MPI_COMM_WORLD);
  rank.build();
  rank.print("build", 1);
  for (std::int64_t round = 0; round < game.rounds; ++round) rank.play(round);
  rank.print("a round", static_cast<double>(std::max<std::int64_t>(1, game.rounds)));
  return arguments.check && !isRight(rank, game, self, ranks) ? 1 : 0;
}

}  // namespace
}  // namespace mpi

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const int status = mpi::run(argc, argv);
  MPI_Finalize();
  return status;
}
