// SPDX-License-Identifier: Apache-2.0
// The scene bench: the complete state of the window that edits a scene text next to its picture.
// Widgets show this state and run commands (workbench/scene_command.h); nothing here needs a
// display.
#pragma once

#include <vug/language/literal_handles.h>
#include <vug/language/params.h>
#include <vug/language/workspace.h>
#include <vug/viewport/inspect.h>
#include <vug/viewport/screen_view.h>
#include <vug/viewport/viewport.h>
#include <vug/workbench/picture_history.h>
#include <vug/workbench/preset_store.h>
#include <vug/workbench/render_queue.h>
#include <vug/workbench/saved_file.h>
#include <vug/workbench/scene_overlay.h>
#include <vug/workbench/scene_text.h>
#include <vug/workbench/undo_stack.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug::workbench {

/// Used by one thread. Functions throw Error(bad_input) for work that is not possible, and then
/// change nothing.
class SceneBench {
 public:
  /// `notify` is called on other threads when the status of the viewport has changed.
  explicit SceneBench(std::function<void()> notify = {}) : notify_(std::move(notify)) {}

  // The document.
  bool has_document() const { return stack_.has_value(); }
  const UndoStack<SceneText>& stack() const;
  const std::string& text() const { return *stack().current(); }
  const std::filesystem::path& file() const { return file_.path(); }
  /// Whether the text differs from the saved one.
  bool is_modified() const { return text() != *file_.text(); }
  uint64_t revision() const { return revision_; }  ///< Increases with each change of the text.

  /// Error(bad_input) if the file cannot be read. `text` replaces that of the file, unless it is
  /// none.
  void open(const std::filesystem::path& file, const std::optional<std::string>& text = {});
  /// Keeps the line ends of the file. Error(bad_input) if another program has changed the file of
  /// the document, unless `replace` is true. Error(io).
  void save(const std::filesystem::path& file, bool replace = false);
  /// The lines of the file that another program has changed since it was opened, saved or
  /// reloaded; empty: none. Reads the file.
  std::string changed_on_disk() const;
  /// Takes the text of the file, as one step. Error(bad_input) if the file is missing, Error(io).
  void reload();
  /// The command that opens this document with its present text.
  std::string opening_line() const;

  /// `step`: the name of the undo step. Changes with the same `merge`, which is not empty, are one
  /// step; with the key "typing" only if they are adjacent.
  void edit(const TextChange& change, const std::string& step, const std::string& merge = "");
  /// The same, and journals the change, for commands whose lines do not determine it alone.
  void edit_recorded(const TextChange& change, const std::string& step,
                     const std::string& merge = "");
  bool undo();
  bool redo();
  /// The next change is a step of its own.
  void end_step();

  // The meaning of the text.
  const language::Workspace& workspace() const { return workspace_; }
  language::AnalysisPtr analysis() const;
  const std::vector<language::ParamSetting>& params() const;
  /// Error(bad_input) with the nearest name.
  const language::ParamSetting& param(const std::string& name) const;
  void set_param(const std::string& name, const std::string& value, const std::string& merge = "");
  /// Its value in the saved text; nothing if that does not declare it.
  std::optional<std::string> saved_param(const std::string& name) const;
  bool is_changed(const language::ParamSetting& param) const;
  /// Restores the value of the saved text.
  void reset_param(const std::string& name);
  /// Sets the params of a preset that the text has, as one step.
  void apply_preset(const std::string& name);
  /// Keeps the present values of all params.
  void save_preset(const std::string& name);
  /// The presets of the scene's file.
  PresetStore presets() const;
  std::filesystem::path preset_folder;  ///< Empty: the folder of the scene.

  /// Writes the view of the viewport into the camera of the text, or adds a camera.
  void write_view();

  // The selected range of the text.
  const SourceLocation& selection() const { return selection_; }
  /// Increases with each `select`, so that editors follow.
  uint64_t jumps() const { return jumps_; }
  void select(const SourceLocation& range);

