// The template of blocks.h.
#pragma once

namespace vug::facade {

template <class P>
void describe_opening(Schema<P>& s) {
  const auto length = [](std::string doc) {
    return ParamSpec{.doc = std::move(doc), .dimension = Dimension::length, .min = 0};
  };
  s.param("reveal", &P::reveal, length("how deep the hole is before what closes it"))
      .template choice<Head>("head", static_cast<Head P::*>(&P::head),
                             {{"flat", Head::flat},
                              {"segmental", Head::segmental},
                              {"round", Head::round},
                              {"pointed", Head::pointed}},
                             "how the opening ends above")
      .param("rise", &P::rise, length("of its arch; 0: that of the kind of head"))
      .param("frame", &P::frame, length("width of the moulding around it, outside; 0: none"))
      .param("frame_depth", &P::frame_depth, length("how far the moulding stands out"))
      .param("sill", &P::sill, length("how far the sill stands out; 0: none"))
      .param("sill_height", &P::sill_height, length("of the sill, below the opening"))
      .param("lintel", &P::lintel, length("how far the lintel stands out; 0: none"))
      .param("lintel_height", &P::lintel_height, length("of the lintel, above the opening"))
      .param("keystone", &P::keystone, length("how far the keystone stands out; 0: none"));
}

}  // namespace vug::facade
