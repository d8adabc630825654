// SPDX-License-Identifier: Apache-2.0
// Named networks of a scene, the plans of its caves, and the points on them.
#pragma once

#include <vug/field/kind.h>
#include <vug/field/noise.h>
#include <vug/network/network.h>

#include <memory>

namespace vug::shot {

/// A network that was computed or read once and is shared by all that use it.
using NetworkPtr = std::shared_ptr<const network::Network>;

/// The largest width and height of passages in metres; the largest halls measure hundreds.
inline constexpr double kLargestPassage = 1e4;

/// The kinds of networks listed in CMakeLists.txt.
const Kinds<NetworkPtr>& network_kinds();
using NetworkKind = Kind<NetworkPtr>;
/// Begins the definition of the function that the source of a network kind exports.
#define VUG_NETWORK_KIND(name) VUG_EXPORT_KIND(vug::shot, NetworkKind, name##_network)

/// The kinds of points listed in CMakeLists.txt, e.g. a station of a network.
const Kinds<Vec3d>& point_kinds();
using PointKind = Kind<Vec3d>;
/// Begins the definition of the function that the source of a point kind exports.
#define VUG_POINT_KIND(name) VUG_EXPORT_KIND(vug::shot, PointKind, name##_point)

/// The kinds of lists of points listed in CMakeLists.txt, e.g. all junctions of a network.
const Kinds<std::vector<Vec3d>>& point_list_kinds();
using PointListKind = Kind<std::vector<Vec3d>>;
/// Begins the definition of the function that the source of such a kind exports.
#define VUG_POINT_LIST_KIND(name) VUG_EXPORT_KIND(vug::shot, PointListKind, name##_points)

/// The kinds of fields that are made from networks, as listed in CMakeLists.txt; they belong to the
/// registry of fields.
const Kinds<field::Field>& network_field_kinds();
using NetworkFieldKind = field::FieldKind;
/// Begins the definition of the function that the source of such a kind exports.
#define VUG_NETWORK_FIELD_KIND(name) \
  VUG_EXPORT_KIND(vug::shot, NetworkFieldKind, name##_network_field)

/// The kinds of noises that follow networks, as listed in CMakeLists.txt; they belong to the
/// registry of noises.
const Kinds<field::Noise>& network_noise_kinds();
using NetworkNoiseKind = field::NoiseKind;
/// Begins the definition of the function that the source of such a kind exports.
#define VUG_NETWORK_NOISE_KIND(name) \
  VUG_EXPORT_KIND(vug::shot, NetworkNoiseKind, name##_network_noise)

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<shot::NetworkPtr> : ObjectTraits<shot::NetworkPtr> {
  static constexpr const char* kWord = "network";
};

}  // namespace vug
