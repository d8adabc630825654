// SPDX-License-Identifier: Apache-2.0
// Features of the rock and of the water from which `karst` grows a network: beds, joints, springs.
#pragma once

#include <vug/field/kind.h>
#include <vug/karst/geology.h>

#include <functional>
#include <memory>

namespace vug::shot {

/// Adds one feature to a geology.
using GeologyFeature = std::function<void(karst::Geology&)>;
using GeologyFeaturePtr = std::shared_ptr<const GeologyFeature>;

/// The kinds listed in CMakeLists.txt.
const Kinds<GeologyFeaturePtr>& geology_kinds();
using GeologyKind = Kind<GeologyFeaturePtr>;

/// A kind whose parameter struct P has `static void describe(Schema<P>&)` and
/// `void add(karst::Geology&) const`.
template <class P>
GeologyKind geology_kind(std::string name) {
  return make_kind<GeologyFeaturePtr, P>(
      std::move(name), "geology", [](const P& params) -> GeologyFeaturePtr {
        return std::make_shared<const GeologyFeature>(
            [params](karst::Geology& geology) { params.add(geology); });
      });
}

/// A parameter with the compass direction of a line or of a fall.
inline ParamSpec compass(std::string doc) {
  return {.doc = std::move(doc) + ", clockwise from north (-z) seen from above",
          .dimension = Dimension::angle};
}
/// A parameter with the steepness of a plane.
inline ParamSpec dip_angle(std::string doc, double most) {
  return {.doc = std::move(doc), .dimension = Dimension::angle, .min = 0, .max = most};
}

/// The parameter of a feature at one point.
inline ParamSpec position() {
  return {.doc = "its position", .dimension = Dimension::length, .required = true};
}

/// The parameters of a feature that is a plane: a bed or a water table.
struct LayerFeature {
  Vec3d at{0, 0, 0};
  double dip = 0;
  double towards = 0;

  template <class P>
  static void describe(Schema<P>& s) {
    s.param("at", &LayerFeature::at, any_length("a point of the plane"))
        .param("dip", &LayerFeature::dip, dip_angle("steepness of the plane", 85 * kPi / 180))
        .param("towards", &LayerFeature::towards, compass("direction in which it falls"));
  }
  karst::Layer layer() const { return {.point = at, .dip = dip, .dip_azimuth = towards}; }
};

/// Begins the definition of the function that the source of such a kind exports.
#define VUG_GEOLOGY_KIND(name) VUG_EXPORT_KIND(vug::shot, GeologyKind, name##_geology)

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<shot::GeologyFeaturePtr> : ObjectTraits<shot::GeologyFeaturePtr> {
  static constexpr const char* kWord = "geology";
};

}  // namespace vug
