// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/diagnostics.h>
#include <vug/language/check.h>
#include <vug/language/edits.h>
#include <vug/loading/data_folders.h>
#include <vug/scene/lexer.h>
#include <vug/scene/text_at.h>
#include <vug/workbench/scene_bench.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vug::workbench {
namespace {

viewport::ViewportOptions viewport_options(const std::filesystem::path& file) {
  viewport::ViewportOptions out;
  out.load.include_folders = loading::data_folders();
  out.check = [name = file.string()](loading::Loaded& loaded) {
    language::check_products(loaded, name, {});
  };
  return out;
}

}  // namespace

void SceneBench::require_document() const {
  if (!has_document())
    throw Error(ErrorCode::bad_input, "no scene is open", {}, "open a file: open FILE.vug");
}

const UndoStack<SceneText>& SceneBench::stack() const {
  require_document();
  return *stack_;
}

viewport::Viewport& SceneBench::viewport() {
  require_document();
  return *viewport_;
}

const viewport::Viewport& SceneBench::viewport() const {
  require_document();
  return *viewport_;
}

viewport::ViewportStatus SceneBench::status() const {
  return viewport_ ? viewport_->status() : viewport::ViewportStatus();
}

viewport::PreviewPtr SceneBench::picture() const {
  if (viewport::PreviewPtr shown = status().picture) return shown;
  throw Error(ErrorCode::bad_input, "the first picture is not finished", {}, "wait for it");
}

void SceneBench::open(const std::filesystem::path& file, const std::optional<std::string>& text) {
  if (const std::string why = unreadable_reason(file); !why.empty() && !text)
    throw Error(ErrorCode::bad_input, fmt::format("cannot open '{}': {}", file.string(), why), {},
                "name a scene text, such as scene.vug");
  SavedFile saved(file);
  UndoStack<SceneText> stack(saved.text());
  if (text && *text != *saved.text())
    stack.push("Recover", std::make_shared<const std::string>(scene::normalise_text(*text)));
  file_ = std::move(saved);
  stack_ = std::move(stack);
  history_.clear();
  attach();
  select(language::range_at(file.string(), {1, 1}));
}

void SceneBench::attach() {
  viewport::PreviewRequest request;
  if (viewport_) request = viewport_->request();
  const bool paused = status().paused;
  viewport_ = std::make_unique<viewport::Viewport>(file(), viewport_options(file()), notify_);
  viewport_->set_mode(request.mode);
  viewport_->set_size(request.width, request.height);
  viewport_->set_paused(paused);
  workspace_ = language::Workspace({loading::data_folders()});
  picked_.reset();
  inspected_.reset();
  grip_.reset();
  ++revision_;
  build();
}

void SceneBench::save(const std::filesystem::path& path, bool replace) {
  const bool moves = path != file();
  if (moves)
    file_.write_as(path, stack().current());
  else
    file_.write(stack().current(), replace);
  stack_->end_merge();
  if (moves) attach();
}

std::string SceneBench::changed_on_disk() const {
  const SceneText others = has_document() ? file_.changed_by_others() : nullptr;
  return others ? changed_lines(*file_.text(), *others) : "";
}

void SceneBench::reload() {
  require_document();
  file_.reload();
  const TextChange change = change_between(text(), *file_.text());
  if (change.empty()) return;
  stack_->push("Reload", file_.text());
  changed(change);
}

std::string SceneBench::opening_line() const {
  return fmt::format("open {} {}", quoted(std::filesystem::absolute(file()).string()),
                     quoted(text()));
}

void SceneBench::changed(const TextChange& change) {
  ++revision_;
  typed_to_ = change.end();
}

void SceneBench::edit(const TextChange& change, const std::string& step, const std::string& merge) {
  std::string after = with_change(text(), change);
  if (change.empty()) return;
  const bool adjacent = change.begin == typed_to_ || change.begin + change.removed == typed_to_;
  if (merge == "typing" && !adjacent) stack_->end_merge();
  stack_->push(step, std::make_shared<const std::string>(std::move(after)), merge);
  changed(change);
}

