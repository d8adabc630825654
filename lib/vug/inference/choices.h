// SPDX-License-Identifier: Apache-2.0
// Random choices of a move with their probability. The same code draws the choices of a move and
// scores those of the reverse move: the two densities of a reversible jump are written only once.
#pragma once

#include <vug/base/rng.h>
#include <vug/inference/discrete_distribution.h>

#include <vector>

namespace vug::inference {

/// The values of the choices in the order in which they are made.
using ChoiceTrace = std::vector<int>;

/// Draws choices from a stream, replays them from a trace, or scores values given by the caller.
/// `ln_probability` accumulates the log-probability of drawing them.
class Choices {
 public:
  /// Restarts; choices are drawn from the stream.
  void draw(RandomStream& stream);
  /// Restarts; choices are read from the trace, which must outlive this object.
  void replay(const ChoiceTrace& trace);
  /// Restarts; choices are the `given` arguments of the calls.
  void score();

  /// Uniform in 0..count-1.
  int below(int count, int given = 0);
  bool flip(bool given = false) { return below(2, given ? 1 : 0) != 0; }
  /// Uniform in low..high, both included.
  int between(int low, int high, int given = 0) { return low + below(high - low + 1, given - low); }
  /// An index drawn from the distribution restricted to the window [low, high).
  int among(const DiscreteDistribution& profile, int low, int high, int given = 0);

  /// Appends the choices of another object with their probability.
  void append(const Choices& others);

  /// -infinity if a given choice could not have been drawn, e.g. from an empty window.
  double ln_probability() const { return ln_; }
  bool possible() const;
  const ChoiceTrace& trace() const { return trace_; }

 private:
  int next();
  void begin();

  RandomStream* stream_ = nullptr;
  const ChoiceTrace* replayed_ = nullptr;
  ChoiceTrace trace_;
  double ln_ = 0;
};

}  // namespace vug::inference
