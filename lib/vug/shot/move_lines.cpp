// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/cells_plan.h>
#include <vug/shot/move_lines.h>

namespace vug::shot {

void move_lines(Shot& shot, const SourceLocation& extent, int by,
                std::set<const SourceLocation*>& moved) {
  const auto move = [&](SourceLocation& where) {
    const bool inside =
        where.file == extent.file && where.line >= extent.line && where.line <= extent.end_line;
    if (!inside || !moved.insert(&where).second) return;
    where.line += by;
    if (where.has_end()) where.end_line += by;
  };
  const auto move_volume = [&](const VolumePtr& volume) {
    if (volume) move(volume->where);
  };
  for (const VolumePtr& each : shot.volumes) move_volume(each);
  for (const MeshPtr& each : shot.meshes) {
    move_volume(each->volume);
    for (CellsPtr cells = each->cells; cells; cells = cells->before) {
      move(cells->where), move(cells->spacing_where);
      for (const CellStagePtr& stage : cells->run) move(stage->location);
    }
  }
  for (ObjectPlan& each : shot.objects) move(each.where);
  for (PointInstancer& each : shot.instancers) move(each.where);
  for (CameraPlan& each : shot.cameras) move(each.where);
  for (RenderPlan& each : shot.renders) move(each.where);
  for (MediumPlan& each : shot.media) {
    move_volume(each.volume);
    move(each.where);
  }
}

}  // namespace vug::shot
