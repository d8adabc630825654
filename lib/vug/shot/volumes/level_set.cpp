// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/volume_kinds.h>

namespace vug::shot {

const Kind<VolumePtr>& level_set_volume() {
  static const Kind<VolumePtr> kind = volume_kind(
      volume_schema("level_set",
                    "A narrow band of signed distances around a field's surface, negative inside.")
          .param("repair", &VolumePlan::repair,
                 {.doc = "turn values of blended, morphed or displaced fields into distances"}),
      false);
  return kind;
}

}  // namespace vug::shot
