// SPDX-License-Identifier: Apache-2.0
// The time in which a karst network grows on 20,000 samples; the target is 10 seconds.
#include <fmt/format.h>
#include <vug/karst/generate.h>
#include <vug/karst/presets.h>

#include <chrono>

int main() {
  using namespace vug;
  for (const karst::Preset& preset : karst::presets()) {
    karst::KarstOptions options = preset.options;
    options.samples.count = 20000;
    const auto start = std::chrono::steady_clock::now();
    const network::Network network = karst::generate(preset.geology, options);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    fmt::print("{:18} {:6} legs {:8.2f} s\n", preset.name, network.legs.size(), seconds.count());
  }
  return 0;
}
