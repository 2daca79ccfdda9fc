// Engines as tables of functions: this library's as a shared object, and one that is wrong.
#include "oracle/check/failure.h"
#include "oracle/engine/table_engine.h"
#include "oracle/generate/generator.h"
#include "oracle/tests/engines/workbench.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"

namespace lgs::oracle {
namespace {

TEST(SharedObject, OfThisLibraryAnswersLikeThisLibrary) {
  const auto loaded = TableEngine::load(LGS_ENGINE_SO);
  ASSERT_TRUE(loaded) << loaded.error();
  Engine& engine = **loaded;
  EXPECT_EQ(engine.name(), "LocalGridSeg");
  Capabilities can = Capabilities::all();
  can.delta = true;
  EXPECT_EQ(engine.can(), can);
  CheckStats stats;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const auto found = checkTrace(randomCase({3, 3, 50}, seed), {.engine = &engine, .skipRefused = true}, stats);
    ASSERT_TRUE(found) << found.error().text;
    EXPECT_FALSE(*found) << (*found)->text;
  }
  EXPECT_GT(stats.refused, 10U);
}

// A table of one's own: it keeps nothing, and puts out what it is told to.
struct Fake {
  static inline lgs_engine_segment segment;
  static inline bool refuses = false;
  static void* create() { return &segment; }
  static void nothing(void*) {}
  static void preserve(void*, std::uint32_t, std::uint32_t) {}
  static void add(void*, const char*, std::int32_t, std::int32_t, std::uint32_t, const std::int32_t*, std::size_t) {}
  static void remove(void*, const char*) {}
  static void commit(void*, const lgs_engine_answer* answer) {
    if (refuses) answer->refused(answer->to, "a", "why?");
    answer->segments(answer->to, &segment, 1);
  }
  static constexpr lgs_engine_table kTable{LGS_ENGINE_VERSION, "fake", "ghosts blocks", create, nothing, nothing,
                                           preserve,           add,    remove,          commit};
};

Mismatch::Kind kindOfFinding(const lgs_engine_segment& segment, bool refuses, const char* can = "ghosts blocks") {
  Fake::segment = segment;
  Fake::refuses = refuses;
  lgs_engine_table table = Fake::kTable;
  table.capabilities = can;
  const auto engine = TableEngine::make(&table);
  EXPECT_TRUE(engine);
  const Trace trace{{}, {Call::add("a", {{}, 1, {{0, 0}, {65'536, 0}, {0, 65'536}}})}};
  const auto found = findMismatch(trace, {.engine = engine->get()});
  EXPECT_TRUE(found);
  return found->kind;
}

TEST(SharedObject, ItsFaultsAreFound) {
  EXPECT_EQ(kindOfFinding({{0, 0}, {65'536, 0}, {0, 1}, {2, 2}, 1, 0}, false), Mismatch::Kind::naive);
  EXPECT_EQ(kindOfFinding({{0, 0}, {65'536, 0}, {0, 1}, {2, 2}, 1, 0}, true), Mismatch::Kind::verdict);
  EXPECT_EQ(kindOfFinding({{0, 0}, {65'536, 0}, {0, 1}, {2, 2}, 1, 0}, false, "ghosts blocks delta"),
            Mismatch::Kind::protocol)
      << "it declares lists of changes, and puts out segments";
  EXPECT_EQ(kindOfFinding({{0, 0}, {0, 0}, {0, 1}, {2, 2}, 1, 0}, false), Mismatch::Kind::naive) << "no length";
  EXPECT_EQ(kindOfFinding({{0, 0}, {INT64_MAX, 0}, {0, 1}, {2, 2}, 1, 0}, false), Mismatch::Kind::protocol);
  EXPECT_EQ(kindOfFinding({{0, 0}, {1, 0}, {INT64_MIN, 1}, {2, 2}, 1, 3}, false), Mismatch::Kind::naive) << "missing";
}

TEST(SharedObject, BadTablesAreTold) {
  lgs_engine_table table = Fake::kTable;
  EXPECT_FALSE(TableEngine::make(nullptr));
  table.version = 2;
  EXPECT_EQ(TableEngine::make(&table).error(), "it is of version 2; there is only 1");
  table = Fake::kTable;
  table.capabilities = "ghosts magic";
  EXPECT_FALSE(TableEngine::make(&table));
  EXPECT_FALSE(TableEngine::load("no-such.so"));
  const auto withNull = [](auto lgs_engine_table::*pointer) {
    lgs_engine_table one = Fake::kTable;
    one.*pointer = nullptr;
    return TableEngine::make(&one).has_value();
  };
  using T = lgs_engine_table;
  EXPECT_FALSE(withNull(&T::name) || withNull(&T::capabilities) || withNull(&T::create) || withNull(&T::destroy));
  EXPECT_FALSE(withNull(&T::reset) || withNull(&T::preserve) || withNull(&T::add) || withNull(&T::remove));
  EXPECT_FALSE(withNull(&T::commit));
}

}  // namespace
}  // namespace lgs::oracle

namespace lgs::test {
namespace {

using SharedObjects = Workbench;

TEST_F(SharedObjects, AreCheckedByTheCommand) {
  const Outcome good = sh("lgs check --engine-so '" LGS_ENGINE_SO "' --edits 500");
  EXPECT_EQ(good.status, 0) << good.text;
  EXPECT_NE(good.text.find("engine     LocalGridSeg: segments, ghosts, blocks and lists of changes are compared"),
            std::string::npos);
  const Outcome joined = sh("lgs check --engine-so '" LGS_ENGINE_SO "' --assume 'ghosts merged delta' --edits 300");
  EXPECT_EQ(joined.status, 0) << joined.text;
  const Outcome silent = sh("lgs check --engine-so '" LGS_ENGINE_SO "' --assume ghosts --edits 300");
  EXPECT_NE(silent.text.find("put out a change, and does not declare 'delta'"), std::string::npos) << silent.text;
  EXPECT_EQ(sh("lgs check --engine-so '" LGS_ENGINE_SO "' --brushes --edits 300").status, 0);
  const Outcome squares =
      sh("lgs check --engine-so '" LGS_ENGINE_SO "' --assume 'squares delta' --brushes --edits 300");
  EXPECT_EQ(squares.status, 2) << squares.text;
  EXPECT_NE(squares.text.find("what the engine can not have: edit "), std::string::npos) << squares.text;
  EXPECT_EQ(sh("lgs check --engine-so ./missing.so --edits 10").status, 2);
  EXPECT_EQ(sh("lgs check --engine-so a.so --engine b").status, 2);
  EXPECT_EQ(sh("lgs check --engine-timeout 3").status, 2);
  EXPECT_EQ(sh("lgs check --engine-so a.so --assume magic").status, 2);
}

// A variable of a script that is not set must not make it a check of this library.
TEST_F(SharedObjects, AndCommandsAreNotEmpty) {
  EXPECT_EQ(sh("lgs check --engine '' --edits 10").status, 2);
  EXPECT_EQ(sh("lgs check --engine-so '' --edits 10").status, 2);
  const std::string trace = "printf 'lgs-trace 1\\n' > t.trace; lgs replay t.trace --check ";
  EXPECT_EQ(sh(trace).status, 0);
  EXPECT_EQ(sh(trace + "--engine ''").status, 2);
  EXPECT_EQ(sh(trace + "--engine-so ''").status, 2);
}

// The crash is told and shrunk, and the commands that are printed show it again.
TEST_F(SharedObjects, MayCrashAndHang) {
  const std::vector<std::pair<std::string, std::string>> told{
      {"crash", "the engine crashed with SIGABRT after edit 1\n"},
      {"throw", "what():  thrown\n"},
      {"exit", "the engine ended with status 3 after edit 1\n"},
      {"sleep", "the engine has not answered within 0.5 s after edit 1\n"}};
  for (const auto& [bad, words] : told) {
    ASSERT_EQ(::setenv("LGS_BAD", bad.c_str(), 1), 0);
    const Outcome outcome =
        sh("lgs check --engine-so '" LGS_BAD_SO "' --engine-timeout 0.5 --edits 100 --shrink 1 --out out/" + bad);
    EXPECT_EQ(outcome.status, 1) << outcome.text;
    for (const std::string& part : {words, std::string("its log ends:\nnow it goes wrong\n")})
      EXPECT_NE(outcome.text.find(part), std::string::npos) << part << "\n" << outcome.text;
    const Outcome seen = sh("rm out/" + bad + "/*.svg; " + afterWord(outcome.text, "look at it "));
    EXPECT_EQ(seen.status, 1) << seen.text;
    EXPECT_NE(seen.text.find(words), std::string::npos) << seen.text;
    EXPECT_EQ(sh("grep -q '<svg' out/" + bad + "/*.svg").status, 0);
    const Outcome again = sh(afterWord(outcome.text, "again      ") + " --shrink 1");
    EXPECT_NE(again.text.find(words), std::string::npos) << again.text;
    EXPECT_LT(outcome.seconds + seen.seconds + again.seconds, 30);
  }
  ::unsetenv("LGS_BAD");
}

// A dump is of the engine that was checked. Edits that are rightly refused are no trouble.
TEST_F(SharedObjects, ReplayATrace) {
  const std::string trace =
      "printf 'lgs-trace 1\\nadd p1 0 0 1  0 0 1 0 1 1\\nadd bad 0 0 1  0 0 1 0 1 1\\n' > t.trace; "
      "rm -f d.txt; lgs replay t.trace --check --dump d.txt --svg d.svg ";
  const Outcome good = sh(trace + "--engine-so '" LGS_ENGINE_SO "'; cat d.txt");
  EXPECT_EQ(good.status, 0) << good.text;
  EXPECT_NE(good.text.find("checked 1 commit"), std::string::npos) << good.text;
  EXPECT_NE(good.text.find("segment 0 0 65536 0 65536 65536 65536 65536 1\n"), std::string::npos) << good.text;
  const Outcome bad = sh(trace + "--engine-so '" LGS_BAD_SO "' --assume 'slants refuses'; echo status $?; cat d.txt");
  EXPECT_NE(bad.text.find("status 1\n"), std::string::npos) << bad.text;
  EXPECT_EQ(bad.text.find("segment 0 0"), std::string::npos) << "this library's: " << bad.text;
}

TEST_F(SharedObjects, DigInAMap) {
  const Outcome good = sh("lgs check --engine-so '" LGS_ENGINE_SO "' --map '" LGS_SOURCE_DIR
                          "/proptests/regressions/uncut-wall.trace' --edits 50");
  EXPECT_EQ(good.status, 0) << good.text;
  const Outcome bad = sh("lgs check --engine-so '" LGS_PUBLISHED_SO "' --map '" LGS_SOURCE_DIR
                         "/proptests/regressions/uncut-wall.trace' --edits 200 --shrink 1");
  EXPECT_EQ(bad.status, 1) << bad.text;
  const Outcome again = sh(afterWord(bad.text, "again      ") + " --shrink 1");
  EXPECT_EQ(again.status, 1) << again.text;
}

// The published algorithm departs from the laws (docs/internals/departures.md); in worlds of squares it does not.
TEST_F(SharedObjects, ThePublishedAlgorithmIsOne) {
  const Outcome departs = sh("lgs check --engine-so '" LGS_PUBLISHED_SO "' --edits 1000");
  EXPECT_EQ(departs.status, 1) << departs.text;
  EXPECT_NE(departs.text.find("engine     published: "), std::string::npos) << departs.text;
  EXPECT_LE(editsOfMismatch(), 4U) << departs.text;
  const Outcome squares =
      sh("lgs check --engine-so '" LGS_PUBLISHED_SO "' --assume 'ghosts squares cells=100' --edits 1000");
  EXPECT_EQ(squares.status, 0) << squares.text;
}

}  // namespace
}  // namespace lgs::test
