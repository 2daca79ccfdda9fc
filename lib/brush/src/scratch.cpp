#include "scratch.h"

#include <algorithm>
#include <memory>

namespace lgs::brush {
namespace {

constexpr std::size_t kUsualSize = std::size_t{1} << 16;

struct Block {
  std::unique_ptr<std::byte[]> bytes;
  std::size_t size = 0;
};

struct Blocks {
  std::vector<Block> all;
  std::size_t current = 0;  ///< the one that memory is taken from
  std::size_t frames = 0;
};
#if defined(__wasm__) && !defined(_REENTRANT)
Blocks ofThread;  // there is one thread, and nothing reports its end
#else
thread_local Blocks ofThread;
#endif

}  // namespace

void* takeFromNextBlock(std::size_t bytes) {
  const std::size_t k = ofThread.all.empty() ? 0 : ofThread.current + 1;
  if (k == ofThread.all.size() || ofThread.all[k].size < bytes) {
    ofThread.all.resize(k);
    const std::size_t size = std::max(bytes, kUsualSize << std::min<std::size_t>(k, 8));
    ofThread.all.push_back({std::unique_ptr<std::byte[]>(new std::byte[size]), size});
  }
  ofThread.current = k;
  std::byte* const begin = ofThread.all[k].bytes.get();
  scratch = {begin + bytes, begin + ofThread.all[k].size};
  return begin;
}

Frame::Frame() {
  if (ofThread.all.empty()) takeFromNextBlock(0);
  ++ofThread.frames;
  block_ = ofThread.current;
  before_ = scratch;
}

Frame::~Frame() {
  ofThread.current = block_;
  scratch = before_;
  if (--ofThread.frames == 0) ofThread.all.resize(block_ + 1);
}

}  // namespace lgs::brush
