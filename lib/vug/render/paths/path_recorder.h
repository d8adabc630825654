// What a path learns about how bright the surfaces are that it comes by.
#pragma once

#include <vug/render/guiding/radiance_sample.h>

#include <algorithm>
#include <array>
#include <vector>

namespace vug::render {

/// The surfaces of one path: each sent back all light that the path gathers from there on.
class Trail {
 public:
  explicit Trail(std::vector<Sighting>& sightings) : sightings_(sightings) {}

  /// The path arrives with `throughput`, and has gathered `so_far` until now.
  void add(const Vec3f& point, const Vec3f& normal, const Rgb& throughput, const Rgb& so_far) {
    full_ = count_ == places_.size();
    if (!full_) places_[count_++] = {point, normal, throughput, so_far, so_far};
  }
  /// And `so_far` when lights have been chosen at the place added last.
  void lit(const Rgb& so_far) {
    if (count_ > 0 && !full_) places_[count_ - 1].lit = so_far;
  }
  /// The path ends, having gathered `all`.
  void learn(const Rgb& all) const {
    for (size_t i = 0; i < count_; ++i) {
      const Place& place = places_[i];
      sightings_.push_back({place.point, place.normal, sent_back(place, all, place.so_far), i == 0,
                            sent_back(place, all, place.lit)});
    }
  }

 private:
  struct Place {
    Vec3f point, normal;
    Rgb throughput, so_far, lit;
  };
  static float sent_back(const Place& place, const Rgb& all, const Rgb& before) {
    Rgb left(0.0f);
    for (int k = 0; k < 3; ++k)
      if (place.throughput[k] > 0)
        left[k] = std::max(0.0f, all[k] - before[k]) / place.throughput[k];
    return luminance(left);
  }
  std::vector<Sighting>& sightings_;
  std::array<Place, 32> places_;
  size_t count_ = 0;
  bool full_ = false;
};

}  // namespace vug::render
