// SPDX-License-Identifier: Apache-2.0
// The declarations that an evaluation uses.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vug::scene {

/// Kind and name of a declaration.
using DeclarationName = std::pair<std::string, std::string>;

/// Declarations, each once, in the order of their first use.
class DeclarationUses {
 public:
  void add(const DeclarationName& used) {
    if (known_.insert(used).second) list_.push_back(used);
  }
  void add(const std::vector<DeclarationName>& used) {
    for (const DeclarationName& each : used) add(each);
  }
  const std::vector<DeclarationName>& list() const { return list_; }

 private:
  std::vector<DeclarationName> list_;
  std::set<DeclarationName> known_;
};

}  // namespace vug::scene
