// SPDX-License-Identifier: Apache-2.0
// For any bytes, the .svx reader and the adjustment return a survey with finite coordinates or fail
// with bad_input.
#include <vug/survey/adjust.h>
#include <vug/survey/format.h>
#include <vug/survey/statistics.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace vug;
  static const survey::Format& format = survey::format_of("fuzz.svx");
  Diagnostics warnings;
  survey::ReadOptions options;
  options.root = "a_folder_that_does_not_exist";  // *include finds no files.
  try {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const survey::Survey read = survey::adjust(
        std::get<survey::Observations>(format.read(bytes, "fuzz.svx", options, warnings)),
        warnings);
    for (const survey::Station& each : read.stations)
      if (!std::isfinite(each.position.length())) std::abort();
    const survey::Statistics statistics = survey::measure(read);
    if (statistics.loops < 0 || !std::isfinite(statistics.length)) std::abort();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input) std::abort();
  }
  return 0;
}
