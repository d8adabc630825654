// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/raytree/embree_device.h>

#include <fmt/format.h>

namespace vug::raytree {

// The same instruction set on every machine: wider ones would choose other triangles at exact ties.
EmbreeDevice::EmbreeDevice()
    : device_(rtcNewDevice("isa=avx2,set_affinity=0,start_threads=0,verbose=0")) {
  if (!device_)
    throw Error(ErrorCode::internal, "the ray tracing library does not start on this machine");
}

EmbreeDevice::~EmbreeDevice() { rtcReleaseDevice(device_); }

void EmbreeDevice::check(const char* doing) const {
  const RTCError code = rtcGetDeviceError(device_);
  if (code == RTC_ERROR_NONE) return;
  throw Error(
      code == RTC_ERROR_OUT_OF_MEMORY ? ErrorCode::too_large : ErrorCode::internal,
      fmt::format("{} failed in the ray tracing library (code {})", doing, static_cast<int>(code)));
}

}  // namespace vug::raytree
