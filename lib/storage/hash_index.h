// An index from 64-bit hashes to the numbers of things that are stored elsewhere: polygons, contents, chunks, notes. It
// uses open addressing with linear probing. The number of places is a power of two; at most three quarters of them are
// taken, and, if they are many, at least an eighth. Edits look things up all the time. Here that touches one cache line,
// while std::unordered_map follows pointers.
//
// An index can not be iterated over, so no order that is given out depends on where things are in it. That is why its
// hashes may begin with a seed. Otherwise a stranger could choose chunks or polygons that all have the same place, and a
// small file would take long to load. It is no secret that withstands more than that.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
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
  /// Of several things with one hash `matches(number)` says which is meant. By default nothing else has that hash.
  struct Any {
    bool operator()(std::uint64_t /*number*/) const { return true; }
  };

  /// 0 if there is none.
  template <class Matches = Any>
  std::uint64_t find(std::uint64_t hash, Matches&& matches = {}) const {
    return places_.empty() ? 0 : places_[placeOf(hash, matches)].number;
  }

  /// The number is not 0. Returns the one that it displaces; 0 if it is one more.
  template <class Matches = Any>
  std::uint64_t set(std::uint64_t hash, std::uint64_t number, Matches&& matches = {}) {
    assert(number != 0);
    if (4 * (count_ + 1) > 3 * places_.size()) resize(places_.empty() ? kLeast : 2 * places_.size());
    Place& place = places_[placeOf(hash, matches)];
    count_ += place.number == 0;
    place.hash = hash;
    return std::exchange(place.number, number);
  }

  /// Removes what is there, and closes the gap that it leaves (Knuth, TAOCP 3, 6.4, Algorithm R).
  template <class Matches = Any>
  void erase(std::uint64_t hash, Matches&& matches = {}) {
    std::size_t gap = placeOf(hash, matches);
    assert(places_[gap].number != 0);
    for (std::size_t at = (gap + 1) & mask(); places_[at].number != 0; at = (at + 1) & mask()) {
      if (((at - home(places_[at].hash)) & mask()) < ((at - gap) & mask())) continue;
      places_[gap] = places_[at];
      gap = at;
    }
    places_[gap] = Place{};
    --count_;
    if (places_.size() > kFew && 8 * count_ < places_.size()) resize(places_.size() / 2);
  }

  std::size_t count() const { return count_; }
  std::uint64_t bytes() const { return places_.capacity() * sizeof(Place); }

 private:
  struct Place {
    std::uint64_t hash = 0;
    std::uint64_t number = 0;
  };
  static constexpr std::size_t kLeast = 16;   ///< places, if there are any
  static constexpr std::size_t kFew = 1'024;  ///< so many are kept, since groups of edits come and go

  std::size_t mask() const { return places_.size() - 1; }
  /// The first place for a hash.
  std::size_t home(std::uint64_t hash) const { return static_cast<std::size_t>(hash) & mask(); }
  /// Where a thing is, or where there is room for it.
  template <class Matches>
  std::size_t placeOf(std::uint64_t hash, Matches& matches) const {
    std::size_t at = home(hash);
    while (places_[at].number != 0 && !(places_[at].hash == hash && matches(places_[at].number)))
      at = (at + 1) & mask();
    return at;
  }
  void resize(std::size_t places) {
    std::vector<Place> old(places);
    old.swap(places_);
    const auto isOther = [](std::uint64_t /*number*/) { return false; };
    for (const Place& place : old)
      if (place.number != 0) places_[placeOf(place.hash, isOther)] = place;
  }

  std::vector<Place> places_;
  std::size_t count_ = 0;
};

}  // namespace lgs::detail
