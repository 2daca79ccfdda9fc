// An index from 64-bit hashes to the numbers of things that are stored elsewhere: polygons, contents, chunks. It uses
// open addressing with linear probing. The number of places is a power of two; at most half of them are taken, and at
// least an eighth. Edits look things up all the time. Here that touches one cache line, while std::unordered_map
// follows pointers.
//
// An index can not be iterated over, so no order that is given out depends on where things are in it. That is why each
// index may have a seed of its own: hashes begin with it. Otherwise a stranger could choose chunks or polygons that all
// have the same place, and a small file would take long to load. It is no secret that withstands more than that.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lgs::detail {

/// Mixes one more word into a hash (the finaliser of MurmurHash3, Appleby 2011). With the same hash different words make
/// different ones, since each step can be undone.
constexpr std::uint64_t mix(std::uint64_t hash, std::uint64_t word) {
  std::uint64_t h = (hash ^ word) * 0xff51afd7ed558ccdULL;
  h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53ULL;
  return h ^ (h >> 33);
}

/// Another number in each run of the program, and for each index: of when and where it is made. WebAssembly has neither
/// a clock without an import nor places that differ; there it is always the same.
std::uint64_t anySeed(const void* where);

class HashIndex {
 public:
  HashIndex() : HashIndex(this) {}
  /// `where` is an object that is there already: of an index on the stack compilers think that it is read.
  explicit HashIndex(const void* where) : seed_(anySeed(where)) {}

  /// What the hashes of this index begin with. A copy has the same.
  std::uint64_t seed() const { return seed_; }

  static constexpr std::uint32_t kNone = 0xffff'ffff;

  /// The number that was inserted with this hash and for which `matches(number)` holds, or kNone.
  template <class Matches>
  std::uint32_t find(std::uint64_t hash, Matches&& matches) const {
    if (places_.empty()) return kNone;
    for (std::size_t at = home(hash);; at = (at + 1) & mask()) {
      const Place& place = places_[at];
      if (place.number == kNone) return kNone;
      if (place.hash == hash && matches(place.number)) return place.number;
    }
  }

  /// Adds a number that is not there yet.
  void insert(std::uint64_t hash, std::uint32_t number) {
    if (2 * (count_ + 1) > places_.size()) resize(places_.empty() ? kLeast : 2 * places_.size());
    place({number, hash});
    ++count_;
  }

  /// Removes a number that is there, and closes the gap that it leaves (Knuth, TAOCP 3, 6.4, Algorithm R).
  void erase(std::uint64_t hash, std::uint32_t number) {
    std::size_t gap = home(hash);
    for (; places_[gap].number != number; gap = (gap + 1) & mask()) assert(places_[gap].number != kNone);
    for (std::size_t at = (gap + 1) & mask(); places_[at].number != kNone; at = (at + 1) & mask()) {
      const std::size_t first = home(places_[at].hash);
      if (((at - first) & mask()) < ((at - gap) & mask())) continue;
      places_[gap] = places_[at];
      gap = at;
    }
    places_[gap] = Place{};
    --count_;
    if (places_.size() > kLeast && 8 * count_ < places_.size()) resize(places_.size() / 2);
  }

  std::uint64_t bytes() const { return places_.capacity() * sizeof(Place); }

 private:
  struct Place {
    std::uint32_t number = kNone;
    std::uint64_t hash = 0;
  };

  static constexpr std::size_t kLeast = 16;  ///< places, if there are any

  std::size_t mask() const { return places_.size() - 1; }
  /// The first place for a hash.
  std::size_t home(std::uint64_t hash) const { return static_cast<std::size_t>(hash) & mask(); }

  void place(const Place& entry) {
    std::size_t at = home(entry.hash);
    while (places_[at].number != kNone) at = (at + 1) & mask();
    places_[at] = entry;
  }

  void resize(std::size_t places) {
    std::vector<Place> old(places);
    old.swap(places_);
    for (const Place& entry : old)
      if (entry.number != kNone) place(entry);
  }

  std::uint64_t seed_;
  std::vector<Place> places_;
  std::size_t count_ = 0;
};

}  // namespace lgs::detail
