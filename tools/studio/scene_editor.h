// SPDX-License-Identifier: Apache-2.0
// The editor of a scene text: colours by the meaning of words, squiggles below faults, completion.
#pragma once

#include "scene_studio.h"

#include <QPlainTextEdit>
#include <vector>

class QCompleter;
class QStandardItemModel;

namespace vug::studio {

class MeaningHighlighter;

class SceneEditor : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit SceneEditor(SceneStudio& studio);

  /// The texts below the squiggles, in their order.
  QStringList squiggles() const;
  /// The name of the colour class of the word at a position of the text (1-based).
  QString meaning_at(int line, int column) const;
  void complete();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void send_changes();
  void follow();
  void show_selection();
  void show_meanings();
  void show_problems();
  void restyle();
  void insert_completion(const QModelIndex& index);
  /// The cursor that selects a range of the text; of the word at its start if it has no end.
  QTextCursor cursor_of(const SourceLocation& where) const;
  int offset_of(int line, int column) const;

  SceneStudio& studio_;
  MeaningHighlighter* highlighter_;
  QStandardItemModel* completions_;
  QCompleter* completer_;
  SourceLocation completed_;  ///< The range that a completion replaces.
  bool following_ = false;    ///< The text is that of the bench: no change of the user.
  uint64_t jumps_ = 0;
  std::shared_ptr<const Diagnostics> shown_problems_;
};

}  // namespace vug::studio
