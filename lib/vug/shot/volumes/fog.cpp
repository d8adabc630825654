// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/volume_kinds.h>

namespace vug::shot {

const Kind<VolumePtr>& fog_volume() {
  static const Kind<VolumePtr> kind = volume_kind(
      volume_schema("fog", "Density 1 inside a field's solid, fading to 0 across the band."), true);
  return kind;
}

}  // namespace vug::shot
