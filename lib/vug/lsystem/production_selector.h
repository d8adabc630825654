// SPDX-License-Identifier: Apache-2.0
// Internal to rewriting: selection of the production of each module.
#pragma once

#include <vug/lsystem/context.h>

#include <utility>
#include <vector>

namespace vug::lsystem {

/// Buffers for the evaluation of a production's programs.
class ProgramScratch {
 public:
  explicit ProgramScratch(const System& system);

  double* formals() { return formals_.data(); }
  double* values() { return values_.data(); }

 private:
  std::vector<double> formals_, values_;
};

/// Calls `run` for a program of the production; comparisons with a non-finite number become an
/// Error that names the production.
double* compute(const Production& production, const Program& program, const double* formals,
                double* stack, const double* numbers);

/// Runs a program that leaves a single number and returns it.
double single(const Production& production, const Program& program, const double* formals,
              ProgramScratch& scratch, const double* numbers);

/// The values of the formals of production `p` at module `i`; without a context they are in the
/// word.
const double* formals_at(const Production& p, const Word& word, size_t i,
                         const ContextMatcher& around, ProgramScratch& scratch);

/// Hint about valid weights.
inline constexpr const char* kWeights = "weights must be 0 or more; only their ratios matter";

/// Throws Error(bad_input) that names the production.
[[noreturn]] void fail_invalid_number(const Production& production, const std::string& what,
                                      double value,
                                      const std::string& hint = "numbers in words must be finite");

/// Selects productions within one task. All constructor arguments must outlive it.
class ProductionSelector {
 public:
  ProductionSelector(const System& system, const RuleBook& book, const Word& word,
                     const ContextMatcher& around)
      : system_(system), book_(book), word_(word), around_(around), scratch_(system) {}

  /// The index of the production for module `i` plus 1, or 0 for none. `numbers` are the module's
  /// random numbers, in RuleSelection::blocks blocks.
  uint16_t choose(size_t i, const double* numbers);

 private:
  uint16_t select_by_weight(const RuleSelection& symbol, double number) const;
  uint16_t select_first_match(const RuleSelection& symbol, size_t i, const double* numbers);
  double collect_weights(const RuleSelection& symbol, uint32_t r, size_t i, const double* numbers);
  bool fits(const Production& p, size_t i, const double* numbers);
  double weight(const Production& p, size_t i, const double* numbers);

  const System& system_;
  const RuleBook& book_;
  const Word& word_;
  const ContextMatcher& around_;
  ProgramScratch scratch_;
  std::vector<std::pair<uint16_t, double>> weighted_;
};

}  // namespace vug::lsystem
