// SPDX-License-Identifier: Apache-2.0
// The elements of a network that can be dressed: legs, junctions and ends, each with a frame.
#pragma once

#include <vug/base/transform.h>
#include <vug/network/network.h>

namespace vug::network {

enum class ElementKind {
  leg,
  junction,  ///< A station at which at least three legs meet.
  end,       ///< A station with one leg.
  sump,      ///< An end at which the passage continues under water.
};

struct Element {
  ElementKind kind = ElementKind::leg;
  int index = 0;  ///< In Network::legs or Network::stations.
  int legs = 0;   ///< The number of legs that meet at a station; 1 for a leg.
  /// From the element's own space to scene space: y is up, or across the leg. The origin of a leg
  /// is its middle, and x points downstream; that of a station is the station, and x points along
  /// its first leg, at an end out of the cave.
  Transform frame;
};

/// The elements of a kind, in the order of the network. Surface legs, duplicates and legs without
/// length do not count. An end is a sump, not an end, if it is neither an entrance nor a sink nor a
/// spring, and either the last level of its name starts with "sump" or its leg formed below the
/// present water table.
std::vector<Element> elements(const Network& network, ElementKind kind);

/// Width and height in metres; nothing if no station of the element has both distances to the
/// walls.
struct ElementSize {
  std::optional<double> width;
  std::optional<double> height;
};

/// The size of a station's cross-section, or the mean of both ends of a leg.
ElementSize size_of(const Network& network, const Element& element);

}  // namespace vug::network
