// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/queries.h>
#include <vug/viewport/preview_scene.h>

#include <algorithm>

namespace vug::viewport {
namespace {

class DeclarationList {
 public:
  explicit DeclarationList(const loading::Loaded& loaded) : loaded_(loaded) {}

  /// Adds a declaration of the text once; names without one are ignored.
  void add(const std::string& kind, const std::string& name) {
    const auto* found = loaded_.provenance.find(kind, scene::name_without_index(name));
    if (!found || !found->where.known()) return;
    const bool known = std::any_of(places_.begin(), places_.end(), [&](const DeclaredPlace& each) {
      return each.where == found->where;
    });
    if (!known) places_.push_back({found->kind, name, found->where});
  }
  void add_mesh(const shot::MeshPtr& mesh) {
    if (!mesh) return;
    add("mesh", mesh->name);
    if (mesh->cells) {
      add("cells", mesh->cells->name);
      for (const shot::MeshPtr& below : mesh->cells->on) add_mesh(below);
    }
    if (mesh->volume) add("volume", mesh->volume->name);
    for (const auto& part : mesh->parts) add_mesh(part);
  }
  void add_material(const render::MaterialPtr& material) {
    if (!material) return;
    for (const auto& [name, known] : loaded_.shot.materials)
      if (known == material) add("material", name);
  }
  void add_object(const shot::ObjectPlan& object) {
    add("object", object.name);
    add_mesh(object.mesh);
    add_material(object.material);
  }

  std::vector<DeclaredPlace> take() { return std::move(places_); }

 private:
  const loading::Loaded& loaded_;
  std::vector<DeclaredPlace> places_;
};

std::map<std::string, std::vector<DeclaredPlace>> declarations_of(const loading::Loaded& loaded) {
  std::map<std::string, std::vector<DeclaredPlace>> out;
  for (const shot::ObjectPlan& object : shot::shown_objects(loaded.shot)) {
    DeclarationList list(loaded);
    list.add_object(object);
    out[object.name] = list.take();
  }
  for (const shot::PointInstancer& plan : loaded.shot.instancers) {
    DeclarationList list(loaded);
    list.add("place", plan.name);
    list.add_material(plan.material);
    for (const shot::Model& model : plan.of)
      if (const auto object = model.scene ? std::nullopt : shot::object_of(loaded.shot, model))
        list.add_object(*object);
    out[plan.name] = list.take();
  }
  return out;
}

}  // namespace

PreviewScene build_preview(LiveText& text, const picture::PictureOptions& options) {
  const shot::Shot& shot = text.loaded().shot;
  picture::PictureOptions chosen = options;
  chosen.eye = 0;
  chosen.source = &text.source();
  chosen.settings.insert(chosen.settings.end(), {{"noise", 0}, {"deep", false}});
  picture::PicturePlan plan = picture::plan_picture(shot, chosen);
  plan.render.settings.crop = {};
  PreviewScene out;
  out.job = picture::prepare_picture(text.builder(), plan, true);
  out.camera = picture::camera_name(shot, plan.render);
  out.declared = declarations_of(text.loaded());
  out.gizmos = gizmos_of(text.loaded());
  for (const render::Object& object : out.job.scene.objects)
    out.bounds.extendBy(render::object_bounds(object));
  const auto aspect = static_cast<double>(out.job.options.width) / out.job.options.height;
  out.home = view_of(*out.job.scene.camera, aspect);
  return out;
}

}  // namespace vug::viewport
