// SPDX-License-Identifier: Apache-2.0
// Ridges where the noise crosses zero, (1 - |n|)^2, each octave weighted by the previous one, so
// that fine ridges appear on coarse ones and valleys stay smooth (musgrave1989). The weight is the
// previous octave's own height, not the running product, which keeps the slope bounded.
#include <vug/field/octaves.h>

namespace vug::field {
namespace {

struct Ridged : OctaveParams {
  static void describe(Schema<Ridged>& s) {
    describe_octaves(s.doc("Sharp ridges, finer ones on coarser ones.").cite("musgrave1989"));
  }
  void add_to(Digester& digester) const { digester(static_cast<const OctaveParams&>(*this)); }
};

class Ridges {
 public:
  explicit Ridges(const OctaveParams& params) : octaves_(params) {
    for (int i = 0; i < octaves_.count(); ++i) total_ += octaves_.weight(i);
  }

  template <class T>
  T at(const Point<T>& p) const {
    return sum<T>([&](int i) { return octaves_.noise(i, p); });
  }
  Interval over(const Ball& ball) const {
    return intersection(sum<Interval>([&](int i) { return octaves_.noise(i, ball); }), range());
  }
  Interval range() const { return {-1, 1}; }
  double lipschitz() const {
    double total = 0;
    for (int i = 0; i < octaves_.count(); ++i)
      total += octaves_.weight(i) * 2 * (octaves_.slope(i) + (i > 0 ? octaves_.slope(i - 1) : 0));
    return 2 * total / total_;
  }

 private:
  template <class T, class Sample>
  T sum(const Sample& sample) const {
    T total(0.0), before(1.0);
    for (int i = 0; i < octaves_.count(); ++i) {
      const T ridge = square(T(1.0) - min(abs(sample(i)), T(1.0)));
      total = total + ridge * before * T(octaves_.weight(i));
      before = ridge;
    }
    return total * T(2 / total_) - T(1.0);
  }
  Octaves octaves_;
  double total_ = 0;
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(ridged) {
  return noise_kind<Ridged>("ridged", [](const Ridged& p) { return Ridges(p); });
}
