// A table from 64-bit keys to 64-bit numbers, where 0 stands for none. As in HashIndex there is open addressing with
// linear probing, hashes begin with a seed, and it can not be iterated over. At most three quarters of the places are taken,
// since marks may be held for long.
#pragma once

#include "storage/hash_index.h"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace lgs::detail {

class Newest {
 public:
  /// 0 if there is none.
  std::uint64_t find(std::uint64_t key) const { return entries_.empty() ? 0 : entries_[placeOf(key)].number; }

  /// The number is not 0, nor is the key. Returns what it displaces.
  std::uint64_t set(std::uint64_t key, std::uint64_t number) {
    assert(key != 0 && number != 0);
    if (4 * (count_ + 1) > 3 * entries_.size()) resize(entries_.empty() ? kLeast : 2 * entries_.size());
    Entry& entry = entries_[placeOf(key)];
    count_ += entry.number == 0;
    entry.key = key;
    return std::exchange(entry.number, number);
  }

  /// A key that has a number. The gap is closed as in HashIndex.
  void erase(std::uint64_t key) {
    std::size_t gap = placeOf(key);
    assert(entries_[gap].number != 0);
    for (std::size_t at = (gap + 1) & mask(); entries_[at].number != 0; at = (at + 1) & mask()) {
      if (distance(home(entries_[at].key), at) < distance(gap, at)) continue;
      entries_[gap] = entries_[at];
      gap = at;
    }
    entries_[gap] = Entry{};
    --count_;
    if (entries_.size() > kFew && 8 * count_ < entries_.size()) resize(entries_.size() / 2);
  }

  std::size_t count() const { return count_; }
  std::uint64_t bytes() const { return entries_.capacity() * sizeof(Entry); }

 private:
  struct Entry {
    std::uint64_t key = 0;
    std::uint64_t number = 0;
  };
  static constexpr std::size_t kLeast = 64;   ///< places, if there are any
  static constexpr std::size_t kFew = 1'024;  ///< so many are kept, since groups of edits come and go

  std::size_t mask() const { return entries_.size() - 1; }
  std::size_t home(std::uint64_t key) const { return static_cast<std::size_t>(mix(seed_, key)) & mask(); }
  /// From one place on to another one.
  std::size_t distance(std::size_t from, std::size_t to) const { return (to + entries_.size() - from) & mask(); }
  /// Where a key is, or where there is room for it.
  std::size_t placeOf(std::uint64_t key) const {
    std::size_t at = home(key);
    while (entries_[at].number != 0 && entries_[at].key != key) at = (at + 1) & mask();
    return at;
  }
  void resize(std::size_t places) {
    std::vector<Entry> old(places);
    old.swap(entries_);
    for (const Entry& entry : old)
      if (entry.number != 0) entries_[placeOf(entry.key)] = entry;
  }

  std::uint64_t seed_ = anySeed(this);
  std::vector<Entry> entries_;
  std::size_t count_ = 0;
};

}  // namespace lgs::detail
