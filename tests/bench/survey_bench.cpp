// SPDX-License-Identifier: Apache-2.0
// Reading and closing a .svx survey of 30,000 stations, with loops of different sizes. With the
// environment variable VUG_BENCH_SURVEY, the text is also written to that file, so that cavern can
// be timed with it.
#include <vug/base/atomic_file.h>
#include <vug/survey/adjust.h>
#include <vug/survey_files/format.h>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>

namespace vug::survey {
namespace {

/// 300 passages of 100 stations; every passage starts at a station of an earlier one, and every
/// second one also ends at one.
const std::string& large_survey() {
  static const std::string text = [] {
    std::string out = "*fix p0.0 1000 2000 300\n";
    for (int passage = 0; passage < 300; ++passage) {
      out += fmt::format("*begin p{}\n*date 20{:02}.07.12\n", passage, passage % 20);
      for (int i = 0; i < 99; ++i)
        out +=
            fmt::format("{} {} {:.2f} {:.1f} {:.1f}\n", i, i + 1, 4 + (i * 7 + passage) % 50 * 0.1,
                        (passage * 37 + i * 11) % 3600 * 0.1, (i * 13 + passage) % 61 - 30.0);
      out += fmt::format("*end p{}\n", passage);
      if (passage == 0) continue;
      const int parent = passage * 7919 % 1009 % passage;
      out += fmt::format("*equate p{}.0 p{}.{}\n", passage, parent, passage * 31 % 99);
      if (passage % 2 == 0)
        out += fmt::format("*equate p{}.99 p{}.{}\n", passage, passage / 2, passage * 17 % 99);
    }
    if (const char* file = std::getenv("VUG_BENCH_SURVEY")) write_text(file, out);
    return out;
  }();
  return text;
}

void read_svx(benchmark::State& state) {
  const Format& format = format_of("x.svx");
  for (auto _ : state) {
    Diagnostics warnings;
    benchmark::DoNotOptimize(format.read(large_survey(), "x.svx", {}, warnings));
  }
}
BENCHMARK(read_svx)->Unit(benchmark::kMillisecond);

void read_and_adjust(benchmark::State& state) {
  const Format& format = format_of("x.svx");
  for (auto _ : state) {
    Diagnostics warnings;
    benchmark::DoNotOptimize(adjust(
        std::get<Observations>(format.read(large_survey(), "x.svx", {}, warnings)), warnings));
  }
}
BENCHMARK(read_and_adjust)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vug::survey
