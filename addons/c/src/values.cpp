// Ids, errors and their sentences.
#include "inside.h"

#include <lgs/version.h>

#include <cstdint>
#include <string>

namespace lgs::c {
namespace {

constexpr lgs_error kNoError{
    LGS_OK, {INT32_MIN, INT32_MIN}, -1, -1, -1, -1, {0, 0}, 0, {0}, -1, 0, -1, {0, 0, 0},
};
constexpr lgs_status kFirstOfSnapshots = LGS_SAVE_NO_SNAPSHOT;

constexpr lgs_status statusOf(ErrorCode code) { return static_cast<lgs_status>(code); }
constexpr lgs_status statusOf(SnapshotError::What what) { return kFirstOfSnapshots + static_cast<lgs_status>(what); }

// Every number that both sides have is the same.
static_assert(kVersion == Version{LGS_VERSION_MAJOR, LGS_VERSION_MINOR, LGS_VERSION_PATCH});
static_assert(statusOf(ErrorCode::cellOutOfRange) == LGS_CELL_OUT_OF_RANGE);
static_assert(statusOf(ErrorCode::emptyShape) == LGS_EMPTY_SHAPE);
static_assert(statusOf(ErrorCode::tooFewVertices) == LGS_TOO_FEW_VERTICES);
static_assert(statusOf(ErrorCode::capacity) == LGS_CAPACITY);
static_assert(statusOf(ErrorCode::notFinite) == LGS_NOT_FINITE);
static_assert(statusOf(ErrorCode::outsideCell) == LGS_OUTSIDE_CELL);
static_assert(statusOf(ErrorCode::repeatedVertex) == LGS_REPEATED_VERTEX);
static_assert(statusOf(ErrorCode::zeroArea) == LGS_ZERO_AREA);
static_assert(statusOf(ErrorCode::selfIntersecting) == LGS_SELF_INTERSECTING);
static_assert(statusOf(ErrorCode::clockwise) == LGS_CLOCKWISE);
static_assert(statusOf(ErrorCode::overlap) == LGS_OVERLAP);
static_assert(statusOf(ErrorCode::unknownShape) == LGS_UNKNOWN_SHAPE);
static_assert(statusOf(ErrorCode::staleHandle) == LGS_STALE_HANDLE);
static_assert(statusOf(ErrorCode::unknownSegment) == LGS_UNKNOWN_SEGMENT);
static_assert(statusOf(ErrorCode::unknownMark) == LGS_UNKNOWN_MARK);
static_assert(statusOf(ErrorCode::uncommitted) == LGS_UNCOMMITTED);
static_assert(statusOf(ErrorCode::outOfReach) == LGS_OUT_OF_REACH);
static_assert(statusOf(ErrorCode::unloaded) == LGS_UNLOADED);
static_assert(statusOf(ErrorCode::anchored) == LGS_ANCHORED);
static_assert(statusOf(SnapshotError::What::notASnapshot) == LGS_SAVE_NO_SNAPSHOT);
static_assert(statusOf(SnapshotError::What::unknownVersion) == LGS_SAVE_UNKNOWN_VERSION);
static_assert(statusOf(SnapshotError::What::cut) == LGS_SAVE_CUT);
static_assert(statusOf(SnapshotError::What::damaged) == LGS_SAVE_DAMAGED);
static_assert(statusOf(SnapshotError::What::tooLong) == LGS_SAVE_TOO_LONG);
static_assert(statusOf(SnapshotError::What::relation) == LGS_SAVE_RELATION);
static_assert(statusOf(SnapshotError::What::badNumber) == LGS_SAVE_BAD_NUMBER);
static_assert(statusOf(SnapshotError::What::badPolygon) == LGS_SAVE_BAD_POLYGON);
static_assert(statusOf(SnapshotError::What::badSegments) == LGS_SAVE_BAD_SEGMENTS);
static_assert(statusOf(SnapshotError::What::capacity) == LGS_SAVE_CAPACITY);
static_assert(statusOf(SnapshotError::What::loaded) == LGS_SAVE_LOADED);
static_assert(statusOf(SnapshotError::What::otherBytes) == LGS_SAVE_OTHER_BYTES);
static_assert(kUnitsPerCell == LGS_UNITS_PER_CELL && kMaxCell == LGS_MAX_CELL && kMaxChunks == LGS_MAX_CHUNKS);
static_assert(kMaxVerticesPerCell == LGS_MAX_CELL_VERTICES && kMaxPolygonsPerCell == LGS_MAX_CELL_POLYGONS);
static_assert(kMaxEntries == LGS_MAX_ENTRIES && kMaxRadius == LGS_MAX_RADIUS && kMaxRay == LGS_MAX_RAY);

bool isOfWorld(lgs_status status) { return status >= LGS_CELL_OUT_OF_RANGE && status <= LGS_ANCHORED; }
bool isOfSnapshot(lgs_status status) { return status >= kFirstOfSnapshots && status <= LGS_SAVE_OTHER_BYTES; }

std::string sentence(const lgs_error& e) {
  if (e.code == LGS_OK) return "no error";
  if (e.code == LGS_BAD_ARGUMENT) return "an argument is NULL where it must not be, or a number that means nothing";
  if (e.code == LGS_SHORT_BUFFER) return "there is more than the buffer has room for";
  if (isOfSnapshot(e.code))
    return message(SnapshotError{static_cast<SnapshotError::What>(e.code - kFirstOfSnapshots), e.offset,
                                 static_cast<std::uint32_t>(e.index), static_cast<std::uint32_t>(e.index2)});
  if (!isOfWorld(e.code)) return "unknown error";
  return message(Error{.code = static_cast<ErrorCode>(e.code),
                       .cell = fromC(e.cell),
                       .polygon = e.polygon,
                       .vertex = e.vertex,
                       .vertex2 = e.vertex2,
                       .polygon2 = e.polygon2,
                       .other = fromC(e.other),
                       .otherBlock = e.other_block,
                       .segment = fromC(e.segment),
                       .index = e.index,
                       .index2 = e.index2});
}

/// Null for a number that is none of an id's: what is left of it would name something else.
constexpr std::uint32_t idOf(std::uint64_t stored) {
  return stored <= UINT32_MAX ? static_cast<std::uint32_t>(stored) : 0;
}

const char* nameOfSnapshot(lgs_status status) {
  switch (status) {
    case LGS_SAVE_NO_SNAPSHOT:
      return "no saved world";
    case LGS_SAVE_UNKNOWN_VERSION:
      return "saved by another version";
    case LGS_SAVE_CUT:
      return "cut";
    case LGS_SAVE_DAMAGED:
      return "damaged";
    case LGS_SAVE_TOO_LONG:
      return "too long";
    case LGS_SAVE_RELATION:
      return "another preserve relation";
    case LGS_SAVE_BAD_NUMBER:
      return "bad number";
    case LGS_SAVE_BAD_POLYGON:
      return "bad polygon";
    case LGS_SAVE_BAD_SEGMENTS:
      return "bad segments";
    case LGS_SAVE_LOADED:
      return "chunk is loaded";
    case LGS_SAVE_OTHER_BYTES:
      return "other bytes";
    default:
      return "saved world too large";
  }
}

}  // namespace

lgs_status refuse(lgs_status status, lgs_error* out) {
  if (out) {
    *out = kNoError;
    out->code = status;
  }
  return status;
}

lgs_status refuse(const SnapshotError& error, lgs_error* out) {
  const lgs_status status = refuse(statusOf(error.what), out);
  if (!out) return status;
  out->offset = error.offset;
  if (error.what != SnapshotError::What::unknownVersion) return status;
  out->index = static_cast<std::int32_t>(error.version);
  out->index2 = static_cast<std::int32_t>(error.newest);
  return status;
}

lgs_status refuse(const Error& e, lgs_error* out) {
  const lgs_status status = refuse(statusOf(e.code), out);
  if (!out) return status;
  out->cell = toC(e.cell);
  out->polygon = e.polygon;
  out->vertex = e.vertex;
  out->vertex2 = e.vertex2;
  out->polygon2 = e.polygon2;
  out->other = toC(e.other);
  out->other_block = e.otherBlock;
  out->segment = toC(e.segment);
  out->index = e.index;
  out->index2 = e.index2;
  return status;
}

}  // namespace lgs::c

