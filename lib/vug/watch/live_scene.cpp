// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/image/io.h>
#include <vug/picture/picture.h>
#include <vug/picture/stereo_views.h>
#include <vug/watch/live_scene.h>

#include <utility>

namespace vug::watch {

LiveScene::LiveScene(std::filesystem::path file, LiveOptions options)
    : file_(std::move(file)),
      options_(std::move(options)),
      text_(file_, options_.load, options_.build) {
  options_.picture.source = &text_.source();
}

bool LiveScene::load(std::shared_ptr<Progress> progress) {
  if (!text_.load(read_text(file_), std::move(progress))) return false;
  before_ = session_.counters();
  parts_before_ = text_.part_counts();
  return true;
}

std::vector<picture::RenderResult> LiveScene::render(const PictureStages& stages) {
  picture::RenderOptions options;
  options.session = &session_;
  options.unfinished = stages.unfinished;
  return picture::render_views(text_.builder(),
                               picture::plan_picture(loaded().shot, options_.picture), options);
}

viewport::View LiveScene::view() const {
  const render::Scene& scene = session_.scene();
  return scene.camera ? viewport::view_of(*scene.camera, 16.0 / 9) : viewport::View();
}

std::string LiveScene::camera_name() const {
  const shot::Shot& shot = loaded().shot;
  return picture::camera_name(shot, picture::plan_picture(shot, options_.picture).render);
}

std::string LiveScene::look(const ViewRequest& look, std::shared_ptr<Progress> progress) {
  // The progress of the builder may have been cancelled together with the picture.
  text_.resume(progress);
  picture::PictureOptions options = options_.picture;
  options.eye = 0;
  options.settings = {{"size", List{look.width, look.height}},
                      {"spp", look.spp},
                      {"noise", 0},
                      {"deep", false},
                      {"layers", List{"beauty"}},
                      {"denoise", true}};
  picture::PicturePlan plan = picture::plan_picture(loaded().shot, options);
  plan.render.settings.crop = {};
  plan.render.settings.camera = viewport::camera_of(look.view);
  picture::PictureJob job = picture::prepare_picture(text_.builder(), plan, true);
  const render::IntegratorPtr preview = viewport::preview_integrator(look.mode, true);
  if (preview) {
    job.options.integrator = preview;
    job.options.openings = job.options.bright_edges = false;
  }
  looks_.set_scene(std::move(job.scene));
  looks_.set_options(job.options);
  looks_.proceed(static_cast<uint32_t>(look.spp), *progress);
  if (preview) return image::png_bytes(looks_.image(), image::plain_view());
  const ScratchFolder scratch("vug_look");
  const std::filesystem::path png = scratch.file("look.png");
  picture::write_preview(png, looks_.image(), job.output);
  return read_text(png);
}

Work LiveScene::work() const {
  const render::SessionCounters& now = session_.counters();
  const building::PartCounts parts = text_.part_counts();
  return {text_.kept(),
          text_.builder().counts(),
          {{parts.blocks.evaluated - parts_before_.blocks.evaluated,
            parts.blocks.reused - parts_before_.blocks.reused},
           {parts.groups.evaluated - parts_before_.groups.evaluated,
            parts.groups.reused - parts_before_.groups.reused}},
          {now.trees.built - before_.trees.built, now.trees.reused - before_.trees.reused},
          now.samples - before_.samples};
}

}  // namespace vug::watch
