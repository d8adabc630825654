// SPDX-License-Identifier: Apache-2.0
// The parameters of the kinds that follow the axes of passages: those of `passages` that affect
// them, with the same defaults.
#pragma once

#include <vug/passages/passages.h>
#include <vug/shot/networks.h>

namespace vug::shot {

struct PassageLine {
  NetworkPtr of;
  double width = passages::DefaultSize().width;
  double height = passages::DefaultSize().height;
  double sinuosity = passages::MeanderOptions().sinuosity;
  bool smooth = true;

  /// Adds the network to the schema of a struct that is derived from this one.
  template <class P>
  static void describe_network(Schema<P>& s) {
    s.param("of", &PassageLine::of, {.doc = "the network", .required = true});
  }
  /// Adds the other parameters.
  template <class P>
  static void describe_axes(Schema<P>& s) {
    s.param("width", &PassageLine::width, positive_length("where it was not measured"))
        .param("height", &PassageLine::height, positive_length("where it was not measured"))
        .param(
            "sinuosity", &PassageLine::sinuosity,
            {.doc = "length of a stream's meanders over that of the valley", .min = 1, .max = 3.5})
        .param("smooth", &PassageLine::smooth, {.doc = "curves through the stations"});
  }

  passages::PassageOptions options() const {
    passages::PassageOptions out;
    out.size.width = width;
    out.size.height = height;
    out.meanders.sinuosity = sinuosity;
    out.smooth = smooth;
    return out;
  }
};

}  // namespace vug::shot
