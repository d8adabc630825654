// SPDX-License-Identifier: Apache-2.0
// The facade bench: the complete state of the window that models a facade over its photo. Widgets
// show this state and run commands (workbench/command.h); nothing here needs a display.
#pragma once

#include <vug/fit/facade_score.h>
#include <vug/session/facade_fit.h>
#include <vug/workbench/drawing.h>
#include <vug/workbench/facade_document.h>
#include <vug/workbench/handles.h>
#include <vug/workbench/job.h>
#include <vug/workbench/selection.h>
#include <vug/workbench/undo_stack.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug::workbench {

/// How the canvas shows the facade; not part of the document.
struct ViewSettings {
  CanvasView canvas;
  double opacity = 1;        ///< Opacity of the photo, 0..1.
  bool differences = false;  ///< Whether differing pixels are marked.
};

/// Another session of the same facade, for a comparison of scores.
struct Comparison {
  std::string file;
  modeller::FacadeState state;
};

/// Used by one thread. Functions throw Error(bad_input) for work that is not possible, and then
/// change nothing.
class FacadeBench {
 public:
  /// `notify` is called on other threads when `poll` has news.
  explicit FacadeBench(std::function<void()> notify = {});
  ~FacadeBench();

  // The document.
  bool has_document() const { return stack_.has_value(); }
  const UndoStack<FacadeDocument>& stack() const;
  const FacadeDocument& document() const { return stack().current(); }
  /// The state of the document, or of the drag in progress.
  const modeller::FacadeState& state() const;
  const std::filesystem::path& file() const { return file_; }  ///< Empty: not saved yet.
  /// Paths in the header are relative to it.
  const std::filesystem::path& folder() const { return folder_; }
  /// The photo's file; empty if the session has none.
  std::filesystem::path photo() const;
  /// Increases with each change of `state`.
  uint64_t revision() const { return revision_; }

  void open(const std::filesystem::path& file);
  /// A new session for a photo. The height follows from the proportions of the photo.
  void open_photo(const std::filesystem::path& photo, const std::string& grammar, double width);
  void save(const std::filesystem::path& file);
  /// The command that opens this document in its saved state.
  std::string opening_line() const;
  void edit(const modeller::Edit& edit, const std::string& merge = "");
  /// Replaces all edits as one step.
  void replace(const std::vector<modeller::Edit>& edits, const std::string& step);
  /// Replaces the document as one step.
  void change_document(FacadeDocument to, const std::string& step);
  bool undo();
  bool redo();

  // Selection, view, and a drag in progress.
  int selected() const { return selection_.node(state()); }
  void select(int node);
  /// The selected handle, of handles(state, numbers_node(...)); nothing if it does not exist.
  std::optional<Handle> handle() const;
  void select_handle(std::optional<size_t> index, size_t instance = 0);
  std::vector<Handle> current_handles() const;
  ViewSettings& view() { return view_; }
  const ViewSettings& view() const { return view_; }
  /// Shows the state after an edit without changing the document; false if it cannot be performed.
  bool preview(const modeller::Edit& edit);
  void end_preview();

  // The score and the fit.
  /// Nothing while the picture is analysed, without a photo, or if the tree has no score.
  const std::optional<fit::FacadeScore>& score() const;
  const std::string& score_reason() const { return score_reason_; }  ///< Why the tree has no score.
  const fit::FacadeScorer* scorer() const { return scorer_.get(); }
  void start_fit(int64_t steps);
  void stop_fit() { fit_.cancel(); }
  bool fitting() const { return fit_.running(); }
  /// The best tree of the fit so far and its bits.
  const std::optional<facade::Tree>& best_tree() const { return best_tree_; }
  /// The deviation of the document from the result of the last fit, since rules have fewer free
  /// numbers than the fit; empty if there is none.
  const std::string& fit_note() const { return fit_note_; }
  /// Takes the news of the threads; true if something changed.
  bool poll();
  /// Whether a thread works, or its result has not been taken by `poll`.
  bool busy() const { return fit_.exists() || scoring_.exists(); }
  const Job<facade::Tree>::Update& fit_update() const { return fit_update_; }

  // Comparisons.
  void compare(const std::filesystem::path& file);
  const std::vector<Comparison>& comparisons() const { return comparisons_; }
  void clear_comparisons() { comparisons_.clear(); }

  /// The session with undone steps, and with paths for that file.
  modeller::Session session_for(const std::filesystem::path& file) const;

  /// Receives the line of each command that changes the document.
  std::function<void(const std::string& line)> journal = {};

 private:
  void set_document(const modeller::Session& session);
  void changed();
  void start_scoring();
  void finish_fit(const facade::Tree& tree);

  std::optional<UndoStack<FacadeDocument>> stack_;
  std::filesystem::path file_, folder_;
  Selection selection_;
  std::optional<std::pair<size_t, size_t>> handle_;  ///< Index and instance.
  ViewSettings view_;
  std::optional<modeller::FacadeState> preview_;
  uint64_t revision_ = 0;
  std::shared_ptr<const fit::FacadeScorer> scorer_;
  mutable std::optional<fit::FacadeScore> score_;
  mutable uint64_t scored_revision_ = 0;
  mutable std::string score_reason_ = "no photo";
  std::optional<facade::Tree> best_tree_;
  std::string fit_note_;
  Job<facade::Tree>::Update fit_update_;
  std::vector<Comparison> comparisons_;
  Job<std::shared_ptr<const fit::FacadeScorer>> scoring_;
  Job<facade::Tree> fit_;
};

}  // namespace vug::workbench
