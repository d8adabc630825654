// SPDX-License-Identifier: Apache-2.0
// Meander niches: alcoves that a stream undercuts in the outer bank of each bend, alternately in
// the left and the right wall. Older ones, higher up, lie upstream of those that the stream cuts
// today.
#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/field/noise_node.h>
#include <vug/field/speleogens/frame.h>
#include <vug/field/speleogens/notch_profile.h>

#include <vector>

namespace vug::field {
namespace {

struct MeanderNiche {
  std::vector<double> levels{0};
  double height = 0.8;
  double roof = 0.15;
  double wavelength = 10;
  double migration = 2;
  Vec3d flow{1, 0, 0};
  Vec3d middle{0, 0, 0};
  double width = 1;
  int seed = 1;

  static void describe(Schema<MeanderNiche>& s) {
    s.doc(
         "Niches in the outer banks of the meanders of a stream: -1 at the roof of a niche, 0 "
         "elsewhere. They lie in turn on both sides of a line.")
        .param("levels", &MeanderNiche::levels,
               {.doc = "heights of the roofs of the niches", .dimension = Dimension::length})
        .param("height", &MeanderNiche::height, positive_length("height of a niche"))
        .param("roof", &MeanderNiche::roof,
               {.doc = "height of the roof's edge, as a fraction of the height",
                .dimension = Dimension::ratio,
                .min = 0.02,
                .max = 1})
        .param("wavelength", &MeanderNiche::wavelength,
               positive_length("length of a meander, about ten widths of the stream"))
        .param(
            "migration", &MeanderNiche::migration,
            any_length("distance by which a niche lies downstream of one that is a metre higher"))
        .param("flow", &MeanderNiche::flow,
               {.doc = "direction of the stream in plan, not vertical"})
        .param("middle", &MeanderNiche::middle,
               any_length("a point of the line between the two walls"))
        .param("width", &MeanderNiche::width,
               positive_length("distance between the walls: the niches are as deep as stated at "
                               "half of it from the line"))
        .param("seed", &MeanderNiche::seed, {.doc = "random seed; moves the meanders"});
  }
  std::string fault() const {
    if (levels.empty()) return "niches need at least one level";
    return flow.x * flow.x + flow.z * flow.z > 0 ? "" : "the flow must not be vertical";
  }
};

class Niches {
 public:
  explicit Niches(const MeanderNiche& m)
      : m_(m), profile_{m.height, m.roof}, turns_(2 * kPi / m.wavelength) {
    along_ = Vec3d(m.flow.x, 0, m.flow.z).normalized();
    side_ = Across(along_).side;
    phase_ = 2 * kPi *
             RandomStream(RandomKey(static_cast<uint64_t>(m.seed)).at("meander_niche")).uniform();
  }

  template <class T>
  T at(const Point<T>& p) const {
    const Point<T> q = p - constant<T>(m_.middle);
    const T s = dot(q, constant<T>(along_));
    const T off = clamp(dot(q, constant<T>(side_)) * T(2 / m_.width), T(-1.0), T(1.0));
    T depth(0.0);
    for (const double level : m_.levels) {
      const T wave = sin(s * T(turns_) + T(phase_ + m_.migration * level * turns_));
      depth = max(depth, profile_.depth(T(level) - p.y) * max(wave * off, T(0.0)));
    }
    return -depth;
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  Interval range() const { return {-1, 0}; }
  double lipschitz() const { return profile_.slope() + turns_ + 2 / m_.width; }

 private:
  MeanderNiche m_;
  NotchProfile profile_;
  Vec3d along_, side_;
  double turns_, phase_ = 0;
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(meander_niche) {
  return noise_kind<MeanderNiche>("meander_niche", [](const MeanderNiche& m) { return Niches(m); });
}
