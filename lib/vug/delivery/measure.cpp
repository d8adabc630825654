// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/delivery/measure.h>
#include <vug/mesh/format.h>
#include <vug/meshing/polygonize.h>
#include <vug/metrics/cells.h>
#include <vug/shot/queries.h>
#include <vug/volume/io.h>

namespace vug::delivery {
namespace {

std::vector<metrics::SmallFeaturePlace> places_of(const std::vector<volume::SmallFeature>& features,
                                                  bool removed) {
  std::vector<metrics::SmallFeaturePlace> places;
  for (const volume::SmallFeature& each : features)
    places.push_back({to_string(each.kind), each.at, removed});
  return places;
}

}  // namespace

metrics::Report measure(building::Builder& builder, const std::string& name) {
  const shot::MeshPtr plan = shot::find_mesh(builder.shot(), name);
  const auto mesh = builder.mesh(plan);
  metrics::Report report =
      metrics::measure(*mesh, {.overlapping_components = shot::components_may_overlap(plan)});
  report.small_features =
      places_of(builder.small_features(plan), plan->topology == shot::SmallTopology::clean);
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
  metrics::Report report =
      metrics::measure(meshing::polygonize(surface, nullptr, {}, progress).mesh);
  report.small_features = places_of(volume::find_small_features(surface), false);
  return report;
}

}  // namespace vug::delivery
