// SPDX-License-Identifier: Apache-2.0
// Detection of the instruction sets that this build requires, x86-64-v3. The source is compiled for
// plain x86-64 and uses no inline functions of other headers, so that it runs on any processor.
#pragma once

namespace vug {

/// An instruction set and whether the processor and the operating system support it.
struct CpuFeature {
  const char* name;
  bool present;
};

/// The names of the absent features, separated by ", "; empty if all are present. The text is valid
/// until the next call. Not thread-safe.
const char* missing_features(const CpuFeature* features, int count);

/// The instruction sets of x86-64-v3 that this processor lacks; see missing_features. May be called
/// before static objects are constructed.
const char* missing_cpu_features();

}  // namespace vug
