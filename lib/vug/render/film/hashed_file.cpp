// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/render/film/hashed_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace vug::render {
namespace {

constexpr uint64_t kDigestBytes = 16;
constexpr size_t kBuffer = 1 << 20;

}  // namespace

void HashedWriter::bytes(const void* data, size_t count) {
  const auto* from = static_cast<const char*>(data);
  buffer_.insert(buffer_.end(), from, from + count);
  if (buffer_.size() >= kBuffer) flush();
}

bool HashedWriter::finish() {
  flush();
  const Digest digest = hash_.finish();
  number(digest.high), number(digest.low);
  flush();
  out_.close();
  return !out_.fail();
}

void HashedWriter::flush() {
  hash_.add(buffer_.data(), buffer_.size());
  out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  buffer_.clear();
}

HashedReader::HashedReader(const std::filesystem::path& path, std::string what)
    : path_(path), what_(std::move(what)), in_(path, std::ios::binary) {
  if (const std::string why = unreadable_reason(path); !why.empty()) refuse(why);
  left_ = std::filesystem::file_size(path);
}

void HashedReader::refuse(const std::string& why) const {
  throw Error(ErrorCode::bad_input,
              fmt::format("cannot read the {} '{}': {}", what_, path_.string(), why));
}

void HashedReader::bytes(void* data, size_t count) {
  need(count);
  auto* to = static_cast<char*>(data);
  for (size_t copied = 0; copied < count;) {
    if (at_ == buffer_.size()) refill();
    const size_t some = std::min(count - copied, buffer_.size() - at_);
    std::memcpy(to + copied, buffer_.data() + at_, some);
    at_ += some, copied += some, left_ -= some;
  }
}

uint64_t HashedReader::left() const { return left_ - std::min(left_, kDigestBytes); }

void HashedReader::skip() {
  std::vector<char> some(kBuffer);
  while (left_ > kDigestBytes)
    bytes(some.data(), std::min<uint64_t>(some.size(), left_ - kDigestBytes));
}

void HashedReader::need(uint64_t count) const {
  if (count > left_) refuse("it is cut short");
}

void HashedReader::finish() {
  if (left_ != kDigestBytes) refuse("its content was changed");
  const Digest digest = hash_.finish();
  Digest stored;
  number(stored.high), number(stored.low);
  if (!(stored == digest)) refuse("its content was changed");
}

void HashedReader::refill() {
  const uint64_t some =
      left_ > kDigestBytes ? std::min<uint64_t>(kBuffer, left_ - kDigestBytes) : left_;
  buffer_.resize(some);
  at_ = 0;
  in_.read(buffer_.data(), static_cast<std::streamsize>(some));
  if (!in_) refuse(std::strerror(errno));
  if (left_ > kDigestBytes) hash_.add(buffer_.data(), some);
}

}  // namespace vug::render
