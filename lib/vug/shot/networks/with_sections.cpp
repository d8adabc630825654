// SPDX-License-Identifier: Apache-2.0
// Widths and heights for the stations of a network that have none.
#include <vug/shot/networks.h>
#include <vug/shot/section_model_choice.h>

namespace vug::shot {
namespace {

struct WithSections {
  NetworkPtr of;
  std::string like = "usual";
  double size = 1;
  int seed = 0;

  static void describe(Schema<WithSections>& s) {
    s.doc(
         "The network with widths and heights at the stations that had none. They vary along the "
         "passages as in real caves; stations near measured ones depend on them.")
        .param("of", &WithSections::of, {.doc = "the network", .required = true})
        .choice("like", &WithSections::like, section_model_names(),
                "the surveyed caves whose statistics apply; usual: between them")
        .param("size", &WithSections::size,
               {.doc = "factor of widths and heights", .min = 0, .above_min = true})
        .param("seed", &WithSections::seed, {.doc = "selects other sizes", .min = 0});
  }
};

NetworkPtr draw(const WithSections& p) {
  network::SectionModel model = section_model(p.like);
  model.width_median *= p.size;
  model.height_median *= p.size;
  return std::make_shared<const network::Network>(
      network::draw_sections(*p.of, model, static_cast<uint64_t>(p.seed)));
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_KIND(with_sections) {
  return make_kind<NetworkPtr, WithSections>("with_sections", "network", draw);
}
