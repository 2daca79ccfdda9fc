// The marks of a world in order, and something that is kept for each: by the rules of rollBack() and redo().
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace lgs::oracle {

/// Whether the world can redo: commits, and chunks that come and go, do not matter. *Maybe* is where the documents
/// leave it open: after an edit that changed nothing, or that was undone.
enum class Redo : std::uint8_t { no, maybe, sure };

template <class T>
class Timeline {
 public:
  void mark(T what) {
    marks_.push_back(std::move(what));
    happened(Redo::maybe);
  }
  bool hasMarks() const { return !marks_.empty(); }
  bool hasAhead() const { return !ahead_.empty(); }
  std::size_t marks() const { return marks_.size(); }
  Redo redo() const { return redo_; }

  const std::vector<T>& behind() const { return marks_; }  ///< the oldest first
  const std::vector<T>& ahead() const { return ahead_; }   ///< the last one first

  /// The mark of this number, modulo how many there are.
  const T& at(std::uint32_t nth) const { return marks_[nth % marks_.size()]; }
  const T& ahead(std::uint32_t nth) const { return ahead_[nth % ahead_.size()]; }

  const T& back(std::uint32_t nth, bool keeps) {
    const std::size_t to = nth % marks_.size();
    if (keeps) {
      if (redo_ != Redo::sure) ahead_.clear();
      ahead_.insert(ahead_.end(), std::make_move_iterator(marks_.rbegin()),
                    std::make_move_iterator(marks_.rend() - static_cast<std::ptrdiff_t>(to) - 1));
      went_ = to;
      redo_ = Redo::sure;
    } else if (to < went_) {
      ahead_.clear();
    } else {
      redo_ = redo_ == Redo::sure && to == went_ ? Redo::sure : Redo::maybe;
    }
    marks_.resize(to + 1);
    return marks_.back();
  }

  /// Marks made since it rolled back are void, and those on the way are behind.
  const T& forward(std::uint32_t nth) {
    const std::size_t to = nth % ahead_.size();
    marks_.resize(went_ + 1);
    for (std::size_t k = ahead_.size(); k-- > to;) marks_.push_back(std::move(ahead_[k]));
    ahead_.resize(to);
    went_ = marks_.size() - 1;
    redo_ = Redo::sure;
    return marks_.back();
  }

  void forget(std::uint32_t nth) {
    const std::size_t at = nth % marks_.size();
    marks_.erase(marks_.begin() + static_cast<std::ptrdiff_t>(at));
    // Where it went may be a mark that is gone: what is ahead is given up for simplicity.
    if (at <= went_) ahead_.clear();
    if (marks_.empty()) ahead_.clear();
  }

  /// Calls visit(what) for what is kept for each mark, ahead or not.
  template <class Visit>
  void forEach(Visit&& visit) {
    for (auto* marks : {&marks_, &ahead_})
      for (T& what : *marks) visit(what);
  }

  /// Something else was done.
  void happened(Redo stillMay) {
    if (redo_ > stillMay) redo_ = stillMay;
  }

  /// A group was undone: it was so before it.
  void isUndone(Redo before) { redo_ = before == Redo::no ? Redo::no : Redo::maybe; }

  void clear() { *this = {}; }

 private:
  std::vector<T> marks_;
  std::vector<T> ahead_;  // the next one last
  std::size_t went_ = 0;  // the mark of the last roll-back or redo
  Redo redo_ = Redo::no;
};

}  // namespace lgs::oracle
