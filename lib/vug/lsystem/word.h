// Words: strings of modules, each a symbol with numbers. Brackets, cuts and polygons are modules as
// all others, named as ABOP writes them: "[", "]", "%", "{", "}", ".".
#pragma once

#include <vug/base/uninitialized_vector.h>
#include <vug/lsystem/alphabet.h>

#include <span>
#include <string>

namespace vug::lsystem {

/// One module of a word, valid as long as the word is unchanged.
struct Module {
  SymbolId symbol;
  std::span<const double> parameters;  ///< In base units: metres, radians, seconds.
};

/// A word as arrays: symbols, where their parameters begin, and all parameters in a row. A value.
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

  /// The arrays themselves: symbols; where each module's parameters begin among `values`, with the
  /// end of the last behind it; and all parameters of all modules, in order.
  std::span<const SymbolId> symbols() const { return symbols_; }
  std::span<const uint32_t> starts() const { return starts_; }
  std::span<const double> values() const { return values_; }
  std::span<SymbolId> symbols() { return symbols_; }
  std::span<uint32_t> starts() { return starts_; }
  std::span<double> values() { return values_; }

  /// Room for that many modules with that many parameters in all, of unset content: whoever calls
  /// this writes the arrays. Error(too_large) beyond 2^32 - 1 parameters.
  void resize(size_t modules, size_t values);

  bool operator==(const Word&) const = default;

 private:
  UninitializedVector<SymbolId> symbols_;
  UninitializedVector<uint32_t> starts_{0};
  UninitializedVector<double> values_;
};

/// "B(2)A(4,4)[+F]": without blanks, as ABOP prints words (prusinkiewicz1990). Numbers are in base
/// units, in the fewest digits that read back as the same number: 2, 0.5, 1e+20.
std::string to_string(const Word& word, const Alphabet& alphabet);

/// The same of the modules from `begin` up to, not including, `end`.
std::string to_string(const Word& word, const Alphabet& alphabet, size_t begin, size_t end);

}  // namespace vug::lsystem
