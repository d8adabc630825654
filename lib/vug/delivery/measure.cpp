// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/delivery/measure.h>
#include <vug/mesh/format.h>
#include <vug/meshing/polygonize.h>
#include <vug/metrics/cells.h>
#include <vug/shot/queries.h>
#include <vug/volume/io.h>

namespace vug::delivery {

metrics::Report measure(building::Builder& builder, const std::string& name) {
  const shot::MeshPtr plan = shot::find_mesh(builder.shot(), name);
  const auto mesh = builder.mesh(plan);
  metrics::Report report = metrics::measure(*mesh);
  report.build_seconds = builder.seconds();
  if (plan->volume && !plan->volume->source_mesh && is_finite(plan->volume->field.bounds()))
    report.volume_cells =
        metrics::volume_cells(plan->volume->field, plan->volume->voxel, builder.progress());
  size_t productions = 0;
  for (const shot::Derivation& derivation : builder.shot().derivations)
    productions += static_cast<size_t>(derivation.productions);
  report.productions = productions;
  return report;
}

metrics::Report measure_file(const std::filesystem::path& file, Progress& progress) {
  if (extension_of(file) != ".vdb") return metrics::measure(mesh::read_mesh(file));
  const volume::LevelSet surface(volume::read_grid(file, ""));
  return metrics::measure(meshing::polygonize(surface, nullptr, {}, progress).mesh);
}

}  // namespace vug::delivery
