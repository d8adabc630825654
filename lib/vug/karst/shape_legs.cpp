// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/karst/separation.h>
#include <vug/karst/shape_legs.h>

#include <algorithm>
#include <cmath>

namespace vug::karst {
namespace {

constexpr double kCell = 12;  ///< Metres.
constexpr double kBend = 2;   ///< Metres of passage in separations that may lie close together.
/// Least distance of two pieces by the metres of passage between them, about 2 sin(35 deg / 2) / 2.
constexpr double kPillar = 0.28;
/// Sine of the least angle of pieces at a station, 25 degrees.
constexpr double kShapeSine = 0.42;
constexpr size_t kLegGrain = 32;

using Shape = std::vector<Vec3d>;

/// One piece of a shape, and the metres from the start of the shape to it.
struct Piece {
  int leg = 0;
  SegmentPiece segment;
  double start = 0;
  double end = 0;
};

/// The parts of a segment outside a ball; at most two.
std::vector<SegmentPiece> outside(const SegmentPiece& s, const Vec3d& center, double radius) {
  const Vec3d way = s.to - s.from;
  const Vec3d offset = s.from - center;
  const double a = way.length2(), b = offset.dot(way), c = offset.length2() - radius * radius;
  const double root = b * b - a * c;
  if (!(a > 0)) return c >= 0 ? std::vector{s} : std::vector<SegmentPiece>{};
  if (root <= 0) return {s};
  const double first = (-b - std::sqrt(root)) / a, last = (-b + std::sqrt(root)) / a;
  std::vector<SegmentPiece> parts;
  if (first > 0) parts.push_back({s.from, s.from + way * std::min(first, 1.0)});
  if (last < 1) parts.push_back({s.from + way * std::max(last, 0.0), s.to});
  return parts;
}

class LegShapes {
 public:
  LegShapes(const network::Network& network, const std::vector<int>& places, const Rock& rock,
            const KarstOptions& options)
      : network_(network),
        places_(places),
        rock_(rock),
        options_(options),
        key_(RandomKey(options.seed).at("shape")),
        separation_(options.samples.separation),
        attempts_(network.legs.size(), 0),
        shapes_(network.legs.size()) {}

  std::vector<Shape> run() {
    std::vector<int> changed(shapes_.size());
    for (size_t i = 0; i < changed.size(); ++i) changed[i] = static_cast<int>(i);
    while (!changed.empty()) {
      parallel_for(
          changed.size(), [&](size_t i) { draw(static_cast<size_t>(changed[i])); }, kLegGrain);
      changed = next_attempts();
    }
    return std::move(shapes_);
  }

 private:
  const Vec3d& position(int station) const {
    return network_.stations[static_cast<size_t>(station)].position;
  }

  void draw(size_t i) {
    const network::Leg& leg = network_.legs[i];
    const SegmentPiece ends{position(leg.from), position(leg.to)};
    shapes_[i] = shape_passage(leg, ends, rock_, options_.shape, attempts_[i], key_.at(i));
  }

  std::vector<Piece> pieces() {
    std::vector<Piece> all;
    lengths_.assign(shapes_.size(), 0);
    for (size_t i = 0; i < shapes_.size(); ++i) {
      double along = 0;
      for (size_t p = 1; p < shapes_[i].size(); ++p) {
        const SegmentPiece segment{shapes_[i][p - 1], shapes_[i][p]};
        const double length = (segment.to - segment.from).length();
        all.push_back({static_cast<int>(i), segment, along, along + length});
        along += length;
      }
      lengths_[i] = along;
    }
    return all;
  }

  bool too_close(const Piece& a, const Piece& b) const {
    const double least2 = separation_ * separation_ * (1 - 1e-9);
    const double apart2 = distance2(a.segment, b.segment);
    if (apart2 >= least2) return false;
    if (a.leg == b.leg) {
      const double between = std::max(a.start, b.start) - std::min(a.end, b.end);
      return between > kBend * separation_ || leads_back(apart2, between);
    }
    return meet_again(a, b, 1) || meet_again(a, b, 0.5) || leave_together(a, b, apart2);
  }

  /// Whether a distance is small for the metres of passage between two pieces, which would leave a
  /// small pillar of rock between them.
  static bool leads_back(double apart2, double between) {
    return between > 0 && apart2 < kPillar * kPillar * between * between;
  }

