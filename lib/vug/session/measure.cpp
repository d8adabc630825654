#include <vug/base/atomic_file.h>
#include <vug/mesh/format.h>
#include <vug/meshing/polygonize.h>
#include <vug/metrics/cells.h>
#include <vug/session/measure.h>
#include <vug/volume/io.h>

#include <fmt/format.h>

namespace vug::session {
namespace {

MeshPtr find_mesh(const Shot& shot, const std::string& name) {
  const std::vector<MeshPtr> meshes = meshes_of(shot);
  std::vector<std::string> names;
  for (const MeshPtr& mesh : meshes) {
    if (name.empty() || mesh->name == name) return mesh;
    names.push_back(mesh->name);
  }
  if (names.empty())
    throw Error(ErrorCode::bad_input, "the scene has no mesh and no level set to measure", {},
                "add for instance: volume rock = level_set(..., voxel: 5cm)");
  throw Error(ErrorCode::bad_input, fmt::format("the scene has no mesh '{}'", name), {},
              suggestion(name, names));
}

}  // namespace

metrics::Report measure(Builder& builder, const std::string& name) {
  const MeshPtr plan = find_mesh(builder.shot(), name);
  const auto mesh = builder.mesh(plan);
  metrics::Report report = metrics::measure(*mesh);
  report.build_seconds = builder.seconds();
  if (plan->volume && !plan->volume->of && is_finite(plan->volume->field.bounds()))
    report.volume_cells =
        metrics::volume_cells(plan->volume->field, plan->volume->voxel, builder.progress());
  size_t productions = 0;
  for (const Derivation& derivation : builder.shot().derivations)
    productions += static_cast<size_t>(derivation.productions);
  report.productions = productions;
  return report;
}

metrics::Report measure_file(const std::filesystem::path& file, Progress& progress) {
  if (extension_of(file) != ".vdb") return metrics::measure(mesh::read_mesh(file));
  const volume::LevelSet surface(volume::read_grid(file, ""));
  return metrics::measure(meshing::polygonize(surface, nullptr, {}, progress).mesh);
}

}  // namespace vug::session
