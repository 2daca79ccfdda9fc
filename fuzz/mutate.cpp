#include "fuzz/mutate.h"

#include <algorithm>

namespace lgs::fuzz {
namespace {

using oracle::Random;

std::uint8_t randomByte(Random& random) { return static_cast<std::uint8_t>(random.below(256)); }

std::ptrdiff_t offset(std::size_t n) { return static_cast<std::ptrdiff_t>(n); }

void mutateRecords(Buffer& input, std::size_t maxSize, Random& random) {
  constexpr std::size_t kHeader = kRecord;
  input.resize(std::max((input.size() + kRecord - 1) / kRecord, std::size_t{1}) * kRecord);
  const std::size_t count = input.size() / kRecord - 1;
  const auto at = [&](std::size_t record) { return kHeader + record * kRecord; };
  const auto insert = [&](std::size_t before, const Buffer& record) {
    input.insert(input.begin() + offset(at(before)), record.begin(), record.end());
  };
  const auto copyOf = [&](std::size_t record) {
    return Buffer(input.begin() + offset(at(record)), input.begin() + offset(at(record) + kRecord));
  };
  const auto fresh = [&] {
    Buffer record(kRecord);
    for (std::uint8_t& byte : record) byte = randomByte(random);
    return record;
  };
  const std::size_t k = count == 0 ? 0 : random.below(count);
  const std::size_t m = count == 0 ? 0 : random.below(count);
  switch (count == 0 ? 0 : random.below(10)) {
    case 0:
    case 1:
      insert(k, fresh());
      break;
    case 2:
      insert(m, copyOf(k));
      break;
    case 3:
      input.erase(input.begin() + offset(at(k)), input.begin() + offset(at(k) + kRecord));
      break;
    case 4:
      std::swap_ranges(input.begin() + offset(at(k)), input.begin() + offset(at(k) + kRecord),
                       input.begin() + offset(at(m)));
      break;
    case 5:  // the same choice
    case 6: {
      const std::size_t choice = random.below(kRecord);
      input[at(k) + choice] = input[at(m) + choice];
      break;
    }
    case 7:
      input[random.below(5U)] = randomByte(random);
      break;
    default:
      input[at(k) + random.below(random.chance(50) ? std::size_t{4} : kRecord)] = randomByte(random);
      break;
  }
  if (input.size() > maxSize) input.resize(maxSize);
}

void mutateText(std::span<const std::string_view> words, Buffer& input, std::size_t maxSize, Random& random) {
  const std::size_t begin = random.below(input.size() + 1);
  const std::size_t length = std::min(random.below(std::size_t{24}) + 1, input.size() - begin);
  const auto first = input.begin() + offset(begin);
  switch (random.below(6)) {
    case 0:
    case 1: {
      const std::string_view word = words[random.below(words.size())];
      input.insert(first, word.begin(), word.end());
      break;
    }
    case 2:
      input.erase(first, first + offset(length));
      break;
    case 3: {
      const Buffer piece(first, first + offset(length));
      input.insert(input.begin() + offset(random.below(input.size() + 1)), piece.begin(), piece.end());
      break;
    }
    case 4: {
      const std::string_view word = words[random.below(words.size())];
      const auto hole = input.erase(first, first + offset(length));
      input.insert(hole, word.begin(), word.end());
      break;
    }
    default:
      if (length == 0) break;
      *first = random.chance(50) ? randomByte(random) : static_cast<std::uint8_t>('0' + random.below(10));
      break;
  }
  if (input.size() > maxSize) input.resize(maxSize);
}

}  // namespace

void mutate(const Target& target, Buffer& input, std::size_t maxSize, Random& random) {
  for (int times = 1 + random.below(4); times > 0; --times) {
    if (target.words.empty()) {
      mutateRecords(input, maxSize, random);
    } else {
      mutateText(target.words, input, maxSize, random);
    }
  }
}

}  // namespace lgs::fuzz
