// SPDX-License-Identifier: Apache-2.0
// Widths and heights for the stations of a network that have none.
#include <vug/shot/networks.h>
#include <vug/shot/section_choice.h>

namespace vug::shot {
namespace {

struct WithSections : SectionChoice {
  NetworkPtr of;
  int seed = 0;

  static void describe(Schema<WithSections>& s) {
    s.doc(
         "The network with widths and heights at the stations that had none. They vary along the "
         "passages as in real caves; stations near measured ones depend on them.")
        .param("of", &WithSections::of, {.doc = "the network", .required = true})
        .param("seed", &WithSections::seed, {.doc = "selects other sizes", .min = 0});
    SectionChoice::describe(s);
  }
};

NetworkPtr draw(const WithSections& p) {
  return std::make_shared<const network::Network>(
      network::draw_sections(*p.of, p.model(), static_cast<uint64_t>(p.seed)));
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_KIND(with_sections) {
  return make_kind<NetworkPtr, WithSections>("with_sections", "network", draw);
}
