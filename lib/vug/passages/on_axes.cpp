// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/curves/axis.h>
#include <vug/passages/on_axes.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace vug::passages {
namespace {

using network::Network;

/// The index in the chain of each point of its curve that is a station, else -1.
std::vector<int> chain_indices(const Chain& chain, const Curve& curve) {
  std::vector<int> indices;
  size_t next = 0;
  for (const CurvePoint& point : curve) {
    size_t i = next;
    // Most points are not stations; a search for each of them would be quadratic.
    while (point.station >= 0 && i < chain.stations.size() && chain.stations[i] != point.station)
      ++i;
    const bool found = point.station >= 0 && i < chain.stations.size();
    indices.push_back(found ? static_cast<int>(i) : -1);
    if (found) next = i + 1;
  }
  return indices;
}

network::CrossSection section_about_axis(double width, double height) {
  return {0.5 * width, 0.5 * width, 0.5 * height, 0.5 * height};
}

class AxisNetwork {
 public:
  explicit AxisNetwork(const Network& network) : legs_(network), out_(network) {
    out_.legs.clear();
    for (network::Station& station : out_.stations) {
      station.section.reset();
      station.splays.clear();
    }
  }

  void add(const Chain& chain, const Curve& curve) {
    const std::vector<int> indices = chain_indices(chain, curve);
    std::vector<size_t> known;  // Points of the curve that are stations.
    for (size_t i = 0; i < curve.size(); ++i)
      if (indices[i] >= 0) known.push_back(i);
    if (known.size() < 2) {
      for (size_t i = 0; i < chain.legs.size(); ++i)
        add_leg(chain, i, chain.stations[i], chain.stations[i + 1]);
      return;
    }
    for (size_t k = 1; k < known.size(); ++k) {
      const auto from = curve.begin() + static_cast<std::ptrdiff_t>(known[k - 1]);
      const auto to = curve.begin() + static_cast<std::ptrdiff_t>(known[k]);
      add_span(chain, {from, to + 1}, static_cast<size_t>(indices[known[k - 1]]),
               static_cast<size_t>(indices[known[k]]));
    }
  }

  /// Stations at one position stay at one position.
  Network finish() {
    std::map<std::tuple<double, double, double>, size_t> first;
    for (size_t i = 0; i < out_.stations.size() && i < legs_.stations.size(); ++i) {
      const Vec3d& p = legs_.stations[i].position;
      const size_t same =
          first.emplace(std::tuple(p.x + 0.0, p.y + 0.0, p.z + 0.0), i).first->second;
      out_.stations[i].position = out_.stations[same].position;
      out_.stations[i].section = out_.stations[same].section;
    }
    return std::move(out_);
  }

 private:
  /// The part of a curve between two stations of a chain. Stations between them, which the curve
  /// omits, are at the same fractions of its length as of the legs.
  void add_span(const Chain& chain, const Curve& curve, size_t first, size_t last) {
    const std::vector<double> along = arc_lengths(curve);
    std::vector<double> on_legs{0};
    for (size_t i = first; i < last; ++i)
      on_legs.push_back(on_legs.back() + (legs_.stations[at(chain, i + 1)].position -
                                          legs_.stations[at(chain, i)].position)
                                             .length());
    const double scale = on_legs.back() > 0 ? along.back() / on_legs.back() : 0;
    set_end(chain, first, curve.front());
    set_end(chain, last, curve.back());
    int from = chain.stations[first];
    size_t next = 1;  // The next point of the curve.
    for (size_t i = first; i < last; ++i) {
      const double end = on_legs[i + 1 - first] * scale;
      for (; next + 1 < curve.size() && along[next] < end; ++next) {
        const int to = static_cast<int>(out_.stations.size());
        out_.stations.push_back(
            {.position = curve[next].position,
             .section = section_about_axis(curve[next].width, curve[next].height)});
        add_leg(chain, i, from, to);
        from = to;
      }
      if (i + 1 < last) {
        const double span = along[next] - along[next - 1];
        const double t = span > 0 ? std::clamp((end - along[next - 1]) / span, 0.0, 1.0) : 0;
        const CurvePoint &a = curve[next - 1], &b = curve[next];
        network::Station& station = out_.stations[at(chain, i + 1)];
        station.position = a.position + (b.position - a.position) * t;
        station.section = section_about_axis(a.width + (b.width - a.width) * t,
                                             a.height + (b.height - a.height) * t);
      }
      add_leg(chain, i, from, chain.stations[i + 1]);
      from = chain.stations[i + 1];
    }
  }

  /// A station has the size of the passage that goes on, not of one that ends there.
  void set_end(const Chain& chain, size_t i, const CurvePoint& point) {
    network::Station& station = out_.stations[at(chain, i)];
    station.position = point.position;
    if (!chain.meets_at(i) || !station.section)
      station.section = section_about_axis(point.width, point.height);
  }

  static size_t at(const Chain& chain, size_t i) { return static_cast<size_t>(chain.stations[i]); }

  void add_leg(const Chain& chain, size_t i, int from, int to) {
    network::Leg leg = legs_.legs[static_cast<size_t>(chain.legs[i])];
    const Vec3d& start = legs_.stations[static_cast<size_t>(leg.from)].position;
    const bool forward = start == legs_.stations[at(chain, i)].position;
    leg.from = forward ? from : to;
    leg.to = forward ? to : from;
    out_.legs.push_back(std::move(leg));
  }

  const Network& legs_;
  Network out_;
};

}  // namespace

Network on_axes(const Network& network, const PassageOptions& options) {
  network::require_valid(network);
  const std::vector<Chain> all = chains(network);
  const std::vector<Curve> curves = axes(network, all, options);
  AxisNetwork result(network);
  for (size_t i = 0; i < all.size(); ++i) result.add(all[i], curves[i]);
  return result.finish();
}

}  // namespace vug::passages
