#include <vug/lsystem/context.h>

#include <algorithm>

namespace vug::lsystem {

Surroundings::Surroundings(const System& system, const Word& word, bool contexts)
    : system_(system), word_(word) {
  if (!contexts || !system.open || !system.close) return;
  partner_.resize(word.size());
  std::vector<uint32_t> open;
  for (size_t i = 0; i < word.size(); ++i) {
    if (opens(i)) {
      partner_[i] = static_cast<uint32_t>(word.size());
      open.push_back(static_cast<uint32_t>(i));
    } else if (closes(i) && !open.empty()) {
      partner_[i] = open.back();
      partner_[open.back()] = static_cast<uint32_t>(i);
      open.pop_back();
    }
  }
}

double* Surroundings::put(size_t i, double* formals) const {
  const std::span<const double> given = word_.parameters(i);
  return std::copy(given.begin(), given.end(), formals);
}

bool Surroundings::left(const Production& production, size_t i, double*& formals) const {
  // Found from right to left, but numbered from left to right.
  size_t values = 0;
  for (const ContextModule& wanted : production.left)
    values += system_.alphabet.parameters(wanted.symbol);
  double* place = formals += values;
  size_t at = i;
  for (size_t k = production.left.size(); k-- > 0;) {
    for (;; --at) {
      if (at == 0) return false;
      const size_t before = at - 1;
      if (closes(before)) {
        at = partner_[before] + 1;  // past a side branch: on to what stands before its bracket
        continue;
      }
      if (!opens(before) && !unseen(before)) break;
    }
    --at;
    const SymbolId wanted = production.left[k].symbol;
    if (word_.symbol(at) != wanted) return false;
    place -= system_.alphabet.parameters(wanted);
    put(at, place);
  }
  return true;
}

/// The pattern from `from` up to `to` against what follows from module `at` on.
bool Surroundings::right(const std::vector<ContextModule>& pattern, size_t from, size_t to,
                         size_t at, double*& formals) const {
  for (size_t k = from; k < to;) {
    if (pattern[k].kind == ContextModule::Kind::open) {
      size_t end = k + 1;  // of the pattern's branch
      for (int depth = 1; depth > 0; ++end)
        depth += pattern[end].kind == ContextModule::Kind::open    ? 1
                 : pattern[end].kind == ContextModule::Kind::close ? -1
                                                                   : 0;
      double* const before = formals;
      bool found = false;
      for (; !found && at < word_.size() && (opens(at) || unseen(at)); ++at) {
        if (!opens(at)) continue;
        formals = before;
        found = right(pattern, k + 1, end - 1, at + 1, formals);
        at = partner_[at];
      }
      if (!found) return false;
      k = end;
      continue;
    }
    while (at < word_.size() && (unseen(at) || opens(at)))
      at = opens(at) ? partner_[at] + 1 : at + 1;
    if (at >= word_.size() || closes(at) || word_.symbol(at) != pattern[k].symbol) return false;
    formals = put(at++, formals);
    ++k;
  }
  return true;
}

bool Surroundings::match(const Production& production, size_t i, double* formals) const {
  if (!left(production, i, formals)) return false;
  formals = put(i, formals);
  return right(production.right, 0, production.right.size(), i + 1, formals);
}

}  // namespace vug::lsystem
