// Embree, started: for geometry*.cpp and tracing/tree_plan.h only.
#pragma once

#include <embree3/rtcore.h>

namespace vug::render {

class EmbreeDevice {
 public:
  /// Error(internal) when it does not start.
  EmbreeDevice();
  ~EmbreeDevice();
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;

  RTCDevice get() const { return device_; }
  /// Error(too_large) or Error(internal) when something has failed since the last check.
  void check(const char* doing) const;

 private:
  RTCDevice device_;
};

}  // namespace vug::render
