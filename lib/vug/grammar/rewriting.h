// One synchronous rewriting step of a word of any element type: the loop under L-systems.
#pragma once

#include <vug/base/error.h>
#include <vug/base/parallel.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vug::grammar {

/// The word in which every element is replaced by what `rewrite(word, index, out)` appends to the
/// vector `out`. Elements are rewritten in parallel, in fixed chunks that are joined in order, so
/// the result does not depend on the number of threads; rewrite may read the whole old word
/// (context) and must write only to `out`. Error(too_large) when more than `limit` elements come
/// out; a chunk alone is stopped there too, so that memory stays bounded.
template <class T, class Rewrite>
std::vector<T> rewrite_step(const std::vector<T>& word, const Rewrite& rewrite, int64_t limit,
                            size_t chunk = 4096) {
  const auto refuse = [limit] {
    throw Error(ErrorCode::too_large,
                "rewriting gives more than " + std::to_string(limit) + " symbols");
  };
  std::vector<std::vector<T>> parts((word.size() + chunk - 1) / chunk);
  parallel_for(parts.size(), [&](size_t p) {
    const size_t end = std::min(word.size(), (p + 1) * chunk);
    for (size_t i = p * chunk; i < end; ++i) {
      rewrite(word, i, parts[p]);
      if (static_cast<int64_t>(parts[p].size()) > limit) refuse();
    }
  });
  size_t total = 0;
  for (const auto& part : parts) total += part.size();
  if (static_cast<int64_t>(total) > limit) refuse();
  std::vector<T> out;
  out.reserve(total);
  for (auto& part : parts)
    out.insert(out.end(), std::make_move_iterator(part.begin()),
               std::make_move_iterator(part.end()));
  return out;
}

}  // namespace vug::grammar
