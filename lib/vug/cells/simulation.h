// SPDX-License-Identifier: Apache-2.0
// Simulation of rules on a network: attributes, states, the step counter and
// its progress.
#pragma once

#include <vug/base/progress.h>
#include <vug/base/rng.h>
#include <vug/cells/blocks.h>
#include <vug/cells/network.h>
#include <vug/paint/paint.h>

#include <functional>
#include <map>
#include <memory>

namespace vug::cells {

class Rule;

/// A rule with the time and place of its application.
struct Stage {
  std::shared_ptr<const Rule> rule;
  std::string
      name{};      ///< Key of its random choices: stages with the same name make the same choices.
  int begin = 0;   ///< First step.
  int steps = -1;  ///< Number of steps; negative: until the end.
  std::vector<uint8_t> where{};  ///< 1 for each cell it may change; empty: all.
  /// Alternative to `where`: the probability for each cell. A mask that uses attributes is
  /// evaluated in every step; the random number of a cell remains the same, so cells do not
  /// flicker.
  paint::Mask mask = nullptr;
  RandomKey draws{0};  ///< Key of these random numbers.
};

/// Within a step the stages run in order. Each updates all its cells at once from the values that
/// the previous stages left; the first stage reads the values of the previous step. Therefore any
/// number of rules can share cells and even attributes. The results have the same bytes for any
/// number of threads.
class Simulation {
 public:
  Simulation(NetworkPtr network, RandomKey key);

  const Network& network() const { return *network_; }
  Attributes& attributes() { return attributes_; }
  const Attributes& attributes() const { return attributes_; }
  /// All cells are active initially.
  const std::vector<CellState>& states() const { return states_.now; }
  void set_states(std::vector<CellState> states);

  /// The level sets of the objects for masks, by object index; null or missing for objects without
  /// one.
  void set_solids(std::vector<std::shared_ptr<const field::SampledGrid>> solids) {
    solids_ = std::move(solids);
  }
  /// Evaluates a mask at the current state of a cell; attributes that do not exist are 0.
  double evaluate(const paint::Mask& mask, uint32_t cell) const;
  /// Attributes that rules expect (Pass::reads_expected), with true if they require them
  /// (Pass::reads_as_numbers).
  const std::map<std::string, bool>& requested_attributes() const { return requested_; }

  /// A trial finds the attributes that rules create; rules accept any values of attributes.
  void set_trial(bool trial) { trial_ = trial; }
  bool is_trial() const { return trial_; }

  uint64_t bytes() const;  ///< Memory use, including the network.

  /// Completed steps.
  int step() const { return step_; }
  /// Sets the step counter; the caller must also restore the corresponding attributes.
  void set_step(int step) { step_ = step; }
  /// Performs `steps` more steps and calls `after` (if any) after each. Throws Error(bad_input) if
  /// stages disagree about an attribute's type, or if a mask and the cells differ in number. Steps
  /// are complete even after Error(cancelled), so the simulation can continue.
  void run(const std::vector<Stage>& stages, int steps, Progress& progress = Progress::none(),
           const std::function<void()>& after = nullptr);

 private:
  friend class Pass;
  std::vector<uint8_t> chosen(const Stage& stage) const;

  NetworkPtr network_;
  RandomKey key_;
  Attributes attributes_;
  Column<CellState> states_;
  Blocks blocks_;
  std::map<double, Links> within_;
  std::vector<std::shared_ptr<const field::SampledGrid>> solids_;
  std::map<std::string, bool> requested_;
  int step_ = 0;
  bool trial_ = false;
};

}  // namespace vug::cells
