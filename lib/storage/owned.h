// A pointer to a value of its own that is copied with it: so a class with values that must not move can be copied
// member by member.
#pragma once

#include <cassert>
#include <cstring>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace lgs::detail {

template <class T>
class Owned {
 public:
  Owned() = default;
  explicit Owned(std::unique_ptr<T> value) : value_(std::move(value)) {}
  Owned(const Owned& other) : value_(other.value_ ? copyOf(*other.value_) : nullptr) {}
  Owned(Owned&&) noexcept = default;
  Owned& operator=(const Owned& other) { return *this = Owned(other); }
  Owned& operator=(Owned&&) noexcept = default;
  ~Owned() = default;

  T* get() const { return value_.get(); }
  T& operator*() const {
    assert(value_);
    return *value_;
  }
  T* operator->() const { return value_.get(); }
  explicit operator bool() const { return value_ != nullptr; }

 private:
  /// Plain data may be a page of which only a part was ever written. Its bytes can be copied all the same.
  static std::unique_ptr<T> copyOf(const T& value) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      auto copy = std::make_unique_for_overwrite<T>();
      std::memcpy(copy.get(), &value, sizeof value);
      return copy;
    } else {
      return std::make_unique<T>(value);
    }
  }

  std::unique_ptr<T> value_;
};

/// Gives back the memory that a list can do without. GCC's shrink_to_fit() does nothing without exceptions.
template <class T>
void shrink(std::vector<T>& list) {
  std::vector<T>(std::make_move_iterator(list.begin()), std::make_move_iterator(list.end())).swap(list);
}

/// The same after a list has become shorter, once that is most of it. So what goes on with it at this length allocates
/// seldom.
template <class T>
void giveBackSpare(std::vector<T>& list) {
  constexpr std::size_t kLeast = 64;
  if (list.capacity() > kLeast && list.size() < list.capacity() / 4) shrink(list);
}

}  // namespace lgs::detail
