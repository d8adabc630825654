// SPDX-License-Identifier: Apache-2.0
// Visits the members of plain structs without naming them, so that code that must consider every
// member cannot miss one that is added later.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

namespace vug {

namespace detail {

/// Converts to any type but S, in unevaluated operands only.
template <class S>
struct AnyMember {
  template <class T>
  requires(!std::is_same_v<T, S>) operator T() const {  // NOLINT: the conversion is the purpose
    __builtin_unreachable();
  }
};

template <class S, size_t... I>
constexpr bool takes(std::index_sequence<I...>) {
  return requires { S{(static_cast<void>(I), AnyMember<S>{})...}; };
}

inline constexpr size_t kMostMembers = 24;

template <class S, size_t N = kMostMembers>
constexpr size_t member_count() {
  if constexpr (N == 0)
    return 0;
  else if constexpr (takes<S>(std::make_index_sequence<N>()))
    return N;
  else
    return member_count<S, N - 1>();
}

}  // namespace detail

/// Calls visit(members...) with all members of an aggregate of at most 24 members. A base class
/// with members and arrays of C are not supported and do not compile.
template <class S, class Visit>
void visit_members(const S& s, Visit&& visit) {
  static_assert(std::is_aggregate_v<S>);
  constexpr size_t kCount = detail::member_count<S>();
  // clang-format off
  if constexpr (kCount == 0) { static_cast<void>(s); visit(); }
  else if constexpr (kCount == 1) { const auto& [a] = s; visit(a); }
  else if constexpr (kCount == 2) { const auto& [a, b] = s; visit(a, b); }
  else if constexpr (kCount == 3) { const auto& [a, b, c] = s; visit(a, b, c); }
  else if constexpr (kCount == 4) { const auto& [a, b, c, d] = s; visit(a, b, c, d); }
  else if constexpr (kCount == 5) { const auto& [a, b, c, d, e] = s; visit(a, b, c, d, e); }
  else if constexpr (kCount == 6) { const auto& [a, b, c, d, e, f] = s; visit(a, b, c, d, e, f); }
  else if constexpr (kCount == 7) { const auto& [a, b, c, d, e, f, g] = s; visit(a, b, c, d, e, f, g); }
  else if constexpr (kCount == 8) { const auto& [a, b, c, d, e, f, g, h] = s; visit(a, b, c, d, e, f, g, h); }
  else if constexpr (kCount == 9) { const auto& [a, b, c, d, e, f, g, h, i] = s; visit(a, b, c, d, e, f, g, h, i); }
  else if constexpr (kCount == 10) { const auto& [a, b, c, d, e, f, g, h, i, j] = s; visit(a, b, c, d, e, f, g, h, i, j); }
  else if constexpr (kCount == 11) { const auto& [a, b, c, d, e, f, g, h, i, j, k] = s; visit(a, b, c, d, e, f, g, h, i, j, k); }
  else if constexpr (kCount == 12) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l] = s; visit(a, b, c, d, e, f, g, h, i, j, k, l); }
  else if constexpr (kCount == 13) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = s; visit(a, b, c, d, e, f, g, h, i, j, k, l, m); }
  else if constexpr (kCount == 14) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = s; visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n); }
  else if constexpr (kCount == 15) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = s; visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o); }
  else if constexpr (kCount == 16) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = s; visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p); }
  else if constexpr (kCount == 17) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q] = s; visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q); }
  else if constexpr (kCount == 18) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r] = s; visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r); }
  else if constexpr (kCount == 19) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t] = s; visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t); }
  else if constexpr (kCount == 20) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t, u] = s; visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t, u); }
  else if constexpr (kCount == 21) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t, u, v] = s; visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t, u, v); }
  else if constexpr (kCount == 22) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t, u, v, w] = s; visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t, u, v, w); }
  else if constexpr (kCount == 23) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t, u, v, w, x] = s; visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t, u, v, w, x); }
  else if constexpr (kCount == 24) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t, u, v, w, x, y] = s; visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t, u, v, w, x, y); }
  // clang-format on
}

}  // namespace vug
