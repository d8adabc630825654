// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/exchange/crate_coding.h>

#include <fmt/format.h>
#include <lz4.h>

#include <algorithm>
#include <cstring>
#include <unordered_map>

namespace vug::exchange {
namespace {

static_assert(kCrateBlock == LZ4_MAX_INPUT_SIZE);
constexpr size_t kMostBlocks = 127;

template <class T>
void append_number(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

template <class T>
T number_at(std::string_view bytes, size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

void append_block(std::string& out, std::string_view bytes) {
  const int size = static_cast<int>(bytes.size());
  const size_t before = out.size();
  out.resize(before + static_cast<size_t>(LZ4_compressBound(size)));
  const int written = LZ4_compress_default(bytes.data(), out.data() + before, size,
                                           static_cast<int>(out.size() - before));
  out.resize(before + static_cast<size_t>(written));
}

/// Appends the contents of a block unless they are damaged or have more than `most` bytes.
bool decompress_block(std::string_view bytes, size_t most, std::string& out) {
  constexpr size_t kMostRatio = 255;  // of LZ4
  if (bytes.size() > static_cast<size_t>(LZ4_COMPRESSBOUND(LZ4_MAX_INPUT_SIZE))) return false;
  const size_t before = out.size(), room = std::min(most, kMostRatio * bytes.size());
  out.resize(before + room);
  const int got = LZ4_decompress_safe(bytes.data(), out.data() + before,
                                      static_cast<int>(bytes.size()), static_cast<int>(room));
  out.resize(before + static_cast<size_t>(std::max(got, 0)));
  return got >= 0;
}

uint32_t bits(int32_t number) { return static_cast<uint32_t>(number); }

/// The most frequent difference between successive numbers, and of several equally frequent ones
/// the largest. Differences beyond 16 bits are counted only if they are among the first such ones,
/// because a large mesh may have as many of them as indices.
int32_t most_frequent_difference(const int32_t* numbers, size_t count) {
  constexpr int32_t kLow = -(1 << 15), kHigh = (1 << 15) - 1;
  constexpr size_t kMostLarge = 1 << 16;
  std::vector<size_t> small(1 << 16);
  std::unordered_map<int32_t, size_t> large;
  int32_t best = 0;
  size_t most = 0;
  uint32_t before = 0;
  for (size_t i = 0; i < count; ++i) {
    const auto difference = static_cast<int32_t>(bits(numbers[i]) - before);
    before = bits(numbers[i]);
    size_t times = 0;
    if (difference >= kLow && difference <= kHigh) {
      times = ++small[static_cast<size_t>(difference - kLow)];
    } else {
      const auto found = large.find(difference);
      if (found != large.end())
        times = ++found->second;
      else if (large.size() < kMostLarge)
        times = large[difference] = 1;
    }
    if (times > most || (times == most && difference > best)) {
      most = times;
      best = difference;
    }
  }
  return best;
}

}  // namespace

std::string crate_compress(std::string_view bytes, size_t block) {
  std::string out(1, '\0');
  if (bytes.size() <= block) {
    append_block(out, bytes);
    return out;
  }
  const size_t blocks = (bytes.size() + block - 1) / block;
  if (blocks > kMostBlocks)
    throw Error(ErrorCode::too_large,
                fmt::format("an array of {} bytes exceeds the 127 blocks of a binary USD file",
                            bytes.size()),
                {}, "export to .usda, or build in tiles");
  out[0] = static_cast<char>(blocks);
  for (size_t at = 0; at < bytes.size(); at += block) {
    const size_t begin = out.size();
    append_number<int32_t>(out, 0);
    append_block(out, bytes.substr(at, block));
    const auto size = static_cast<int32_t>(out.size() - begin - sizeof(int32_t));
    std::memcpy(out.data() + begin, &size, sizeof size);
  }
  return out;
}

std::optional<std::string> crate_decompress(std::string_view bytes, size_t most, size_t block) {
  if (bytes.empty()) return std::nullopt;
  const int blocks = static_cast<unsigned char>(bytes[0]);
  bytes.remove_prefix(1);
  std::string out;
  if (blocks == 0) {
    if (!decompress_block(bytes, std::min(most, block), out)) return std::nullopt;
    return out;
  }
  for (int i = 0; i < blocks; ++i) {
    if (bytes.size() < sizeof(uint32_t)) return std::nullopt;
    const size_t size = number_at<uint32_t>(bytes, 0);
    bytes.remove_prefix(sizeof(uint32_t));
    if (size > bytes.size()) return std::nullopt;
    if (!decompress_block(bytes.substr(0, size), std::min(block, most - out.size()), out))
      return std::nullopt;
    bytes.remove_prefix(size);
  }
  return out;
}

std::string crate_encode_integers(const int32_t* numbers, size_t count) {
  std::string out;
  if (count == 0) return out;
  out.reserve(crate_encoded_size(count) / 2);
  const int32_t common = most_frequent_difference(numbers, count);
  append_number(out, common);
  const size_t codes = out.size();
  out.resize(codes + (count + 3) / 4);
  uint32_t before = 0;
  for (size_t i = 0; i < count; ++i) {
    const auto difference = static_cast<int32_t>(bits(numbers[i]) - before);
    before = bits(numbers[i]);
    int code = 0;
    if (difference == common) {
    } else if (difference >= INT8_MIN && difference <= INT8_MAX) {
      code = 1;
      append_number(out, static_cast<int8_t>(difference));
    } else if (difference >= INT16_MIN && difference <= INT16_MAX) {
      code = 2;
      append_number(out, static_cast<int16_t>(difference));
    } else {
      code = 3;
      append_number(out, difference);
    }
    out[codes + i / 4] = static_cast<char>(out[codes + i / 4] | code << (2 * (i % 4)));
  }
  return out;
}

std::optional<std::vector<int32_t>> crate_decode_integers(std::string_view bytes, size_t count) {
  std::vector<int32_t> out;
  if (count == 0) return out;
  const size_t codes = sizeof(int32_t);
  if (bytes.size() < codes || bytes.size() - codes < (count + 3) / 4) return std::nullopt;
  const uint32_t common = bits(number_at<int32_t>(bytes, 0));
  size_t at = codes + (count + 3) / 4;
  out.reserve(count);
  uint32_t value = 0;
  for (size_t i = 0; i < count; ++i) {
    const int code = (bytes[codes + i / 4] >> (2 * (i % 4))) & 3;
    const size_t size = code == 0 ? 0 : size_t{1} << (code - 1);
    if (bytes.size() - at < size) return std::nullopt;
    value += code == 0   ? common
             : code == 1 ? bits(number_at<int8_t>(bytes, at))
             : code == 2 ? bits(number_at<int16_t>(bytes, at))
                         : bits(number_at<int32_t>(bytes, at));
    at += size;
    out.push_back(static_cast<int32_t>(value));
  }
  return out;
}

}  // namespace vug::exchange
