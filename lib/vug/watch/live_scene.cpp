// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/loading/dependencies.h>
#include <vug/picture/picture.h>
#include <vug/picture/stereo_views.h>
#include <vug/render/kinds.h>
#include <vug/watch/live_scene.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vug::watch {
namespace {

/// When a file was written; the earliest time if it does not exist.
std::filesystem::file_time_type time_of(const std::filesystem::path& file) {
  std::error_code code;
  const auto time = std::filesystem::last_write_time(file, code);
  return code ? std::filesystem::file_time_type::min() : time;
}

}  // namespace

struct LiveScene::Version {
  Version(loading::Loaded from, const LiveOptions& options, std::shared_ptr<Progress> work)
      : progress(std::move(work)),
        loaded(std::move(from)),
        builder(loaded.shot, options.build ? options.build(loaded) : building::BuildOptions(),
                *progress) {}

  std::shared_ptr<Progress> progress;
  loading::Loaded loaded;
  building::Builder builder;
  size_t kept = 0;
};

LiveScene::LiveScene(std::filesystem::path file, LiveOptions options)
    : file_(std::move(file)),
      options_(std::move(options)),
      source_("", file_.string(), options_.load) {
  options_.picture.source = &source_;
  files_ = {file_};
}

LiveScene::~LiveScene() = default;

bool LiveScene::load(std::shared_ptr<Progress> progress) {
  source_.set_text(read_text(file_));
  for (auto& [file, known] : network_files_)
    if (const auto now = time_of(file); std::exchange(known, now) != now) source_.forget_values();
  loading::Loaded loaded = source_.at(options_.load.frame);
  // Reused values do not repeat their warnings: those of the last text may apply to this one.
  const bool any = !loaded.diagnostics.all().empty() || !problems_.all().empty();
  if (any && source_.reused() > 0)
    problems_ = loading::load_text(source_.text(), file_.string(), options_.load).diagnostics;
  else
    problems_ = loaded.diagnostics;
  report_ = loaded.report(problems_);
  files_ = loading::file_dependencies(loaded);
  for (const std::filesystem::path& file : loaded.provenance.network_files())
    network_files_.try_emplace(file, time_of(file));
  const auto add = [&](const std::filesystem::path& file) {
    if (std::find(files_.begin(), files_.end(), file) == files_.end()) files_.push_back(file);
  };
  add(file_);
  for (const auto& [file, time] : network_files_) add(file);
  if (!loaded.usable()) return false;
  auto next = std::make_unique<Version>(std::move(loaded), options_, std::move(progress));
  next->kept = source_.reused();
  if (version_) next->builder.reuse_from(std::move(version_->builder));
  version_ = std::move(next);
  before_ = session_.counters();
  return true;
}

const loading::Loaded& LiveScene::loaded() const { return version_->loaded; }

std::vector<picture::RenderResult> LiveScene::render(const PictureStages& stages) {
  picture::RenderOptions options;
  options.session = &session_;
  options.unfinished = stages.unfinished;
  return picture::render_views(
      version_->builder, picture::plan_picture(version_->loaded.shot, options_.picture), options);
}

View view_of(const render::Camera& camera, int width, int height) {
  constexpr double kDistance = 4;  // metres; a camera has no target
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  const auto direction = [&](float x) {
    return Vec3d(camera.ray({x, 0.5f}, aspect, {0.5f, 0.5f}).direction).normalized();
  };
  View view;
  view.eye = Vec3d(camera.position());
  view.target = view.eye + direction(0.5f) * kDistance;
  const double cosine = std::min(1.0, direction(0.5f).dot(direction(0)));
  view.fov = std::min(2 * std::acos(cosine), 2.8);
  return view;
}

View LiveScene::view() const {
  const render::Scene& scene = session_.scene();
  return scene.camera ? view_of(*scene.camera, 16, 9) : View();
}

std::string LiveScene::camera_name() const {
  const shot::Shot& shot = version_->loaded.shot;
  return picture::camera_name(shot, picture::plan_picture(shot, options_.picture).render);
}

namespace {

/// Grey objects under a light at the eye.
void make_clay(const View& view, std::map<mesh::MeshPtr, mesh::MeshPtr>& meshes,
               render::Scene& scene) {
  static const render::MaterialPtr grey = render::make_material("lambert");
  std::map<mesh::MeshPtr, mesh::MeshPtr> used;
  for (render::Object& object : scene.objects) {
    object.material = grey;
    object.emission = render::Rgb(0.0f);
    object.color = nullptr;
    if (!object.mesh) continue;
    mesh::MeshPtr& plain = used[object.mesh];
    if (const auto known = meshes.find(object.mesh); known != meshes.end()) plain = known->second;
    if (!plain)
      plain = std::make_shared<const mesh::Mesh>(
          mesh::Mesh{object.mesh->positions, object.mesh->triangles, object.mesh->normals, {}});
    object.mesh = plain;
  }
  meshes = std::move(used);
  scene.medium = nullptr;
  scene.lights = {
      render::make_light("sphere", {{"center", view.eye}, {"radius", 0.05}, {"visible", false}})};
}

}  // namespace

std::string LiveScene::look(const View& view, std::shared_ptr<Progress> progress) {
  // The progress of the builder may have been cancelled together with the picture.
  auto same = std::make_unique<Version>(std::move(version_->loaded), options_, progress);
  same->kept = version_->kept;
  same->builder.reuse_from(std::move(version_->builder));
  version_ = std::move(same);
  picture::PictureOptions options = options_.picture;
  options.eye = 0;
  options.settings = {{"size", List{view.width, view.height}},
                      {"spp", view.spp},
                      {"noise", 0},
                      {"deep", false},
                      {"layers", List{"beauty"}},
                      {"denoise", true}};
  if (view.clay) options.settings.emplace_back("exposure", Value::Name{"auto"});
  picture::PicturePlan plan = picture::plan_picture(version_->loaded.shot, options);
  plan.render.settings.crop = {};
  plan.render.settings.camera = render::make_camera(
      "perspective",
      {{"eye", view.eye}, {"target", view.target}, {"fov", Number{view.fov, Dimension::angle}}});
  picture::PictureJob job = picture::prepare_picture(version_->builder, plan, true);
  if (view.clay) make_clay(view, clay_meshes_, job.scene);
  looks_.set_scene(std::move(job.scene));
  looks_.set_options(job.options);
  looks_.proceed(static_cast<uint32_t>(view.spp), *progress);
  const ScratchFolder scratch("vug_look");
  const std::filesystem::path png = scratch.file("look.png");
  picture::write_preview(png, looks_.image(), job.output);
  return read_text(png);
}

Work LiveScene::work() const {
  const render::SessionCounters& now = session_.counters();
  return {version_->kept,
          version_->builder.counts(),
          {now.trees.built - before_.trees.built, now.trees.reused - before_.trees.reused},
          now.samples - before_.samples};
}

}  // namespace vug::watch
