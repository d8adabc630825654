// SPDX-License-Identifier: Apache-2.0
// Template definition of blocks.h.
#pragma once

namespace vug::facade {

template <class P>
void describe_opening(Schema<P>& s) {
  const auto length = [](std::string doc) {
    return ParamSpec{.doc = std::move(doc), .dimension = Dimension::length, .min = 0};
  };
  s.param("reveal", &P::reveal, length("depth of the hole in front of its pane or leaf"))
      .template choice<Head>("head", static_cast<Head P::*>(&P::head),
                             {{"flat", Head::flat},
                              {"segmental", Head::segmental},
                              {"round", Head::round},
                              {"pointed", Head::pointed}},
                             "shape of the opening's top")
      .param("rise", &P::rise, length("rise of the arch; 0: the default of the head"))
      .param("frame", &P::frame, length("width of the moulding around the opening; 0: none"))
      .param("frame_depth", &P::frame_depth, length("projection of the moulding"))
      .param("sill", &P::sill, length("projection of the sill; 0: none"))
      .param("sill_height", &P::sill_height, length("height of the sill, below the opening"))
      .param("lintel", &P::lintel, length("projection of the lintel; 0: none"))
      .param("lintel_height", &P::lintel_height, length("height of the lintel, above the opening"))
      .param("keystone", &P::keystone, length("projection of the keystone; 0: none"));
}

}  // namespace vug::facade
