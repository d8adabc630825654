// SPDX-License-Identifier: Apache-2.0
// Inside flora/ only: parameters shared by the kinds of leaves.
#pragma once

#include <vug/flora/leaf.h>
#include <vug/flora/shape.h>

namespace vug::flora {

struct LeafParams {
  double length = LeafOptions().length;
  double width = LeafOptions().width;
  double widest = paint::LeafOutline().widest;
  double tip = paint::LeafOutline().tip;
  double bend = LeafOptions().bend;
  double fold = LeafOptions().fold;
  double twist = 0;
  int rows = LeafOptions().rows;
  bool card = false;

  LeafOptions options() const {
    return {length, width, {widest, tip}, bend, fold, twist, rows, card};
  }
};

template <class P>
void describe_leaf(Schema<P>& s) {
  const auto angle = [](std::string doc) {
    return ParamSpec{.doc = std::move(doc), .dimension = Dimension::angle, .min = -kPi, .max = kPi};
  };
  s.param("length", &LeafParams::length, positive_length("from its base to its tip"))
      .param("width", &LeafParams::width, positive_length("at the widest point, laid flat"))
      .param("widest", &LeafParams::widest,
             {.doc = "share of the length at which it is widest", .min = 0.05, .max = 0.95})
      .param("tip", &LeafParams::tip,
             {.doc = "taper of the tip; larger values make it longer and finer",
              .min = 0.1,
              .max = 10})
      .param("bend", &LeafParams::bend, angle("by which the tip points further down than the base"))
      .param("fold", &LeafParams::fold, angle("by which each half rises from the flat"))
      .param("twist", &LeafParams::twist, angle("about the midrib, from base to tip"))
      .param("rows", &LeafParams::rows, {.doc = "segments along its length", .min = 2, .max = 1000})
      .param("card", &LeafParams::card,
             {.doc = "a plain strip; the opacity leaf_blade() cuts out its outline"});
}

}  // namespace vug::flora
