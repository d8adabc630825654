// SPDX-License-Identifier: Apache-2.0
// An Embree device: only for render/geometry/ and bvh_builder.h.
#pragma once

#include <embree3/rtcore.h>

namespace vug::raytree {

class EmbreeDevice {
 public:
  /// Throws Error(internal) if Embree does not start.
  EmbreeDevice();
  ~EmbreeDevice();
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;

  RTCDevice get() const { return device_; }
  /// Throws Error(too_large) or Error(internal) if a call has failed since the last check; `doing`
  /// names the operation in the message.
  void check(const char* doing) const;

 private:
  RTCDevice device_;
};

}  // namespace vug::raytree
