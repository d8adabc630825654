// SPDX-License-Identifier: Apache-2.0
// Content hashes (XXH3, 128 bits) that identify grids, files and cached products.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace vug {

struct Digest {
  uint64_t high = 0;
  uint64_t low = 0;
  bool operator==(const Digest&) const = default;
  std::string hex() const;  ///< 32 hexadecimal digits.
};

Digest digest(const void* data, size_t bytes);
Digest digest(std::string_view text);

/// Incremental digest of data that arrives in parts.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(Hasher&&) noexcept;
  Hasher& operator=(Hasher&&) noexcept;

  Hasher& add(const void* data, size_t bytes);
  Hasher& add(std::string_view text);
  template <class T>
  Hasher& add_value(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    return add(&value, sizeof value);
  }
  Digest finish() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vug
