#include "hash.h"

namespace platform {

void put(Hash& hash, const lgs::Error& error) {
  hash.number(static_cast<std::uint32_t>(error.code));
  put(hash, error.cell);
  for (const std::int32_t number :
       {error.polygon, error.vertex, error.vertex2, error.polygon2, error.index, error.index2})
    hash.sign(number);
  put(hash, error.other);
  hash.number(error.otherBlock);
  put(hash, error.segment);
  hash.text(lgs::message(error));
}

void put(Hash& hash, const lgs::Segment& segment) {
  for (const lgs::SegmentId id : {segment.id, segment.predecessor, segment.successor}) put(hash, id);
  for (const lgs::Point point : {segment.start, segment.end}) put(hash, point);
  if (segment.predecessor) put(hash, segment.ghost1);
  if (segment.successor) put(hash, segment.ghost2);
  hash.number(segment.block);
  put(hash, segment.polygon);
  put(hash, segment.cell);
}

void put(Hash& hash, const oracle::ChangeLists& changes) {
  putAll(hash, changes.removed);
  putAll(hash, changes.added);
  putAll(hash, changes.relinked);
}

void put(Hash& hash, const oracle::Outcome& outcome) {
  hash.byte(outcome.refusal ? 0 : 1);
  if (outcome.refusal) put(hash, *outcome.refusal);
  put(hash, outcome.shape);
  putAll(hash, outcome.told);
  putAll(hash, outcome.handles);
  hash.number(outcome.count);
  put(hash, outcome.changes);
  putAll(hash, outcome.parts);
}

}  // namespace platform
