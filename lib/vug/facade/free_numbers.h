// SPDX-License-Identifier: Apache-2.0
// Free numbers of a split: counts, sizes and positions that the text does not specify. A derivation
// draws them at random; a model fixes some of them, and the others have defaults that depend on the
// size.
#pragma once

#include <vug/base/error.h>
#include <vug/base/rng.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace vug::facade {

/// Numbers by name: {"columns": {4}, "dx": {2.1, 2.4, 2.1}}. Lengths are metres.
using NumberValues = std::map<std::string, std::vector<double>>;

/// A free number, or a list of them, that a split has requested.
struct FreeNumber {
  std::string name;
  bool whole = false;          ///< True for counts, false for lengths in metres.
  double least = 0, most = 0;  ///< Range of each value.
  std::string per = {};        ///< Name of the count that gives their number; empty: constant.
  std::vector<double> values = {};
  bool fixed = false;  ///< Set by the plan; else a default or random.
};

/// The reason why a rule cannot be applied.
enum class Reason {
  none,             ///< The rule can be applied.
  wrong_symbol,     ///< It divides another symbol.
  wrong_arguments,  ///< It takes a different number of arguments.
  condition,        ///< Its condition is false.
  does_not_fit,     ///< Numbers are out of range, or sizes exceed the available extent.
  too_small,        ///< A part would be smaller than the minimum.
  divided           ///< Another rule already divides the node.
};
std::string to_string(Reason reason);

/// Thrown if a plan cannot be followed.
class InfeasiblePlan : public Error {
 public:
  /// `number` is the name of the invalid number; empty if no single number is responsible.
  InfeasiblePlan(Reason reason, std::string number, const std::string& message,
                 std::string hint = {}, SourceLocation where = {});
  Reason reason() const { return reason_; }
  const std::string& number() const { return number_; }

 private:
  Reason reason_;
  std::string number_;
};

/// Provides the free numbers of one split and records its requests.
class FreeNumbers {
 public:
  /// Draws all numbers from the key.
  explicit FreeNumbers(RandomKey key) : key_(key) {}
  /// Uses the fixed numbers and defaults. `apart`: copies of a cell become cells of their own.
  explicit FreeNumbers(NumberValues fixed, bool apart = false)
      : key_(0), random_(false), apart_(apart), fixed_(std::move(fixed)) {}

  bool is_random() const { return random_; }
  bool apart() const { return apart_; }
  RandomKey key() const { return key_; }
  bool is_fixed(const std::string& name) const { return fixed_.count(name) > 0; }

  /// A whole number in least..most. Throws InfeasiblePlan if the fixed number is invalid, like all
  /// functions below.
  int count(const std::string& name, int least, int most, double usual,
            const std::function<int()>& draw);
  /// A length in metres in least..most, with a tolerance for rounding.
  double length(const std::string& name, double least, double most, double usual,
                const std::function<double()>& draw = {});
  /// `count` lengths in least..most. If fewer are fixed, the others equal the last fixed one.
  std::vector<double> lengths(const std::string& name, const std::string& per, size_t count,
                              double least, double most, double usual);
  /// `count` lengths that add up to the extent. If fewer are fixed, the others share the rest
  /// evenly. Random lengths are drawn from the key, proportional to numbers between 1/2 and 3/2.
  std::vector<double> shares(const std::string& name, const std::string& per, size_t count,
                             double extent, RandomKey key, const std::vector<double>& usual = {});

  /// All requested numbers with their values.
  const std::vector<FreeNumber>& requested() const { return requested_; }
  /// Throws InfeasiblePlan if a fixed number was not requested.
  void check_all_used() const;

 private:
  const std::vector<double>* find_fixed(const std::string& name) const;
  void refuse(const FreeNumber& request, double value) const;

  RandomKey key_;
  bool random_ = true, apart_ = false;
  NumberValues fixed_;
  std::vector<FreeNumber> requested_;
};

}  // namespace vug::facade