  // The handles of the statement at the caret.
  int caret_line() const { return caret_line_; }
  void set_caret(int line) { caret_line_ = line; }
  const language::StatementHandles& handles() const;
  /// The projection of the present picture. Error(bad_input) before the first one.
  viewport::ScreenView screen_view() const;
  /// The symbols over the picture; empty before the first one.
  SceneOverlay overlay() const;
  bool shows_gizmos() const { return shows_gizmos_; }
  void show_gizmos(bool shown) { shows_gizmos_ = shown; }
  /// Moves a handle by an offset in pixels of the viewport; only its numbers change. Drags with the
  /// same `merge`, which is not empty, count from the place of the first one and are one step.
  void drag_handle(const std::string& name, const Vec2d& offset, std::optional<int> axis = {},
                   const std::string& merge = "");

  // The picture.
  viewport::Viewport& viewport();
  const viewport::Viewport& viewport() const;
  viewport::ViewportStatus status() const;
  /// Whether the viewport does not have the present text.
  bool needs_build() const { return has_document() && built_ != revision_; }
  /// Gives the present text to the viewport.
  void build();
  /// Whether the picture shows another text.
  bool stale() const { return needs_build() || status().stale(); }
  bool busy() const { return needs_build() || status().busy(); }
  /// Selects the declaration of the object at a position of the picture, (0, 0) at the top left
  /// corner; another pick of the same object selects its next declaration.
  void pick(double x, double y);
  const std::optional<viewport::Pick>& picked() const { return picked_; }
  /// Reads the pixel at a position of the picture.
  void inspect(double x, double y);
  const std::optional<viewport::PixelReport>& inspected() const { return inspected_; }
  /// Selects the declaration of the material of the inspected pixel.
  void select_material();
  /// Error(bad_input) for an unknown view, and for a layer that the picture does not have.
  void set_display(const viewport::DisplayChoice& display);
  /// Selects a declaration of the picked object.
  void select_declaration(size_t index);

  /// The kept pictures of this document; they end with it.
  PictureHistory& history() { return history_; }
  const PictureHistory& history() const { return history_; }
  /// Takes the text of a kept picture, as one step.
  void restore_text(int number);

  /// The renders of the program; null: it has no queue. It must outlive its use by commands.
  RenderQueue* queue = nullptr;

  /// Receives the line of each command that changes the document.
  std::function<void(const std::string& line)> journal = {};

 private:
  void changed(const TextChange& change);
  /// Journals the restored text as a change: a journal begins at the last save, which undo can
  /// pass.
  void restored(const std::string& before, const char* step);
  /// Gives the text to a new viewport, whose relative paths begin at the file.
  void attach();
  void require_document() const;
  /// Selects the name of a declaration in the present text.
  void select_place(const viewport::DeclaredPlace& place);
  /// The picture of the viewport. Error(bad_input) before the first one.
  viewport::PreviewPtr picture() const;

  std::function<void()> notify_;
  std::optional<UndoStack<SceneText>> stack_;
  SavedFile file_;
  uint64_t revision_ = 0, built_ = 0;
  size_t typed_to_ = 0;  ///< End of the last change.
  mutable language::Workspace workspace_;
  mutable uint64_t analysed_ = 0;  ///< The revision of the workspace.
  mutable std::vector<language::ParamSetting> params_;
  mutable uint64_t params_revision_ = 0;
  mutable std::map<std::string, std::string> saved_params_;
  mutable SceneText saved_params_of_;
  mutable language::StatementHandles handles_;
  mutable uint64_t handles_revision_ = 0;
  mutable int handles_line_ = 0;
  int caret_line_ = 1;
  bool shows_gizmos_ = true;
  /// The drag whose steps merge.
  struct Grip {
    std::string name, merge;
    language::LiteralHandle start;
    viewport::ScreenView view;
  };
  std::optional<Grip> grip_;
  SourceLocation selection_;
  uint64_t jumps_ = 0;
  std::optional<viewport::Pick> picked_;
  size_t picked_declaration_ = 0;
  std::optional<viewport::PixelReport> inspected_;
  PictureHistory history_;
  std::unique_ptr<viewport::Viewport> viewport_;
};

}  // namespace vug::workbench
