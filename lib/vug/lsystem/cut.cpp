// SPDX-License-Identifier: Apache-2.0
#include <vug/lsystem/cut.h>

#include <algorithm>

namespace vug::lsystem {

void cut_branches(const System& system, Derivation& derivation) {
  const Word& word = derivation.word;
  const std::span<const SymbolId> symbols = word.symbols();
  if (std::find(symbols.begin(), symbols.end(), *system.cut) == symbols.end()) return;
  Derivation kept;
  kept.key = derivation.key;
  for (size_t i = 0; i < word.size(); ++i) {
    if (word.symbol(i) == system.cut) {
      // Skip to the bracket that closes this branch, which is kept.
      for (int depth = 0; i < word.size(); ++i) {
        if (word.symbol(i) == system.open) ++depth;
        if (word.symbol(i) == system.close && --depth < 0) break;
      }
      if (i == word.size()) break;
    }
    kept.word.append(word[i]);
    if (!derivation.keys.empty()) kept.keys.push_back(derivation.keys[i]);
  }
  derivation = std::move(kept);
}

}  // namespace vug::lsystem
