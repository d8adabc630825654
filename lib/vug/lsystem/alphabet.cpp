// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/lsystem/alphabet.h>

#include <fmt/format.h>

namespace vug::lsystem {

SymbolId Alphabet::add(std::string_view name, size_t parameters) {
  if (const auto known = find(name, parameters)) return *known;
  if (parameters > kMaxParameters)
    throw Error(ErrorCode::too_large,
                fmt::format("module '{}' has {} parameters", name, parameters), {},
                fmt::format("the maximum is {}", kMaxParameters));
  if (symbols_.size() >= kMaxSymbols)
    throw Error(ErrorCode::too_large, fmt::format("the alphabet has more than {} symbols", size()));
  const auto id = static_cast<SymbolId>(symbols_.size());
  symbols_.emplace_back(name, parameters);
  ids_.emplace(symbols_.back(), id);
  return id;
}

std::optional<SymbolId> Alphabet::find(std::string_view name, size_t parameters) const {
  const auto known = ids_.find(Symbol(name, parameters));
  return known == ids_.end() ? std::nullopt : std::optional(known->second);
}

}  // namespace vug::lsystem
