// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/lsystem/resize_uninitialized.h>
#include <vug/lsystem/word.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

namespace vug::lsystem {

namespace {

void require_capacity(size_t values) {
  if (values > std::numeric_limits<uint32_t>::max())
    throw Error(ErrorCode::too_large, "the word has more than 2^32 parameters");
}

}  // namespace

void Word::append(SymbolId symbol, std::span<const double> parameters) {
  require_capacity(values_.size() + parameters.size());
  symbols_.push_back(symbol);
  values_.insert(values_.end(), parameters.begin(), parameters.end());
  starts_.push_back(static_cast<uint32_t>(values_.size()));
}

void Word::append(const Word& other) {
  require_capacity(values_.size() + other.values_.size());
  const auto base = static_cast<uint32_t>(values_.size());
  symbols_.insert(symbols_.end(), other.symbols_.begin(), other.symbols_.end());
  values_.insert(values_.end(), other.values_.begin(), other.values_.end());
  starts_.reserve(starts_.size() + other.size());
  for (size_t i = 1; i < other.starts_.size(); ++i) starts_.push_back(base + other.starts_[i]);
}

void Word::clear() {
  symbols_.clear();
  starts_.assign(1, 0);
  values_.clear();
}

void Word::resize(size_t modules, size_t values) {
  require_capacity(values);
  resize_uninitialized(symbols_, modules);
  resize_uninitialized(starts_, modules + 1);
  resize_uninitialized(values_, values);
}

std::string to_string(const Word& word, const Alphabet& alphabet, size_t begin, size_t end) {
  std::string out;
  const auto to = std::back_inserter(out);
  for (size_t i = begin; i < end; ++i) {
    out += alphabet.name(word.symbol(i));
    const std::span<const double> parameters = word.parameters(i);
    for (size_t p = 0; p < parameters.size(); ++p)
      fmt::format_to(to, "{}{}", p == 0 ? '(' : ',', parameters[p]);
    if (!parameters.empty()) out += ')';
  }
  return out;
}

std::string to_string(const Word& word, const Alphabet& alphabet) {
  return to_string(word, alphabet, 0, word.size());
}

}  // namespace vug::lsystem
