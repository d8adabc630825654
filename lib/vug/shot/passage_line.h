// SPDX-License-Identifier: Apache-2.0
// The parameters of the kinds that follow the axes of passages: those of `passages` that affect
// them, with the same defaults.
#pragma once

#include <vug/passages/on_axes.h>
#include <vug/shot/networks.h>

namespace vug::shot {

struct PassageLine {
  NetworkPtr of;
  double width = passages::DefaultSize().width;
  double height = passages::DefaultSize().height;
  double sinuosity = passages::MeanderOptions().sinuosity;
  bool smooth = true;
  bool splays = true;

  /// Adds the network to the schema of a struct that is derived from this one.
  template <class P>
  static void describe_network(Schema<P>& s) {
    s.param("of", &PassageLine::of, {.doc = "the network", .required = true});
  }
  /// Adds the other parameters.
  template <class P>
  static void describe_axes(Schema<P>& s) {
    ParamSpec size = positive_length("where it was not measured");
    size.max = kLargestPassage;
    s.param("width", &PassageLine::width, size)
        .param("height", &PassageLine::height, size)
        .param(
            "sinuosity", &PassageLine::sinuosity,
            {.doc = "length of a stream's meanders over that of the valley", .min = 1, .max = 3.5})
        .param("smooth", &PassageLine::smooth, {.doc = "curves through the stations"})
        .param("splays", &PassageLine::splays, {.doc = "sections from splays"});
  }

  passages::PassageOptions options() const {
    passages::PassageOptions out;
    out.size.width = width;
    out.size.height = height;
    out.meanders.sinuosity = sinuosity;
    out.smooth = smooth;
    out.splays = splays;
    return out;
  }

  /// passages::on_axes of the network with the options, which is computed once.
  NetworkPtr axes() const;
};

/// The parameters of points on a network.
struct PointLine : PassageLine {
  bool middle = true;

  template <class P>
  static void describe_course(Schema<P>& s) {
    s.param("middle", &PointLine::middle,
            {.doc = "in the middle of the passages; else on the straight legs"});
    describe_axes(s);
  }

  /// The network with the legs on which the points lie.
  NetworkPtr course() const;
};

}  // namespace vug::shot
