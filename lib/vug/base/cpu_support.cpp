// SPDX-License-Identifier: Apache-2.0
#include <vug/base/cpu_support.h>

#include <cpuid.h>

namespace vug {

const char* missing_features(const CpuFeature* features, int count) {
  constexpr int kSize = 160;
  static char text[kSize];
  int end = 0;
  const auto append = [&end](const char* part) {
    for (; *part != '\0' && end + 1 < kSize; ++part) text[end++] = *part;
  };
  for (int i = 0; i < count; ++i) {
    if (features[i].present) continue;
    if (end > 0) append(", ");
    append(features[i].name);
  }
  text[end] = '\0';
  return text;
}

const char* missing_cpu_features() {
  __builtin_cpu_init();
  // Compilers do not know the names of all features.
  unsigned int a = 0, b = 0, basic = 0, extended = 0, d = 0;
  if (__get_cpuid(1, &a, &b, &basic, &d) == 0) basic = 0;
  if (__get_cpuid(0x80000001, &a, &b, &extended, &d) == 0) extended = 0;
  const CpuFeature features[] = {
      {"SSE4.2", __builtin_cpu_supports("sse4.2") != 0},
      {"POPCNT", __builtin_cpu_supports("popcnt") != 0},
      {"AVX", __builtin_cpu_supports("avx") != 0},
      {"AVX2", __builtin_cpu_supports("avx2") != 0},
      {"FMA", __builtin_cpu_supports("fma") != 0},
      {"BMI1", __builtin_cpu_supports("bmi") != 0},
      {"BMI2", __builtin_cpu_supports("bmi2") != 0},
      {"F16C", (basic & bit_F16C) != 0},
      {"MOVBE", (basic & bit_MOVBE) != 0},
      {"LZCNT", (extended & bit_LZCNT) != 0},
  };
  return missing_features(features, static_cast<int>(sizeof features / sizeof features[0]));
}

}  // namespace vug
