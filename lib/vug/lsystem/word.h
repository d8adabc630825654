// SPDX-License-Identifier: Apache-2.0
// Words: strings of modules, each a symbol with numeric parameters. Brackets, cuts and polygons are
// modules like all others, named as in ABOP: "[", "]", "%", "{", "}", ".".
#pragma once

#include <vug/base/uninitialized_vector.h>
#include <vug/lsystem/alphabet.h>

#include <span>
#include <string>

namespace vug::lsystem {

/// One module of a word; valid while the word is unchanged.
struct Module {
  SymbolId symbol;
  std::span<const double> parameters;  ///< In base units: metres, radians, seconds.
};

/// A word as a structure of arrays: symbols, offsets of their parameters, and all parameters. A
/// value type.
class Word {
 public:
  size_t size() const { return symbols_.size(); }
  bool empty() const { return symbols_.empty(); }

  SymbolId symbol(size_t i) const { return symbols_[i]; }
  std::span<const double> parameters(size_t i) const {
    return {values_.data() + starts_[i], values_.data() + starts_[i + 1]};
  }
  std::span<double> parameters(size_t i) {
    return {values_.data() + starts_[i], values_.data() + starts_[i + 1]};
  }
  Module operator[](size_t i) const { return {symbols_[i], parameters(i)}; }

  void append(SymbolId symbol, std::span<const double> parameters = {});
  void append(const Module& module) { append(module.symbol, module.parameters); }
  /// All modules of another word of the same alphabet.
  void append(const Word& other);
  void clear();

  /// The arrays: symbols; the start of each module's parameters in `values`, followed by the end of
  /// the last; and the parameters of all modules in order.
  std::span<const SymbolId> symbols() const { return symbols_; }
  std::span<const uint32_t> starts() const { return starts_; }
  std::span<const double> values() const { return values_; }
  std::span<SymbolId> symbols() { return symbols_; }
  std::span<uint32_t> starts() { return starts_; }
  std::span<double> values() { return values_; }

  /// Resizes to that many modules and parameters in total without initializing them: the caller
  /// must write the arrays. Throws Error(too_large) beyond 2^32 - 1 parameters.
  void resize(size_t modules, size_t values);

  bool operator==(const Word&) const = default;

 private:
  UninitializedVector<SymbolId> symbols_;
  UninitializedVector<uint32_t> starts_{0};
  UninitializedVector<double> values_;
};

/// E.g. "B(2)A(4,4)[+F]", without blanks, as ABOP prints words (prusinkiewicz1990). Numbers are in
/// base units, with the fewest digits that parse to the same number: 2, 0.5, 1e+20.
std::string to_string(const Word& word, const Alphabet& alphabet);

/// The text of the modules [begin, end).
std::string to_string(const Word& word, const Alphabet& alphabet, size_t begin, size_t end);

}  // namespace vug::lsystem
