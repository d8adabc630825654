// What a text leaves open of a split: counts, sizes, places. Deriving draws them. Who models tells
// them, and what is not told is what is usual for the size.
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

/// A number, or a row of them, that a split has asked for.
struct FreeNumber {
  std::string name;
  bool whole = false;          ///< Counts; else metres.
  double least = 0, most = 0;  ///< Of each.
  std::string per = {};        ///< The count that says how many there are; empty: always as many.
  std::vector<double> values = {};
  bool fixed = false;  ///< Else they are what is usual, or drawn.
};

/// Why a rule is not there to be applied.
enum class Reason {
  none,             ///< It is.
  wrong_symbol,     ///< It divides another symbol.
  wrong_arguments,  ///< It takes another number of arguments.
  condition,        ///< Its condition is false.
  does_not_fit,     ///< Numbers are out of their ranges, or sizes are more than there is.
  too_small,        ///< A part would be smaller than the least.
  divided           ///< Another rule divides the node already.
};
std::string to_string(Reason reason);

/// A choice that cannot be followed.
class InfeasiblePlan : public Error {
 public:
  /// `number` names what was told wrong; empty: none of them alone.
  InfeasiblePlan(Reason reason, std::string number, const std::string& message,
                 std::string hint = {}, SourceLocation where = {});
  Reason reason() const { return reason_; }
  const std::string& number() const { return number_; }

 private:
  Reason reason_;
  std::string number_;
};

class FreeNumbers {
 public:
  /// Draws from the key.
  explicit FreeNumbers(RandomKey key) : key_(key) {}
  /// Takes what is told. `apart`: what a split would stamp again are places of their own.
  explicit FreeNumbers(NumberValues fixed, bool apart = false)
      : key_(0), random_(false), apart_(apart), fixed_(std::move(fixed)) {}

  bool is_random() const { return random_; }
  bool apart() const { return apart_; }
  RandomKey key() const { return key_; }
  bool is_fixed(const std::string& name) const { return fixed_.count(name) > 0; }

  /// A whole number in least..most. InfeasiblePlan when another is told; so do all below.
  int count(const std::string& name, int least, int most, double usual,
            const std::function<int()>& draw);
  /// Metres in least..most. With a tolerance of rounding.
  double length(const std::string& name, double least, double most, double usual,
                const std::function<double()>& draw = {});
  /// As many lengths in least..most. What is told may be fewer: the others are as its last.
  std::vector<double> lengths(const std::string& name, const std::string& per, size_t count,
                              double least, double most, double usual);
  /// Lengths that add up to the extent. Of what is told the last may be missing: they share the
  /// rest. Drawn from the key as shares between 1/2 and 3/2 of an even one.
  std::vector<double> shares(const std::string& name, const std::string& per, size_t count,
                             double extent, RandomKey key, const std::vector<double>& usual = {});

  /// All that was asked for, with the answers.
  const std::vector<FreeNumber>& requested() const { return requested_; }
  /// InfeasiblePlan where something was told that nothing asks for.
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
