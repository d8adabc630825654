// SPDX-License-Identifier: Apache-2.0
// The part of the scene bench that reads pictures: handles, gizmos, pixels, the display.
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/language/edits.h>
#include <vug/viewport/shown_layer.h>
#include <vug/workbench/handle_drag.h>
#include <vug/workbench/scene_bench.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::workbench {

const language::StatementHandles& SceneBench::handles() const {
  require_document();
  if (handles_revision_ != revision_ || handles_line_ != caret_line_) {
    handles_ = language::handles_at(*analysis(), caret_line_);
    handles_revision_ = revision_;
    handles_line_ = caret_line_;
  }
  return handles_;
}

viewport::ScreenView SceneBench::screen_view() const {
  const viewport::PreviewPtr shown = picture();
  const viewport::PreviewRequest& request = viewport_->request();
  return {shown->scene.camera, static_cast<double>(request.width),
          static_cast<double>(request.height)};
}

SceneOverlay SceneBench::overlay() const {
  const viewport::PreviewPtr shown = status().picture;
  if (!shown) return {};
  static const std::vector<viewport::Gizmo> none;
  return overlay_of(handles(), shows_gizmos_ ? shown->scene.scene->gizmos : none, screen_view());
}

void SceneBench::drag_handle(const std::string& name, const Vec2d& offset, std::optional<int> axis,
                             const std::string& merge) {
  const language::LiteralHandle& now = handles().find(name);
  if (merge.empty() || !grip_ || grip_->merge != merge || grip_->name != name)
    grip_ = Grip{name, merge, now, screen_view()};
  const auto numbers = dragged_numbers(grip_->start, grip_->view, offset, axis);
  if (!numbers)
    throw Error(ErrorCode::bad_input,
                fmt::format("the handle '{}' cannot be dragged in this view", name), now.where,
                "turn the view until the handle is in front of the eye, across its line");
  const std::vector<std::string> texts =
      language::number_texts(grip_->start, *numbers, number_step(grip_->start, grip_->view));
  std::vector<language::TextEdit> edits;
  for (size_t i = 0; i < texts.size(); ++i)
    if (texts[i] != now.numbers[i].text) edits.push_back({now.numbers[i].where, texts[i]});
  const std::string after = language::apply(text(), std::move(edits));
  edit_recorded(change_between(text(), after), "Drag " + name, merge);
}

void SceneBench::inspect(double x, double y) { inspected_ = viewport::inspect(*picture(), x, y); }

void SceneBench::select_material() {
  if (!inspected_ || !inspected_->material)
    throw Error(ErrorCode::bad_input,
                inspected_ ? "the inspected pixel has no material that the text declares by name"
                           : "no pixel is inspected",
                {}, "inspect a pixel of an object with a material: inspect 0.5 0.5");
  select_place(*inspected_->material);
}

void SceneBench::restore_text(int number) {
  require_document();
  const KeptPicturePtr kept = history_.find(number);
  edit_recorded(change_between(text(), *kept->text), fmt::format("Restore picture {}", number));
}

void SceneBench::set_display(const viewport::DisplayChoice& display) {
  const viewport::PreviewPtr shown = picture();
  view_options(display, shown->scene.scene->job.output, *shown->light);
  const std::vector<std::string> layers = viewport::layers_to_show(*shown->light);
  if (!display.layer.empty() &&
      std::find(layers.begin(), layers.end(), display.layer) == layers.end())
    throw Error(
        ErrorCode::bad_input, fmt::format("the picture has no layer '{}'", display.layer), {},
        did_you_mean(display.layer, layers,
                     "name it in the `layers` of the render block; mode path shows layers"));
  viewport_->set_display(display);
}

}  // namespace vug::workbench
