// SPDX-License-Identifier: Apache-2.0
// Cross-sections of passages: signed distances in the plane across a passage, and the families of
// sections that scenes name (tube, canyon, keyhole, ...).
#pragma once

#include <vug/base/digester.h>
#include <vug/base/kind.h>
#include <vug/base/vec.h>
#include <vug/field/numbers/interval.h>
#include <vug/field/numbers/pack.h>

#include <memory>
#include <optional>
#include <string_view>
#include <typeinfo>
#include <vector>

namespace vug::passages {

using field::Pack;

/// A distance in metres with its derivatives across (u) and up (v).
template <class S>
struct PlaneDistance {
  S value, du, dv;
};

/// The size of a section and other bounds of its inside, in metres.
struct SectionTraits {
  Vec2d min{0, 0};  ///< The corners of the bounding rectangle.
  Vec2d max{0, 0};
  double reach = 0;  ///< Radius of a circle about the origin that contains the inside.
  double core = 0;   ///< Radius of a circle about the origin within the inside; above 0.
  double depth = 0;  ///< No value is below -depth.
  double area = 0;   ///< Square metres.

  double width() const { return max.x - min.x; }
  double height() const { return max.y - min.y; }
};

/// The half-axes of an ellipse, perpendicular to each other.
struct EllipseAxes {
  Vec2d first, second;
};

/// The shape of a passage across its direction: u points to the right of a caver who looks along
/// the passage, v up, both in metres from the axis of the passage, which lies inside. Values are
/// negative inside and have a Lipschitz constant of 1 in the plane. They are the exact distance to
/// the outline, up to the rounding of the number type and, for shapes with rounded corners, inside
/// of concave corners, where they are a lower bound of its magnitude. Immutable; shared between
/// threads.
class Section {
 public:
  explicit Section(SectionTraits traits) : traits_(traits) {}
  virtual ~Section() = default;
  Section(const Section&) = delete;
  Section& operator=(const Section&) = delete;

  virtual PlaneDistance<double> at(double u, double v) const = 0;
  /// Batches: `count` packs of points; `out` must not overlap them.
  virtual void distances(const Pack* u, const Pack* v, int count, Pack* out) const = 0;
  virtual void slopes(const Pack* u, const Pack* v, int count, PlaneDistance<Pack>* out) const = 0;
  /// About `count` points of the outline (at least one for each corner), counterclockwise.
  virtual std::vector<Vec2d> outline(int count) const = 0;

  /// The axes of sections that are ellipses about the origin.
  virtual std::optional<EllipseAxes> ellipse() const { return std::nullopt; }
  /// Adds the name of the class and all numbers of the shape to the digest of a field.
  void add_to(Digester& digester) const {
    digester(std::string_view(typeid(*this).name()));
    add_numbers_to(digester);
  }

  double distance(double u, double v) const { return at(u, v).value; }
  /// Bounds of the distance over a rectangle, from its centre and the Lipschitz constant.
  Interval interval(Interval u, Interval v) const;
  const SectionTraits& traits() const { return traits_; }

 protected:
  virtual void add_numbers_to(Digester& digester) const = 0;

 private:
  SectionTraits traits_;
};
using SectionPtr = std::shared_ptr<const Section>;

/// Implements the evaluation modes for Derived from one template, for S double or Pack:
///   template <class S> PlaneDistance<S> sample(const S& u, const S& v) const;
template <class Derived>
class SectionModes : public Section {
 public:
  using Section::Section;
  PlaneDistance<double> at(double u, double v) const final { return self().sample(u, v); }
  void distances(const Pack* u, const Pack* v, int count, Pack* out) const final {
    for (int i = 0; i < count; ++i) out[i] = self().sample(u[i], v[i]).value;
  }
  void slopes(const Pack* u, const Pack* v, int count, PlaneDistance<Pack>* out) const final {
    for (int i = 0; i < count; ++i) out[i] = self().sample(u[i], v[i]);
  }

 private:
  const Derived& self() const { return static_cast<const Derived&>(*this); }
};

/// The place for which a section is made.
struct SectionPlace {
  double width = 1;      ///< Metres, above 0.
  double height = 1;     ///< Metres, above 0.
  double curvature = 0;  ///< Bend in plan, 1/m, positive where the passage turns left.
};

/// Throws Error(bad_input) unless the sizes are positive and all members are finite numbers.
void require_valid(const SectionPlace& place);

/// A family of sections: the rule that makes a section of a given size. Immutable.
class SectionFamily {
 public:
  virtual ~SectionFamily() = default;
  /// The section that fills a rectangle of the place's width and height about the origin; sections
  /// that migrate with the curvature may extend beyond its sides. Throws
  /// as require_valid does.
  virtual SectionPtr fit(const SectionPlace& place) const = 0;
  /// Whether sections depend on the curvature.
  virtual bool migrates() const { return false; }
};
using SectionFamilyPtr = std::shared_ptr<const SectionFamily>;

using SectionKind = Kind<SectionFamilyPtr>;
/// Generated from the list in CMakeLists.txt.
const Kinds<SectionFamilyPtr>& sections();

/// The family of that kind, e.g. make_family("tube").
SectionFamilyPtr make_family(const std::string& name, const NamedValues& parameters = {});

/// A kind whose parameter struct P has `static void describe(Schema<P>&)` and
/// `SectionPtr fit(const SectionPlace&) const`, and a member `migration` if sections depend on the
/// curvature.
template <class P>
SectionKind section_kind(std::string name) {
  struct Family final : SectionFamily {
    explicit Family(const P& p) : params(p) {}
    SectionPtr fit(const SectionPlace& place) const override {
      require_valid(place);
      return params.fit(place);
    }
    bool migrates() const override {
      return requires { params.migration; };
    }
    P params;
  };
  return make_kind<SectionFamilyPtr, P>(
      std::move(name), "section",
      [](const P& params) -> SectionFamilyPtr { return std::make_shared<const Family>(params); });
}

/// A parameter that is a fraction of another length.
inline ParamSpec section_fraction(std::string doc, double min = 0, double max = 1) {
  return {.doc = std::move(doc), .min = min, .max = max};
}

}  // namespace vug::passages

/// Opens the one definition that the file of a section exports; see VUG_EXPORT_KIND.
#define VUG_SECTION_KIND(name) VUG_EXPORT_KIND(vug::passages, SectionKind, name##_section)

namespace vug {

/// A bare name denotes a family with default parameters.
template <>
struct ValueTraits<passages::SectionFamilyPtr> : ObjectTraits<passages::SectionFamilyPtr> {
  static constexpr const char* kWord = "section";
  static std::optional<passages::SectionFamilyPtr> read(const Value& v);
};

}  // namespace vug
