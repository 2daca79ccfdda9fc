// What containers have allocated, and how they give it back.
#pragma once

#include <cstdint>
#include <iterator>
#include <vector>

namespace lgs::detail {

/// In bytes; not what their elements have.
template <class... Vectors>
std::uint64_t heldBytes(const Vectors&... vectors) {
  return (... + (vectors.capacity() * sizeof(typename Vectors::value_type)));
}

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
/// The same of a hash table.
template <class Table>
void giveBackBuckets(Table& table) {
  constexpr std::size_t kLeast = 64;
  if (table.bucket_count() > kLeast && table.size() < table.bucket_count() / 8) table.rehash(2 * table.size());
}
/// What a hash table has allocated, beside what its elements have.
template <class Table>
std::uint64_t tableBytes(const Table& table) {
  return table.bucket_count() * sizeof(void*) + table.size() * (sizeof(typename Table::value_type) + sizeof(void*));
}

}  // namespace lgs::detail
