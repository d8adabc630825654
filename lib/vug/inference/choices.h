// The choices a move makes, with the probability of making them. One and the same code draws a
// move's choices and tells those of the move back, so the two densities of a reversible jump are
// written once.
#pragma once

#include <vug/base/rng.h>
#include <vug/inference/discrete_distribution.h>

#include <vector>

namespace vug::inference {

/// Choices in the order in which they are made.
using ChoiceTrace = std::vector<int>;

/// Each choice is drawn, or read from a trace, or the one that the caller tells; `ln_probability`
/// sums up how likely they are to be drawn.
class Choices {
 public:
  /// Begins anew: choices are drawn from the stream.
  void draw(RandomStream& stream);
  /// Begins anew: choices are those of the trace, which must outlive this.
  void replay(const ChoiceTrace& trace);
  /// Begins anew: choices are those that the calls tell.
  void score();

  /// One of 0..count-1, all alike.
  int below(int count, int given = 0);
  bool flip(bool given = false) { return below(2, given ? 1 : 0) != 0; }
  /// One of low..high, both included, all alike.
  int between(int low, int high, int given = 0) { return low + below(high - low + 1, given - low); }
  /// A place in the profile's window [low, high).
  int among(const DiscreteDistribution& profile, int low, int high, int given = 0);

  /// Appends choices that were given elsewhere, as they are.
  void append(const Choices& others);

  /// -infinity when one that was given could not have been drawn, as for windows without a place.
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
