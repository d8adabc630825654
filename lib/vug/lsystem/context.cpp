// SPDX-License-Identifier: Apache-2.0
#include <vug/lsystem/context.h>

#include <algorithm>

namespace vug::lsystem {

ContextMatcher::ContextMatcher(const System& system, const Word& word, bool contexts)
    : system_(system), word_(word) {
  if (!contexts) return;
  const size_t size = word.size();
  const auto nothing = static_cast<uint32_t>(size);
  partner_.assign(size, nothing);
  left_.resize(size);
  std::vector<std::pair<uint32_t, uint32_t>> open;  // brackets with their left neighbours
  uint32_t last = nothing;
  for (uint32_t i = 0; i < size; ++i) {
    left_[i] = last;
    if (opens(i)) {
      open.emplace_back(i, last);
    } else if (closes(i)) {
      if (open.empty()) continue;
      partner_[i] = open.back().first;
      partner_[open.back().first] = i;
      last = open.back().second;  // skips the side branch
      open.pop_back();
    } else if (!ignored(i)) {
      last = i;
    }
  }
  right_.resize(size + 1);
  right_[size] = nothing;
  for (size_t i = size; i-- > 0;) {
    right_[i] = static_cast<uint32_t>(i);
    if (ignored(i)) right_[i] = right_[i + 1];
    if (opens(i)) right_[i] = partner_[i] < size ? right_[partner_[i] + 1] : nothing;
  }
}

double* ContextMatcher::put(size_t i, double* formals) const {
  const std::span<const double> given = word_.parameters(i);
  return std::copy(given.begin(), given.end(), formals);
}

bool ContextMatcher::left(const Production& production, size_t i, double*& formals) const {
  // Matched from right to left, but numbered from left to right.
  size_t values = 0;
  for (const ContextModule& wanted : production.left)
    values += system_.alphabet.parameters(wanted.symbol);
  double* place = formals += values;
  size_t at = i;
  for (size_t k = production.left.size(); k-- > 0;) {
    const SymbolId wanted = production.left[k].symbol;
    at = left_[at];
    if (at == word_.size() || word_.symbol(at) != wanted) return false;
    place -= system_.alphabet.parameters(wanted);
    put(at, place);
  }
  return true;
}

/// Matches the pattern [from, to) against the modules starting at `at`.
bool ContextMatcher::right(const std::vector<ContextModule>& pattern, size_t from, size_t to,
                           size_t at, double*& formals) const {
  for (size_t k = from; k < to;) {
    if (pattern[k].kind == ContextModule::Kind::open) {
      size_t end = k + 1;  // end of the pattern's branch
      for (int depth = 1; depth > 0; ++end)
        depth += pattern[end].kind == ContextModule::Kind::open    ? 1
                 : pattern[end].kind == ContextModule::Kind::close ? -1
                                                                   : 0;
      double* const before = formals;
      bool found = false;
      for (; !found && at < word_.size() && (opens(at) || ignored(at)); ++at) {
        if (!opens(at)) continue;
        formals = before;
        found = right(pattern, k + 1, end - 1, at + 1, formals);
        at = partner_[at];
      }
      if (!found) return false;
      k = end;
      continue;
    }
    at = right_[std::min(at, word_.size())];
    if (at >= word_.size() || closes(at) || word_.symbol(at) != pattern[k].symbol) return false;
    formals = put(at++, formals);
    ++k;
  }
  return true;
}

bool ContextMatcher::match(const Production& production, size_t i, double* formals) const {
  if (!left(production, i, formals)) return false;
  formals = put(i, formals);
  return right(production.right, 0, production.right.size(), i + 1, formals);
}

}  // namespace vug::lsystem
