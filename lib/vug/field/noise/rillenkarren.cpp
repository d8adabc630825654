// SPDX-License-Identifier: Apache-2.0
// Rillenkarren: grooves that rain dissolves into bare limestone, straight down from a crest. They
// lie side by side, with a parabolic cross-section and sharp ridges, and fade downhill.
#include <vug/base/rng.h>
#include <vug/field/lattice.h>
#include <vug/field/noise_node.h>
#include <vug/field/speleogens/frame.h>

namespace vug::field {
namespace {

struct Rillenkarren {
  double width = 0.02;
  double length = 0.3;
  Vec3d downhill{1, -1, 0};
  Vec3d crest{0, 0, 0};
  int seed = 1;

  static void describe(Schema<Rillenkarren>& s) {
    s.doc(
         "Rain grooves down a slope of bare rock on both sides of a crest: -1 in a groove at the "
         "crest, 0 on the sharp ridges and where the grooves have faded. Real ones are half as "
         "deep as wide at most.")
        .cite("glew1980")
        .param("width", &Rillenkarren::width,
               positive_length("mean width of a groove, 1 cm to 3 cm"))
        .param("length", &Rillenkarren::length,
               positive_length("mean length of a groove, 10 cm to 1 m"))
        .param("downhill", &Rillenkarren::downhill,
               {.doc = "direction of steepest descent on the slope, of any length but 0"})
        .param("crest", &Rillenkarren::crest,
               any_length("a point of the crest where the grooves begin"))
        .param("seed", &Rillenkarren::seed,
               {.doc = "random seed; each seed gives different grooves"});
  }
  std::string fault() const {
    return downhill.length2() > 0 ? "" : "the slope must have a direction downhill";
  }
};

class RainGrooves {
 public:
  explicit RainGrooves(const Rillenkarren& r)
      : down_(r.downhill.normalized()),
        side_(Across(r.downhill).side),
        crest_(r.crest),
        width_(r.width),
        length_(r.length),
        seed_(RandomStream(RandomKey(static_cast<uint64_t>(r.seed)).at("rillenkarren")).bits()) {}

  template <class T>
  T at(const Point<T>& p) const {
    const Point<T> offset = p - constant<T>(crest_);
    const T across = dot(offset, constant<T>(side_)) * T(1 / width_);
    const T down = abs(dot(offset, constant<T>(down_))) * T(1 / length_);
    const T k = floor(across), one(1.0);
    T deepest(0.0);
    for (const double step : {-1, 0, 1}) {
      const T cell = k + T(step);
      // A groove between the middles of its ridges, of which each shares one with its neighbour.
      const T left = ridge(cell), right = ridge(cell + one);
      const T x = (across - (left + right) * T(0.5)) / (right - left);
      const T reach = T(kShortest) + lattice_random(cell, seed_ ^ 0x7f4a7c15u) * T(kVariation);
      const T section = max(one - square(x) * T(4.0), T(0.0));
      deepest = max(deepest, section * max(one - down / reach, T(0.0)));
    }
    return -deepest;
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  Interval range() const { return {-1, 0}; }
  /// 4 over the width at a ridge, for the narrowest; 1 over the length along the shortest groove.
  double lipschitz() const {
    const double across = 4 / (kNarrowest * width_), along = 1 / (kShortest * length_);
    return std::sqrt(across * across + along * along);
  }

 private:
  static constexpr double kNarrowest = 0.5, kShortest = 0.6, kVariation = 0.8;
  template <class T>
  T ridge(const T& cell) const {
    return cell + lattice_random(cell, seed_) * T(1 - kNarrowest);
  }
  Vec3d down_, side_, crest_;
  double width_, length_;
  uint32_t seed_;
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(rillenkarren) {
  return noise_kind<Rillenkarren>("rillenkarren",
                                  [](const Rillenkarren& r) { return RainGrooves(r); });
}
