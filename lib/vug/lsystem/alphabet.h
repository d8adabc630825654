// SPDX-License-Identifier: Apache-2.0
// The symbols of an L-system, identified by name and number of parameters, as small ids.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vug::lsystem {

/// A name with a number of parameters: F and F(1) are two symbols.
using SymbolId = uint16_t;

class Alphabet {
 public:
  static constexpr size_t kMaxSymbols = 60000;
  static constexpr size_t kMaxParameters = 250;

  /// The id of the symbol, which is added if it is new. Ids count from 0 in the order of first use.
  /// Throws Error(too_large) beyond the limits above.
  SymbolId add(std::string_view name, size_t parameters);

  /// The id of the symbol, or nothing if it does not exist.
  std::optional<SymbolId> find(std::string_view name, size_t parameters) const;

  size_t size() const { return symbols_.size(); }
  const std::string& name(SymbolId id) const { return symbols_[id].first; }
  size_t parameters(SymbolId id) const { return symbols_[id].second; }

 private:
  using Symbol = std::pair<std::string, size_t>;

  std::vector<Symbol> symbols_;
  std::map<Symbol, SymbolId, std::less<>> ids_;
};

}  // namespace vug::lsystem