using namespace lgs::c;

uint64_t lgs_store_shape(lgs_shape_id shape) noexcept { return shape.value; }
uint64_t lgs_store_polygon(lgs_polygon_id polygon) noexcept { return fromC(polygon).packed(); }
uint64_t lgs_store_segment(lgs_segment_id segment) noexcept { return segment.value; }
uint64_t lgs_store_mark(lgs_mark mark) noexcept { return mark.value; }
lgs_shape_id lgs_load_shape(uint64_t stored) noexcept { return {idOf(stored)}; }
lgs_polygon_id lgs_load_polygon(uint64_t stored) noexcept { return toC(lgs::PolygonHandle::unpack(stored)); }
lgs_segment_id lgs_load_segment(uint64_t stored) noexcept { return {idOf(stored)}; }
lgs_mark lgs_load_mark(uint64_t stored) noexcept { return {stored}; }

lgs_point lgs_lattice_point(lgs_double_point position) noexcept { return toC(lgs::latticePoint(fromC(position))); }
lgs_cell lgs_cell_at(lgs_point point) noexcept { return toC(lgs::cellAt(fromC(point))); }

const char* lgs_status_name(lgs_status status) noexcept {
  if (status == LGS_OK) return "fine";
  if (status == LGS_BAD_ARGUMENT) return "bad argument";
  if (status == LGS_SHORT_BUFFER) return "short buffer";
  if (isOfSnapshot(status)) return nameOfSnapshot(status);
  return lgs::name(isOfWorld(status) ? static_cast<lgs::ErrorCode>(status) : lgs::ErrorCode{});
}

lgs_status lgs_message(const lgs_error* error, char* buffer, size_t capacity, size_t* count) noexcept {
  if (!error || !isArray(buffer, capacity)) return LGS_BAD_ARGUMENT;
  const std::string text = sentence(*error);
  put(count, text.size());
  if (capacity != 0) {
    const std::size_t room = std::min(text.size(), capacity - 1);
    std::memcpy(buffer, text.data(), room);
    buffer[room] = '\0';
  }
  return text.size() < capacity ? LGS_OK : LGS_SHORT_BUFFER;
}

uint32_t lgs_version(void) noexcept {
  return std::uint32_t{LGS_VERSION_MAJOR} << 16 | std::uint32_t{LGS_VERSION_MINOR} << 8 | LGS_VERSION_PATCH;
}