  /// Whether two legs leave a common station in nearly the same direction, or come closer again.
  bool leave_together(const Piece& a, const Piece& b, double apart2) const {
    const network::Leg& first = network_.legs[static_cast<size_t>(a.leg)];
    const network::Leg& second = network_.legs[static_cast<size_t>(b.leg)];
    for (const bool a_starts : {true, false})
      for (const bool b_starts : {true, false}) {
        const int i = a_starts ? first.from : first.to, j = b_starts ? second.from : second.to;
        if (places_[static_cast<size_t>(i)] != places_[static_cast<size_t>(j)]) continue;
        const double between = before(a, a_starts) + before(b, b_starts);
        if (between > 0 ? leads_back(apart2, between)
                        : nearly_parallel(away(a, a_starts), away(b, b_starts), kShapeSine))
          return true;
      }
    return false;
  }

  /// The metres of a leg from one of its ends to a piece.
  double before(const Piece& piece, bool from_start) const {
    return from_start ? piece.start
                      : std::max(0.0, lengths_[static_cast<size_t>(piece.leg)] - piece.end);
  }
  static Vec3d away(const Piece& piece, bool from_start) {
    const Vec3d way = piece.segment.to - piece.segment.from;
    return from_start ? way : -way;
  }

  /// Whether two pieces are closer than a part of the separation at a distance from the stations
  /// that their legs share.
  bool meet_again(const Piece& a, const Piece& b, double part) const {
    std::vector<SegmentPiece> of_a{a.segment}, of_b{b.segment};
    const network::Leg& first = network_.legs[static_cast<size_t>(a.leg)];
    const network::Leg& second = network_.legs[static_cast<size_t>(b.leg)];
    const double least = part * separation_ * (1 - 1e-9);
    for (const int i : {first.from, first.to})
      for (const int j : {second.from, second.to}) {
        if (places_[static_cast<size_t>(i)] != places_[static_cast<size_t>(j)]) continue;
        of_a = all_outside(of_a, position(i), kMeeting * least);
        of_b = all_outside(of_b, position(i), kMeeting * least);
      }
    for (const SegmentPiece& one : of_a)
      for (const SegmentPiece& other : of_b)
        if (distance2(one, other) < least * least) return true;
    return false;
  }

  std::vector<SegmentPiece> all_outside(const std::vector<SegmentPiece>& segments,
                                        const Vec3d& center, double radius) const {
    std::vector<SegmentPiece> parts;
    for (const SegmentPiece& segment : segments)
      for (const SegmentPiece& part : outside(segment, center, radius)) parts.push_back(part);
    return parts;
  }

  /// Increases the attempts of legs that are too close to others, and returns these legs. Of two
  /// legs it is the one with fewer attempts, then the one with the larger index.
  std::vector<int> next_attempts() {
    const std::vector<Piece> all = pieces();
    SegmentGrid grid(std::max(kCell, separation_), separation_);
    for (size_t i = 0; i < all.size(); ++i) grid.add(static_cast<int>(i), all[i].segment);
    std::vector<std::vector<int>> close(all.size());
    parallel_for(
        all.size(),
        [&](size_t i) {
          grid.any_near(all[i].segment, [&](int other) {
            if (static_cast<size_t>(other) < i &&
                too_close(all[i], all[static_cast<size_t>(other)]))
              close[i].push_back(all[static_cast<size_t>(other)].leg);
            return false;
          });
        },
        kLegGrain);
    std::vector<int> chosen;
    for (size_t i = 0; i < all.size(); ++i)
      for (const int other : close[i]) {
        const int leg = choose(all[i].leg, other);
        if (leg >= 0) chosen.push_back(leg);
      }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    for (const int leg : chosen) ++attempts_[static_cast<size_t>(leg)];
    return chosen;
  }

  int choose(int a, int b) const {
    const int larger = std::max(a, b), smaller = std::min(a, b);
    const int of_larger = attempts_[static_cast<size_t>(larger)];
    const int of_smaller = attempts_[static_cast<size_t>(smaller)];
    const int leg = of_larger <= of_smaller ? larger : smaller;
    return std::min(of_larger, of_smaller) + 1 < kShapeAttempts ? leg : -1;
  }

  const network::Network& network_;
  const std::vector<int>& places_;
  const Rock& rock_;
  const KarstOptions& options_;
  RandomKey key_;
  double separation_;
  std::vector<int> attempts_;
  std::vector<Shape> shapes_;
  std::vector<double> lengths_;
};

}  // namespace

std::vector<Shape> shape_legs(const network::Network& network, const std::vector<int>& places,
                              const Rock& rock, const KarstOptions& options) {
  return LegShapes(network, places, rock, options).run();
}

}  // namespace vug::karst
