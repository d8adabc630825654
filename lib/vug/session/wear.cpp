#include <vug/cells/onto_mesh.h>
#include <vug/mesh/cut.h>
#include <vug/session/blame.h>
#include <vug/session/wear.h>

namespace vug::session {

mesh::Mesh wear(mesh::Mesh bare, const Skin& skin, const CellsPlan& plan, Progress& progress) {
  if (bare.triangles.empty()) return bare;
  cells::OntoMeshOptions options;
  options.move = plan.move;
  try {
    cells::onto_mesh(skin.simulation, bare, options, progress);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input) throw;
    throw blamed_on(plan.where, error);
  }
  const mesh::Attribute* gone = mesh::find_attribute(bare, cells::kTransparent, 1);
  if (!plan.holes || !gone) return bare;
  return mesh::cut(bare, gone->values, 0.5F);
}

}  // namespace vug::session
