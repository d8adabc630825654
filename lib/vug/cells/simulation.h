// Rules at work on a network: attributes, states and the clock.
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

/// A rule and when and where it works.
struct Stage {
  std::shared_ptr<const Rule> rule;
  std::string name{};            ///< Keys its random choices: stages of one name choose the same.
  int begin = 0;                 ///< Its first step.
  int steps = -1;                ///< How many it works for; below 0: to the end.
  std::vector<uint8_t> where{};  ///< 1 for each cell it may rewrite; empty: all.
  /// In place of that the chance of each cell. One that looks at attributes is asked anew in every
  /// step; the same draw decides each time, so that cells do not flicker.
  paint::Mask mask = nullptr;
  RandomKey draws{0};  ///< Keys those draws.
};

/// Within a step the stages work in their order. Each rewrites all its cells at once, from what the
/// stages before it have left: one that is first of its step reads what the last step left. So any
/// number of rules can share cells and even attributes. The same bytes for any number of threads.
class Simulation {
 public:
  Simulation(NetworkPtr network, RandomKey key);

  const Network& network() const { return *network_; }
  Attributes& attributes() { return attributes_; }
  const Attributes& attributes() const { return attributes_; }
  /// All cells are active at first.
  const std::vector<CellState>& states() const { return states_.now; }
  void set_states(std::vector<CellState> states);

  /// The level sets whose surfaces the objects are, by their numbers, for masks; null or not there
  /// where there is none.
  void set_solids(std::vector<std::shared_ptr<const field::SampledGrid>> solids) {
    solids_ = std::move(solids);
  }
  /// What a mask says of a cell as it is now; attributes that nobody has brought yet are 0 to it.
  double evaluate(const paint::Mask& mask, uint32_t cell) const;
  /// Attributes that rules want (Pass::reads_expected), or cannot do without: true
  /// (Pass::reads_as_numbers).
  const std::map<std::string, bool>& requested_attributes() const { return requested_; }

  uint64_t bytes() const;  ///< That it holds, with its network.

  /// Steps done so far.
  int step() const { return step_; }
  /// As if so many had been done, for whoever also sets what they have left.
  void set_step(int step) { step_ = step; }
  /// Goes on by so many steps, and calls `after` (if any) when one is done. Error(bad_input) where
  /// stages disagree about an attribute's type, or a mask is not as long as there are cells. After
  /// Error(cancelled), too, the steps are whole: it can go on.
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
};

}  // namespace vug::cells
