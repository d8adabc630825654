// SPDX-License-Identifier: Apache-2.0
// The key of a product in a store: the digest of everything that determines its bytes, by named
// parts.
#pragma once

#include <vug/base/digester.h>

#include <string>
#include <utility>
#include <vector>

namespace vug::store {

/// A kind of products. Its epoch increases whenever a change of the code changes the bytes of
/// products, so that products of earlier versions of the program are not reused.
struct ProductKind {
  std::string name;  ///< E.g. "level_set"; letters and "_".
  int epoch = 1;
};

/// The kind and the inputs of a product. Parts have names so that a difference between two keys can
/// be explained.
class Key {
 public:
  struct Part {
    std::string name;  ///< Without blanks.
    Digest digest;

    bool operator==(const Part&) const = default;
  };

  explicit Key(const ProductKind& kind) : kind_(kind.name) {
    parts_.push_back({"epoch", digest_of(kind.epoch)});
  }
  /// Adds an input; see Digester for the types of values.
  template <class... T>
  Key& add(std::string name, const T&... values) {
    parts_.push_back({std::move(name), digest_of(values...)});
    return *this;
  }

  const std::string& kind() const { return kind_; }
  const std::vector<Part>& parts() const { return parts_; }
  Digest digest() const { return digest_of(kind_, parts_); }

 private:
  std::string kind_;
  std::vector<Part> parts_;
};

/// The names of the parts of `now` that `before` lacks or that have another digest there.
std::vector<std::string> changed_parts(const std::vector<Key::Part>& before, const Key& now);

}  // namespace vug::store
