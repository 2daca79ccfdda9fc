#include "world_file.h"

#include <sqlite3.h>

#include <optional>
#include <utility>

namespace world_file {
namespace {

using lgs::Cell;
using lgs::CellRect;
using lgs::GroundHashes;

constexpr int kApplication = 0x4c475357;  // "LGSW": by it `file` and SQLite know whose file it is

std::string errorOf(sqlite3* file) { return file ? sqlite3_errmsg(file) : "there is no memory left"; }

tl::unexpected<std::string> failure(sqlite3* file) { return tl::unexpected(errorOf(file)); }

bool run(sqlite3* file, const char* sql) { return sqlite3_exec(file, sql, nullptr, nullptr, nullptr) == SQLITE_OK; }

/// A prepared statement. Its parameters are numbered from 1, its columns from 0.
class Statement {
 public:
  Statement(sqlite3* file, const char* sql) { sqlite3_prepare_v2(file, sql, -1, &statement_, nullptr); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  ~Statement() { sqlite3_finalize(statement_); }

  void bind(int k, std::int64_t number) { sqlite3_bind_int64(statement_, k, number); }
  void bind(int k, const in_step::Bytes& bytes) {
    sqlite3_bind_blob64(statement_, k, bytes.data(), bytes.size(), SQLITE_TRANSIENT);
  }
  void bindCorners(const CellRect& cells) {
    bind(1, cells.min.i);
    bind(2, cells.min.j);
    bind(3, cells.max.i);
    bind(4, cells.max.j);
  }
  /// Whether there is another row. What is not prepared has none, and isDone() is false then.
  bool step() {
    code_ = statement_ ? sqlite3_step(statement_) : SQLITE_ERROR;
    return code_ == SQLITE_ROW;
  }
  bool isDone() const { return code_ == SQLITE_DONE; }
  void reset() { sqlite3_reset(statement_); }

  bool isInteger(int k) const { return sqlite3_column_type(statement_, k) == SQLITE_INTEGER; }
  std::int64_t number(int k) const { return sqlite3_column_int64(statement_, k); }
  std::string text(int k) const {
    const unsigned char* text = sqlite3_column_text(statement_, k);
    return text ? reinterpret_cast<const char*>(text) : "";
  }
  std::span<const std::byte> bytes(int k) const {
    const void* first = sqlite3_column_blob(statement_, k);
    return {static_cast<const std::byte*>(first), static_cast<std::size_t>(sqlite3_column_bytes(statement_, k))};
  }

 private:
  sqlite3_stmt* statement_ = nullptr;
  int code_ = SQLITE_OK;
};

std::int64_t asNumber(sqlite3* file, const char* sql) {
  Statement statement(file, sql);
  return statement.step() ? statement.number(0) : -1;
}

constexpr const char* kSelectAll = "SELECT i, j, hash, ground FROM chunk ORDER BY i, j";
constexpr const char* kSelect =
    "SELECT i, j, hash, ground FROM chunk WHERE i BETWEEN ?1 AND ?3 AND j BETWEEN ?2 AND ?4 ORDER BY i, j";

// SQLite keeps what is no whole number as it is, also in a column of INTEGER.
constexpr const char* kRemoveNoCells =
    "DELETE FROM chunk WHERE typeof(i) <> 'integer' OR i NOT BETWEEN -2147483648 AND 2147483647 "
    "OR typeof(j) <> 'integer' OR j NOT BETWEEN -2147483648 AND 2147483647";

std::optional<Stored> storedOf(const Statement& row) {
  if (!row.isInteger(0) || !row.isInteger(1)) return {};
  const std::int64_t i = row.number(0), j = row.number(1);
  const Cell corner{static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)};
  if (corner.i != i || corner.j != j || GroundHashes::square(corner, 0).cells.min != corner) return {};
  return Stored{corner, static_cast<std::uint64_t>(row.number(2)), row.bytes(3).size()};
}

/// What stands in a chunk, if its bytes are good.
std::optional<in_step::Ground> groundOf(const Stored& stored, std::span<const std::byte> bytes) {
  in_step::Reader in(bytes);
  in_step::Ground ground = in_step::readGround(in);
  if (!in.isGood() || !in.isAtEnd()) return {};
  const CellRect cells = GroundHashes::square(stored.corner, 0).cells;
  for (const auto& [cell, content] : ground)
    if (!lgs::contains(cells, cell)) return {};
  lgs::World alone;  // it checks the polygons, and hashes them
  if (!in_step::setGround(alone, ground, {{0, 0}, {-1, -1}}) || groundHash(alone, cells) != stored.hash) return {};
  return ground;
}

/// The chunks that have a cell of a rectangle, as one rectangle.
CellRect wholeChunks(const CellRect& cells) {
  return {GroundHashes::square(cells.min, 0).cells.min, GroundHashes::square(cells.max, 0).cells.max};
}

}  // namespace

void WorldFile::Close::operator()(sqlite3* file) const { sqlite3_close(file); }

tl::expected<WorldFile, std::string> WorldFile::open(const std::filesystem::path& path) {
  if (path.empty()) return tl::unexpected(std::string("the path is empty"));
  sqlite3* opened = nullptr;
  // As an absolute path: SQLite takes some others for no file, as ":memory:".
  const int code = sqlite3_open_v2(std::filesystem::absolute(path).string().c_str(), &opened,
                                   SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  std::unique_ptr<sqlite3, Close> file(opened);
  if (code != SQLITE_OK) return failure(opened);
  sqlite3_busy_timeout(opened, 5'000);
  // A commit returns when the disk has it.
  if (!run(opened, "PRAGMA synchronous = FULL")) return failure(opened);
  // Only who makes the file has to wait for others, and looks again then.
  const std::int64_t tables = asNumber(opened, "SELECT count(*) FROM sqlite_schema");
  if (tables < 0) return failure(opened);
  if (tables == 0) {
    if (!run(opened, "BEGIN IMMEDIATE")) return failure(opened);
    const bool isNew = asNumber(opened, "PRAGMA application_id") == 0 && asNumber(opened, "PRAGMA user_version") == 0 &&
                       asNumber(opened, "SELECT count(*) FROM sqlite_schema") == 0;
    const std::string make = "PRAGMA application_id = " + std::to_string(kApplication) +
                             "; PRAGMA user_version = " + std::to_string(kVersion) +
                             "; CREATE TABLE chunk (i INTEGER NOT NULL, j INTEGER NOT NULL, hash INTEGER NOT NULL, "
                             "ground BLOB NOT NULL, PRIMARY KEY (i, j)) WITHOUT ROWID";
    if ((isNew && !run(opened, make.c_str())) || !run(opened, "COMMIT")) return failure(opened);
  }
  const std::int64_t application = asNumber(opened, "PRAGMA application_id");
  const std::int64_t version = asNumber(opened, "PRAGMA user_version");
  if (application != kApplication) return tl::unexpected(std::string("this is no world of LocalGridSeg"));
  if (version != kVersion)
    return tl::unexpected("the file is of version " + std::to_string(version) + ", and this program reads version " +
                          std::to_string(kVersion));
  return WorldFile(std::move(file));
}

Done WorldFile::save(const lgs::World& world, const GroundHashes& hashes, const CellRect& cells) {
  if (isEmpty(cells)) return {};
  sqlite3* const file = file_.get();
  if (!run(file, "BEGIN IMMEDIATE")) return failure(file);
  const auto rollBack = [file] {
    tl::unexpected<std::string> why = failure(file);
    run(file, "ROLLBACK");
    return why;
  };
  const auto rollBackAsHashesDiffer = [file] {
    run(file, "ROLLBACK");
    return tl::unexpected(std::string("the hashes are not those of the world: commit, and update them first"));
  };
  std::map<Cell, std::uint64_t> there;
  Statement select(file,
                   "SELECT i, j, hash FROM chunk WHERE i BETWEEN ?1 AND ?3 AND j BETWEEN ?2 AND ?4 "
                   "AND typeof(i) = 'integer' AND typeof(j) = 'integer'");
  select.bindCorners(wholeChunks(cells));
  while (select.step())
    there[{static_cast<std::int32_t>(select.number(0)), static_cast<std::int32_t>(select.number(1))}] =
        static_cast<std::uint64_t>(select.number(2));
  if (!select.isDone()) return rollBack();
  Statement put(file, "INSERT OR REPLACE INTO chunk VALUES (?1, ?2, ?3, ?4)");
  for (const lgs::HashedSquare& chunk : hashes.hashes(cells)) {
    const auto found = there.find(chunk.cells.min);
    const bool isThere = found != there.end() && found->second == chunk.hash;
    if (found != there.end()) there.erase(found);
    if (isThere || world.firstUnloaded(chunk.cells)) continue;  // what is not in memory stays as it is
    if (groundHash(world, chunk.cells) != chunk.hash) return rollBackAsHashesDiffer();
    in_step::Bytes bytes;
    in_step::put(bytes, in_step::groundIn(world, chunk.cells));
    put.bind(1, chunk.cells.min.i);
    put.bind(2, chunk.cells.min.j);
    put.bind(3, static_cast<std::int64_t>(chunk.hash));
    put.bind(4, bytes);
    put.step();
    if (!put.isDone()) return rollBack();
    put.reset();
  }
  Statement remove(file, "DELETE FROM chunk WHERE i = ?1 AND j = ?2");
  for (const auto& [corner, hash] : there) {
    const CellRect chunk = GroundHashes::square(corner, 0).cells;
    if (world.firstUnloaded(chunk)) continue;  // it is not in memory, and not gone
    if (groundHash(world, chunk) != 0) return rollBackAsHashesDiffer();
    remove.bind(1, corner.i);
    remove.bind(2, corner.j);
    remove.step();
    if (!remove.isDone()) return rollBack();
    remove.reset();
  }
  if (!run(file, "COMMIT")) return rollBack();
  return {};
}

Done WorldFile::load(lgs::World& world, const CellRect& cells) const {
  if (isEmpty(cells)) return {};
  in_step::Ground all;
  Statement select(file_.get(), kSelect);
  select.bindCorners(wholeChunks(cells));
  while (select.step()) {
    const auto stored = storedOf(select);
    auto ground = stored ? groundOf(*stored, select.bytes(3)) : std::nullopt;
    if (!ground)
      return tl::unexpected("the chunk from cell (" + select.text(0) + ", " + select.text(1) + ") on is damaged");
    all.merge(*ground);
  }
  if (!select.isDone()) return failure(file_.get());
  if (world.firstUnloaded(wholeChunks(cells)))
    return tl::unexpected(std::string("some of these chunks are unloaded: World::reloadEmpty() comes first"));
  if (!in_step::setGround(world, all, wholeChunks(cells)))
    return tl::unexpected(std::string("the world refuses the ground"));
  return {};
}

tl::expected<std::vector<Stored>, std::string> WorldFile::chunks() const {
  std::vector<Stored> found;
  Statement select(file_.get(), kSelectAll);
  while (select.step())
    if (const auto stored = storedOf(select)) found.push_back(*stored);
  if (!select.isDone()) return failure(file_.get());
  return found;
}

std::vector<Stored> WorldFile::check(std::string& complaint) const {
  Statement integrity(file_.get(), "PRAGMA integrity_check(1)");
  complaint = integrity.step() ? integrity.text(0) : errorOf(file_.get());
  if (complaint == "ok") complaint.clear();
  std::vector<Stored> found;
  Statement select(file_.get(), kSelectAll);
  while (select.step()) {
    const auto stored = storedOf(select);
    found.push_back(stored.value_or(Stored{{static_cast<std::int32_t>(select.number(0)),  // where no chunk begins
                                            static_cast<std::int32_t>(select.number(1))}}));
    found.back().isGood = stored && groundOf(*stored, select.bytes(3));
  }
  if (!select.isDone() && complaint.empty()) complaint = errorOf(file_.get());
  return found;
}

tl::expected<std::size_t, std::string> WorldFile::repair() {
  std::string complaint;
  sqlite3* const file = file_.get();
  if (!run(file, "BEGIN IMMEDIATE")) return failure(file);
  const auto rollBack = [file] {
    tl::unexpected<std::string> why = failure(file);
    run(file, "ROLLBACK");
    return why;
  };
  if (!run(file, kRemoveNoCells)) return rollBack();
  auto removed = static_cast<std::size_t>(sqlite3_changes(file));
  Statement remove(file, "DELETE FROM chunk WHERE i = ?1 AND j = ?2");
  for (const Stored& stored : check(complaint)) {
    if (stored.isGood) continue;
    remove.bind(1, stored.corner.i);
    remove.bind(2, stored.corner.j);
    remove.step();
    if (!remove.isDone()) return rollBack();
    remove.reset();
    ++removed;
  }
  if (!run(file, "COMMIT")) return rollBack();
  if (!complaint.empty()) return tl::unexpected(complaint);
  return removed;
}

}  // namespace world_file
