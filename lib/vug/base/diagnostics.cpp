// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <utility>

namespace vug {

void Diagnostics::add(Diagnostic diagnostic) {
  if (diagnostic.severity == Severity::error) ++errors_;
  all_.push_back(std::move(diagnostic));
}

void Diagnostics::add(const Error& error, const SourceLocation& otherwise) {
  this->error(error.where().known() ? error.where() : otherwise, error.what(), error.hint());
}

void Diagnostics::error(SourceLocation where, std::string message, std::string hint) {
  add({Severity::error, std::move(where), std::move(message), std::move(hint)});
}

void Diagnostics::warning(SourceLocation where, std::string message, std::string hint) {
  add({Severity::warning, std::move(where), std::move(message), std::move(hint)});
}

void Diagnostics::append(const Diagnostics& other) {
  all_.insert(all_.end(), other.all_.begin(), other.all_.end());
  errors_ += other.errors_;
}

namespace {

/// Optimal string alignment distance: insertion, deletion, substitution, swap of neighbours.
size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<size_t>> d(a.size() + 1, std::vector<size_t>(b.size() + 1));
  for (size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates) {
  std::string best;
  size_t best_distance = std::max<size_t>(1, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    if (boost::algorithm::iequals(name, candidate)) return candidate;
    const size_t distance = edit_distance(name, candidate);
    const bool has_nothing_in_common = distance >= std::max(name.size(), candidate.size());
    if (distance < best_distance && !has_nothing_in_common) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string did_you_mean(const std::string& name, const std::vector<std::string>& candidates,
                         const std::string& otherwise) {
  const std::string near = nearest_name(name, candidates);
  return near.empty() ? otherwise : fmt::format("did you mean '{}'?", near);
}

std::string suggestion(const std::string& name, const std::vector<std::string>& candidates) {
  const std::string known = fmt::format("known: {}", fmt::join(candidates, ", "));
  return did_you_mean(name, candidates, candidates.empty() ? "" : known);
}

}  // namespace vug
