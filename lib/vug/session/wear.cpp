#include <vug/cells/onto_mesh.h>
#include <vug/session/wear.h>

namespace vug::session {

mesh::Mesh wear(mesh::Mesh bare, const Skin& skin, Progress& progress) {
  if (!bare.triangles.empty()) cells::onto_mesh(skin.simulation, bare, progress);
  return bare;
}

}  // namespace vug::session
