// SPDX-License-Identifier: Apache-2.0
#include <vug/base/frames.h>
#include <vug/field/boolean.h>
#include <vug/field/opaque.h>
#include <vug/flora/sweep_field.h>
#include <vug/mesh/box_tree.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace vug::flora {
namespace {

/// The exact distance to the convex hull of two balls; see field/primitives/tapered_capsule.cpp.
struct Capsule {
  Vec3d a, axis;
  double length, radius_a, radius_b, sine, cosine;

  Capsule(const Vec3d& from, const Vec3d& to, double at_from, double at_to)
      : a(from),
        axis((to - from).normalized()),
        length((to - from).length()),
        radius_a(at_from),
        radius_b(at_to) {
    // If one ball contains the other there is no slanted part: use the hull of two equal balls,
    // which contains both.
    if (std::fabs(radius_a - radius_b) >= 0.9 * length)
      radius_a = radius_b = std::max(at_from, at_to);
    sine = (radius_a - radius_b) / length;
    cosine = std::sqrt(1 - sine * sine);
  }
  double distance(const Vec3d& p) const {
    const Vec3d from_a = p - a;
    const double y = from_a.dot(axis), x = (from_a - axis * y).length();
    const double foot = y - x * sine / cosine;
    if (foot < 0) return std::sqrt(x * x + y * y) - radius_a;
    if (foot > length) return std::sqrt(x * x + (y - length) * (y - length)) - radius_b;
    return x * cosine + y * sine - radius_a;
  }
  Vec3d gradient(const Vec3d& p) const {
    const Vec3d from_a = p - a;
    const double y = from_a.dot(axis);
    const Vec3d aside = from_a - axis * y;
    const double x = aside.length(), foot = y - x * sine / cosine;
    const Vec3d out = x > 0 ? aside / x : level_frame(axis).normal;
    if (foot < 0) return (out * x + axis * y).normalized();
    if (foot > length) return (out * x + axis * (y - length)).normalized();
    return out * cosine + axis * sine;
  }
  Box3d bounds() const {
    return united(grown(Box3d(a), radius_a), grown(Box3d(a + axis * length), radius_b));
  }
};

/// A tube and the capsules that enclose it.
class Stem {
 public:
  explicit Stem(Tube tube) : tube_(std::move(tube)) {
    const std::vector<Ring>& rings = tube_.rings();
    constexpr double kSlack = 1 + 1e-6;  // Cross-sections are slightly inclined to the capsules.
    std::vector<Box3d> boxes;
    for (size_t i = 0; i + 1 < rings.size(); ++i) {
      capsules_.emplace_back(rings[i].center, rings[i + 1].center, tube_.reach(i) * kSlack,
                             tube_.reach(i + 1) * kSlack);
      boxes.push_back(capsules_.back().bounds());
      bounds_ = united(bounds_, boxes.back());
    }
    tree_ = mesh::BoxTree(boxes);
  }
  const Box3d& bounds() const { return bounds_; }
  const Tube& tube() const { return tube_; }

  /// The nearest part of the stem.
  struct StemHit {
    double value = kInfinity;
    size_t capsule = 0;
    std::optional<Tube::Coordinates> coords;  ///< Empty: the capsules bound the value.
  };

  /// The value at p, or any number above `limit` if the value is not below it.
  StemHit find(const Vec3d& p, double limit) const {
    double outer = std::max(limit, 0.0);
    if (outer == 0) outer = 1e-300;  // Boxes that contain p still count.
    StemHit found{kInfinity, capsules_.size(), {}};
    tree_.visit_nearest(p, square(outer), [&](uint32_t i) {
      const double d = capsules_[i].distance(p);
      if (d < found.value) found.value = d, found.capsule = i;
      return square(std::max(0.0, std::min(outer, found.value)));
    });
    if (found.capsule == capsules_.size() || found.value >= limit) return {};
    // Beyond this distance the capsules give the greater value for any displacement, and
    // cross-sections may intersect.
    const double slope = tube_.slope(), a = tube_.reach(found.capsule),
                 b = tube_.reach(found.capsule + 1);
    const double most =
        std::fabs(a - b) + tube_.displacement().highest() + tube_.displacement().deepest();
    if (found.value * (slope - 1) > most + 0.25 * std::max(a, b)) return found;
    const Tube::Coordinates coords = tube_.coordinates(p, found.capsule);
    const double near = tube_.value(coords) / slope;
    if (near >= found.value) found.value = near, found.coords = coords;
    return found;
  }
  Vec3d gradient(const Vec3d& p, const StemHit& found) const {
    if (!found.coords) return capsules_[found.capsule].gradient(p);
    return tube_.gradient(p, *found.coords).gradient / tube_.slope();
  }

 private:
  static double square(double x) { return x * x; }

  Tube tube_;
  std::vector<Capsule> capsules_;
  mesh::BoxTree tree_;
  Box3d bounds_;
};

class Stems {
 public:
  explicit Stems(std::vector<Tube> tubes) {
    std::vector<Box3d> boxes;
    for (Tube& tube : tubes) {
      stems_.emplace_back(std::move(tube));
      boxes.push_back(stems_.back().bounds());
    }
    tree_ = mesh::BoxTree(boxes);
  }
  const Box3d& bounds() const { return tree_.bounds(); }
  std::vector<Tube> tubes() const {
    std::vector<Tube> all;
    for (const Stem& stem : stems_) all.push_back(stem.tube());
    return all;
  }

  double value(const Vec3d& p) const { return find(p).second.value; }
  field::Gradient sample(const Vec3d& p) const {
    const auto [stem, found] = find(p);
    return {found.value, stem->gradient(p, found)};
  }

 private:
  std::pair<const Stem*, Stem::StemHit> find(const Vec3d& p) const {
    std::pair<const Stem*, Stem::StemHit> least{nullptr, {}};
    tree_.visit_nearest(p, kInfinity, [&](uint32_t i) {
      const Stem::StemHit found = stems_[i].find(p, least.second.value);
      if (found.value < least.second.value) least = {&stems_[i], found};
      const double reach = std::max(0.0, least.second.value);
      return reach * reach;
    });
    return least;
  }

  std::vector<Stem> stems_;
  mesh::BoxTree tree_;
};

struct SweepSource {
  std::shared_ptr<const Stems> stems;

  double value(const Vec3d& p) const { return stems->value(p); }
  field::Gradient sample(const Vec3d& p) const { return stems->sample(p); }
  void add_to(Digester& digester) const { digester(stems->tubes()); }
};

}  // namespace

field::Field swept(std::vector<Tube> tubes) {
  if (tubes.empty()) return field::empty();
  SweepSource source{std::make_shared<const Stems>(std::move(tubes))};
  field::Traits traits;
  traits.exactness = field::Exactness::bound;
  traits.bounds = source.stems->bounds();
  traits.growth = 1;
  return field::Field(
      std::make_shared<field::OpaqueNode<SweepSource>>("swept", traits, std::move(source)));
}

std::vector<Tube> tubes_of(const field::Field& field) {
  const auto* node = dynamic_cast<const field::OpaqueNode<SweepSource>*>(field.node().get());
  return node ? node->source().stems->tubes() : std::vector<Tube>();
}

}  // namespace vug::flora
