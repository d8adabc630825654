// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/volume_kinds.h>

namespace vug::shot {

const Kind<VolumePtr>& level_set_volume() {
  static const Kind<VolumePtr> kind = volume_kind(
      volume_schema("level_set",
                    "A narrow band of values around a field's surface, negative inside: distances, "
                    "or bounds of them.")
          .param("repair", &VolumePlan::repair,
                 {.doc = "turn values of blended, morphed or displaced fields into first-order "
                         "distances"})
          .choice(
              "distance", &VolumePlan::distance,
              {{"automatic", DistanceValues::automatic},
               {"bound", DistanceValues::bound},
               {"exact", DistanceValues::exact}},
              "values in files: bounds of the distance, which outside sharp edges are too small, "
              "or Euclidean distances; automatic: exact in exports, bound in builds"),
      false);
  return kind;
}

}  // namespace vug::shot
