// SPDX-License-Identifier: Apache-2.0
// An exponential covariance along a path is a Markov process: a station depends on the one before
// it only. Sections are therefore drawn along a spanning forest that starts at measured stations.
#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/network/section_statistics.h>

#include <cmath>
#include <deque>

namespace vug::network {
namespace {

/// The correlated parts of ln width and ln height, standard normal each.
struct Signal {
  double width = 0;
  double height = 0;
};

void require_valid(const SectionModel& m) {
  const auto require = [](bool valid, const char* name, double value, const char* expected) {
    if (!valid)
      throw Error(ErrorCode::bad_input,
                  fmt::format("the {} of the section model is {}", name, value), {}, expected);
  };
  const auto is_size = [](double v) { return v > 0 && std::isfinite(v); };
  const auto is_fraction = [](double v) { return v >= 0 && v <= 1; };
  require(is_size(m.width_median), "median width", m.width_median, "it must be positive");
  require(is_size(m.height_median), "median height", m.height_median, "it must be positive");
  require(m.width_spread >= 0 && m.width_spread <= 3, "width spread", m.width_spread,
          "it must be in 0 to 3");
  require(m.height_spread >= 0 && m.height_spread <= 3, "height spread", m.height_spread,
          "it must be in 0 to 3");
  require(m.correlation >= -1 && m.correlation <= 1, "correlation", m.correlation,
          "it must be in -1 to 1");
  require(is_fraction(m.nugget), "nugget", m.nugget, "it must be in 0 to 1");
  require(is_size(m.range), "range", m.range, "it must be positive");
  require(is_fraction(m.off_centre_width), "horizontal offset", m.off_centre_width,
          "it must be in 0 to 1");
  require(m.least_width >= 0 && std::isfinite(m.least_width), "least width", m.least_width,
          "it must be 0 or positive");
  require(m.least_height >= 0 && std::isfinite(m.least_height), "least height", m.least_height,
          "it must be 0 or positive");
  require(is_fraction(m.off_centre_height), "vertical offset", m.off_centre_height,
          "it must be in 0 to 1");
}

class SectionDrawing {
 public:
  SectionDrawing(Network& network, const SectionModel& model, uint64_t seed)
      : network_(network),
        m_(model),
        key_(RandomKey(seed).at("sections")),
        legs_(legs_at_stations(network)),
        signals_(network.stations.size()),
        reached_(network.stations.size(), false) {}

  void run() {
    const size_t count = network_.stations.size();
    for (size_t i = 0; i < count; ++i)
      if (network_.stations[i].section) start_at_measured(i);
    spread();
    for (size_t i = 0; i < count; ++i) {
      if (reached_[i]) continue;
      RandomStream random(key_.at(i));
      reach(i, draw(random), random);
      spread();
    }
  }

 private:
  Signal draw(RandomStream& random) const {
    const double width = random.normal();
    const double other = random.normal();
    return {width, m_.correlation * width + rest(m_.correlation) * other};
  }

  static double rest(double correlation) {
    return std::sqrt(std::max(0.0, 1 - correlation * correlation));
  }

  void start_at_measured(size_t i) {
    RandomStream random(key_.at(i));
    const CrossSection& section = *network_.stations[i].section;
    Signal signal = draw(random);
    const double share = std::sqrt(1 - m_.nugget);
    const auto condition = [&](double& part, double size, double median, double spread) {
      if (!(size > 0) || !(spread > 0)) return;
      // The signal's mean and variance under the condition that signal and nugget sum to `total`.
      const double total = maths::log(size / median) / spread;
      part = share * total + std::sqrt(m_.nugget) * part;
    };
    condition(signal.width, section.left.value_or(0) + section.right.value_or(0), m_.width_median,
              m_.width_spread);
    condition(signal.height, section.up.value_or(0) + section.down.value_or(0), m_.height_median,
              m_.height_spread);
    signals_[i] = signal;
    reached_[i] = true;
    queue_.push_back(i);
  }

  void spread() {
    while (!queue_.empty()) {
      const size_t from = queue_.front();
      queue_.pop_front();
      for (const int index : legs_[from]) {
        const Leg& leg = network_.legs[static_cast<size_t>(index)];
        const auto to =
            static_cast<size_t>(static_cast<size_t>(leg.from) == from ? leg.to : leg.from);
        if (reached_[to]) continue;
        const double kept = maths::exp(-3 * leg_vector(network_, leg).length() / m_.range);
        RandomStream random(key_.at(to));
        const Signal fresh = draw(random);
        reach(to,
              {kept * signals_[from].width + rest(kept) * fresh.width,
               kept * signals_[from].height + rest(kept) * fresh.height},
              random);
      }
    }
  }

  void reach(size_t i, const Signal& signal, RandomStream& random) {
    signals_[i] = signal;
    reached_[i] = true;
    queue_.push_back(i);
    const Signal own = draw(random);
    const double share = std::sqrt(1 - m_.nugget);
    const double own_share = std::sqrt(m_.nugget);
    const double width =
        std::max(m_.least_width,
                 m_.width_median *
                     maths::exp(m_.width_spread * (share * signal.width + own_share * own.width)));
    const double height = std::max(
        m_.least_height,
        m_.height_median *
            maths::exp(m_.height_spread * (share * signal.height + own_share * own.height)));
    const double left = width * side(m_.off_centre_width, random);
    const double up = height * side(m_.off_centre_height, random);
    network_.stations[i].section = CrossSection{left, width - left, up, height - up};
  }

  /// The fraction of a size on one side, of which |2 fraction - 1| has the given mean: a power of a
  /// uniform number u has the mean of u^p, 1 / (p + 1).
  static double side(double mean_offset, RandomStream& random) {
    const double uniform = random.uniform();
    const bool first = random.uniform() < 0.5;
    const double offset = mean_offset > 0 ? maths::pow(uniform, 1 / mean_offset - 1) : 0.0;
    return first ? (1 + offset) / 2 : (1 - offset) / 2;
  }

  Network& network_;
  const SectionModel& m_;
  RandomKey key_;
  std::vector<std::vector<int>> legs_;
  std::vector<Signal> signals_;
  std::vector<bool> reached_;
  std::deque<size_t> queue_;
};

}  // namespace

Network draw_sections(Network network, const SectionModel& model, uint64_t seed) {
  require_valid(network);
  require_valid(model);
  SectionDrawing(network, model, seed).run();
  return network;
}

}  // namespace vug::network