void SceneBench::edit_recorded(const TextChange& change, const std::string& step,
                               const std::string& merge) {
  if (change.empty()) return;
  edit(change, step, merge);
  if (journal)
    journal(fmt::format("edit {} {} {} {} {}", change.begin, change.removed, quoted(change.text),
                        quoted(step), quoted(merge)));
}

void SceneBench::restored(const std::string& before, const char* step) {
  const TextChange change = change_between(before, text());
  changed(change);
  if (journal)
    journal(
        fmt::format("edit {} {} {} {}", change.begin, change.removed, quoted(change.text), step));
}

bool SceneBench::undo() {
  const SceneText before = stack().current();
  if (stack_->undo() == 0) return false;
  restored(*before, "Undo");
  return true;
}

bool SceneBench::redo() {
  const SceneText before = stack().current();
  if (stack_->redo() == 0) return false;
  restored(*before, "Redo");
  return true;
}

void SceneBench::end_step() {
  require_document();
  grip_.reset();
  stack_->end_merge();
}

language::AnalysisPtr SceneBench::analysis() const {
  require_document();
  if (analysed_ != revision_) workspace_.open(file(), text());
  analysed_ = revision_;
  return workspace_.analyse(file());
}

const std::vector<language::ParamSetting>& SceneBench::params() const {
  if (has_document() && params_revision_ != revision_) {
    params_ = language::params_of(*analysis());
    params_revision_ = revision_;
  }
  return params_;
}

const language::ParamSetting& SceneBench::param(const std::string& name) const {
  require_document();
  std::vector<std::string> names;
  for (const language::ParamSetting& each : params()) {
    if (each.name == name) return each;
    names.push_back(each.name);
  }
  throw Error(ErrorCode::bad_input, fmt::format("the text has no param '{}'", name), {},
              suggestion(name, names));
}

void SceneBench::set_param(const std::string& name, const std::string& value,
                           const std::string& merge) {
  param(name);
  const language::AnalysisPtr now = analysis();
  const std::string after = language::apply(text(), {language::set_param(*now, name, value)});
  edit(change_between(text(), after), fmt::format("Set {}", name), merge);
}

void SceneBench::write_view() {
  require_document();
  const viewport::PreviewPtr shown = picture();
  const viewport::View view = viewport_->view();
  const std::string& name = shown->scene.scene->camera;
  std::string after = text();
  if (name.empty()) {
    if (!after.empty() && after.back() != '\n') after += '\n';
    after += camera_text(view, "main") + "\n";
  } else {
    // One entry after the other: added entries move the ranges of the text.
    for (const auto& [key, value] : viewport::camera_entries(view)) {
      language::Workspace draft({loading::data_folders()});
      draft.open(file(), after);
      after = language::apply(
          after, {language::set_entry(*draft.analyse(file()), "camera", name, key, value)});
    }
  }
  edit(change_between(text(), after), "Write view");
}

void SceneBench::select(const SourceLocation& range) {
  selection_ = range;
  if (range.file == file().string()) caret_line_ = range.line;
  ++jumps_;
}

void SceneBench::build() {
  if (!needs_build()) return;
  built_ = revision_;
  viewport_->set_text(text());
}

void SceneBench::pick(double x, double y) {
  const viewport::PreviewPtr shown = picture();
  const std::string before = picked_ ? picked_->object : "";
  picked_ = viewport::pick(shown->scene, x, y);
  if (!picked_ || picked_->declared.empty()) return;
  const bool again = picked_->object == before;
  select_declaration(again ? (picked_declaration_ + 1) % picked_->declared.size() : 0);
}

void SceneBench::select_declaration(size_t index) {
  if (!picked_ || index >= picked_->declared.size())
    throw Error(ErrorCode::bad_input, fmt::format("the picked object has no declaration {}", index),
                {}, "pick an object in the picture first");
  picked_declaration_ = index;
  select_place(picked_->declared[index]);
}

void SceneBench::select_place(const viewport::DeclaredPlace& place) {
  // The name, in the present text: it may have moved since the picture was built.
  const scene::Declaration* declared =
      analysis()->document.find(scene::name_without_index(place.name), place.kind);
  select(declared ? declared->where : place.where);
}

}  // namespace vug::workbench
