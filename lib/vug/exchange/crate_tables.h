// SPDX-License-Identifier: Apache-2.0
// The tables of a crate file that is being written: tokens, strings, fields,
// sets of fields and paths, each entry once.
#pragma once

#include <vug/exchange/crate_format.h>

#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vug::exchange {

/// Texts, which others refer to by index.
class CrateTokens {
 public:
  /// Index 0 cannot be the name of a property, because the indices of those are negated in PATHS.
  CrateTokens() { token(";-)"); }

  /// Throws Error(bad_input) for a text with a zero byte, which ends tokens; Error(too_large).
  uint32_t token(const std::string& text);
  /// The index of a string, which is an index of a token.
  uint32_t string(const std::string& text);

  const std::vector<const std::string*>& tokens() const { return tokens_; }
  const std::vector<uint32_t>& strings() const { return strings_; }

 private:
  std::unordered_map<std::string, uint32_t> token_of_;
  std::vector<const std::string*> tokens_;
  std::unordered_map<uint32_t, uint32_t> string_of_;
  std::vector<uint32_t> strings_;
};

/// Fields, and sets of them.
class CrateFields {
 public:
  using Set = std::vector<std::pair<uint32_t, CrateRep>>;  ///< Tokens of names, and values.

  /// The position of the set in FIELDSETS. Throws Error(too_large).
  uint32_t add(const Set& set);

  const Set& fields() const { return fields_; }
  /// The indices of the fields of all sets, each set ended by -1.
  const std::vector<int32_t>& sets() const { return sets_; }

 private:
  std::map<std::pair<uint32_t, CrateRep>, int32_t> index_of_;
  Set fields_;
  std::map<std::vector<int32_t>, uint32_t> set_of_;
  std::vector<int32_t> sets_;
};

/// Paths as a tree of elements: prims, variants "{SET=VARIANT}" and properties.
class CratePaths {
 public:
  explicit CratePaths(CrateTokens& tokens) : tokens_(tokens) { nodes_.push_back({}); }

  static constexpr uint32_t kRoot = 0;
  /// The path of an element below another path. Throws Error(too_large).
  uint32_t child(uint32_t parent, const std::string& element, bool property = false);
  /// The path that a text such as "/cave/materials/rock.outputs:surface" names.
  uint32_t path(std::string_view text);
  /// The empty path, which PATHS does not contain.
  uint32_t empty();

  /// The number of paths, with the empty one.
  size_t size() const { return nodes_.size(); }
  /// The tree in depth-first order, as in PATHS: the index of a path, the token of its last
  /// element, negated for properties, and the next entry: -2 for a leaf without a following
  /// sibling, -1 for a child without one, 0 for a sibling, else the distance of the sibling behind
  /// the children.
  struct Encoded {
    std::vector<int32_t> paths, elements, jumps;
  };
  Encoded encode() const;

 private:
  struct Node {
    uint32_t token = 0;
    bool property = false;
    std::vector<uint32_t> children = {};
  };
  void encode(uint32_t node, bool has_sibling, Encoded& out) const;

  CrateTokens& tokens_;
  std::vector<Node> nodes_;
  std::map<std::pair<uint32_t, int64_t>, uint32_t> child_of_;
  uint32_t empty_ = 0;
};

}  // namespace vug::exchange
