// SPDX-License-Identifier: Apache-2.0
// Noises in coordinates that follow the passages of a network.
#include <vug/passages/lines/along_flow.h>
#include <vug/shot/passage_line.h>

namespace vug::shot {
namespace {

struct FlowNoise : PassageLine {
  std::optional<field::Noise> noise;
  double stretch = passages::AlongFlowOptions().stretch;
  double blend = passages::AlongFlowOptions().blend;

  static void describe(Schema<FlowNoise>& s) {
    s.doc(
         "A noise that follows the passages of a network: its x runs downstream along the axes, y "
         "upwards and z to the right across them.")
        .param("noise", &FlowNoise::noise,
               {.doc = "the noise; scallops keep their flow of (1, 0, 0)", .required = true});
    describe_network(s);
    s.param("stretch", &FlowNoise::stretch,
            {.doc = "factor of lengths along the flow", .min = 0.01, .max = 100})
        .param("blend", &FlowNoise::blend,
               positive_length("difference of the distances to two passages at which the weight of "
                               "the farther one is 1/e"));
    describe_axes(s);
  }
};

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_NOISE_KIND(along_flow) {
  return make_kind<field::Noise, FlowNoise>("along_flow", "noise", [](const FlowNoise& p) {
    return passages::along_flow(passages::axis_lines(*p.of, p.options()), *p.noise,
                                {.stretch = p.stretch, .blend = p.blend});
  });
}
