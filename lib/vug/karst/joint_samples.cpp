// SPDX-License-Identifier: Apache-2.0
#include <vug/karst/joint_samples.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace vug::karst {
namespace {

/// A sample on a joint, and its distance from the start in metres in plan.
struct OnJoint {
  double along = 0;
  int sample = 0;
};

/// The fraction of the first line, in plan, at which it crosses the second one.
std::optional<double> crossing(const SegmentPiece& a, const SegmentPiece& b) {
  const Vec3d u = a.to - a.from, v = b.to - b.from, w = b.from - a.from;
  const double cross = u.x * v.z - u.z * v.x;
  if (cross == 0) return std::nullopt;
  const double s = (w.x * v.z - w.z * v.x) / cross, t = (w.x * u.z - w.z * u.x) / cross;
  return s >= 0 && s <= 1 && t >= 0 && t <= 1 ? std::optional(s) : std::nullopt;
}

class JointSampler {
 public:
  JointSampler(const std::vector<SegmentPiece>& traces, const std::function<int(const Vec3d&)>& add)
      : traces_(traces), add_(add) {}

  template <class Height>
  void run(double step, const Height& height_at) {
    joints_.assign(traces_.size(), {});
    const auto place = [&](Vec3d point) {
      point.y = height_at(point);
      return add_(point);
    };
    for (const auto& [i, j] : crossings()) {
      const SegmentPiece& trace = traces_[i];
      const std::optional<double> at = crossing(trace, traces_[j]);
      if (!at) continue;
      const Vec3d point = trace.from + (trace.to - trace.from) * *at;
      const int sample = place(point);
      if (sample < 0) continue;
      for (const size_t joint : {i, j})
        joints_[joint].push_back({(point - traces_[joint].from).length(), sample});
    }
    for (size_t i = 0; i < traces_.size(); ++i) fill(i, step, place);
  }

  std::vector<std::array<int, 2>> take_edges() {
    std::sort(edges_.begin(), edges_.end());
    return std::move(edges_);
  }

 private:
  /// Pairs of joints that may cross.
  std::vector<std::pair<size_t, size_t>> crossings() const {
    double total = 0;
    for (const SegmentPiece& trace : traces_) total += (trace.to - trace.from).length();
    SegmentGrid grid(std::max(1e-3, 0.5 * total / static_cast<double>(traces_.size())), 0);
    std::vector<std::pair<size_t, size_t>> pairs;
    for (size_t i = 0; i < traces_.size(); ++i) {
      grid.any_near(traces_[i], [&](int other) {
        pairs.emplace_back(i, static_cast<size_t>(other));
        return false;
      });
      grid.add(static_cast<int>(i), traces_[i]);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  /// Adds samples between the crossings of a joint, and the edges along it.
  template <class Place>
  void fill(size_t joint, double step, const Place& place) {
    const Vec3d from = traces_[joint].from, way = traces_[joint].to - from;
    const double length = way.length();
    std::vector<OnJoint>& samples = joints_[joint];
    std::vector<double> stops{0, length};
    for (const OnJoint& at : samples) stops.push_back(at.along);
    std::sort(stops.begin(), stops.end());
    const auto place_at = [&](double along) {
      const int sample = place(from + way * (along / length));
      if (sample >= 0) samples.push_back({along, sample});
    };
    place_at(0);
    place_at(length);
    for (size_t i = 0; i + 1 < stops.size(); ++i) {
      const double gap = stops[i + 1] - stops[i], pieces = std::ceil(gap / step - 1e-9);
      for (double k = 1; k < pieces; ++k) place_at(stops[i] + gap * (k / pieces));
    }
    std::sort(samples.begin(), samples.end(),
              [](const OnJoint& a, const OnJoint& b) { return a.along < b.along; });
    for (size_t i = 1; i < samples.size(); ++i)
      edges_.push_back({std::min(samples[i - 1].sample, samples[i].sample),
                        std::max(samples[i - 1].sample, samples[i].sample)});
  }

  const std::vector<SegmentPiece>& traces_;
  const std::function<int(const Vec3d&)>& add_;
  std::vector<std::vector<OnJoint>> joints_;
  std::vector<std::array<int, 2>> edges_;
};

}  // namespace

std::vector<std::array<int, 2>> sample_joints(const std::vector<SegmentPiece>& traces,
                                              const Geology& geology, double step,
                                              const std::function<int(const Vec3d&)>& add) {
  JointSampler sampler(traces, add);
  if (traces.empty()) return {};
  for (const Layer& bed : geology.beds)
    sampler.run(step, [&](const Vec3d& p) { return bed.height_at(p.x, p.z); });
  if (geology.beds.empty())
    sampler.run(step, [&](const Vec3d&) { return geology.bounds.center().y; });
  return sampler.take_edges();
}

}  // namespace vug::karst
