// SPDX-License-Identifier: Apache-2.0
#include "scene_editor.h"

#include "meaning_highlighter.h"
#include "studio.h"
#include "theme.h"

#include <vug/base/utf8.h>
#include <vug/language/completion.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>
#include <QAbstractItemView>
#include <QCompleter>
#include <QFontDatabase>
#include <QKeyEvent>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QTextBlock>

namespace vug::studio {
namespace {

/// The text of a document, whose paragraphs Qt separates by U+2029.
QString plain_text(const QTextDocument& document) {
  return document.toRawText().replace(QChar::ParagraphSeparator, '\n');
}

/// A snippet without its fields: "${1:radius}" becomes "radius".
QString without_fields(const std::string& snippet) {
  QString out;
  for (size_t i = 0; i < snippet.size(); ++i) {
    if (snippet[i] == '\\' && i + 1 < snippet.size()) {
      out += snippet[++i];
    } else if (snippet.compare(i, 2, "${") == 0) {
      const size_t colon = snippet.find(':', i), close = snippet.find('}', i);
      if (colon < close) out += text_of(snippet.substr(colon + 1, close - colon - 1));
      i = std::min(close, snippet.size() - 1);
    } else if (snippet[i] == '$') {
      while (i + 1 < snippet.size() && std::isdigit(snippet[i + 1])) ++i;
    } else {
      size_t end = i + 1;
      while (end < snippet.size() && is_utf8_tail(snippet[end])) ++end;
      out += text_of(snippet.substr(i, end - i));
      i = end - 1;
    }
  }
  return out;
}

constexpr int kSnippetRole = Qt::UserRole + 1;

}  // namespace

SceneEditor::SceneEditor(SceneStudio& studio) : studio_(studio) {
  setObjectName("editor");
  setAccessibleName(tr("Scene text"));
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setTabChangesFocus(true);   // Tab leaves the editor: scenes are indented by spaces
  setUndoRedoEnabled(false);  // there is one undo stack, that of the bench
  setEnabled(false);
  highlighter_ = new MeaningHighlighter(document());
  completions_ = new QStandardItemModel(this);
  completer_ = new QCompleter(completions_, this);
  completer_->setWidget(this);
  completer_->setCompletionMode(QCompleter::PopupCompletion);
  completer_->setCaseSensitivity(Qt::CaseInsensitive);
  completer_->popup()->setObjectName("completions");
  completer_->popup()->setAccessibleName(tr("Completions"));
  connect(completer_, QOverload<const QModelIndex&>::of(&QCompleter::activated), this,
          &SceneEditor::insert_completion);
  connect(document(), &QTextDocument::contentsChange, this, [this] { send_changes(); });
  connect(&studio_, &SceneStudio::changed, this, [this] {
    follow();
    show_selection();
  });
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, [this] {
    if (!following_) studio_.set_caret(textCursor().blockNumber() + 1);
  });
  connect(&studio_, &SceneStudio::analysed, this, &SceneEditor::show_meanings);
  connect(&studio_, &SceneStudio::news, this, &SceneEditor::show_problems);
  connect(&studio_, &SceneStudio::restyled, this, &SceneEditor::restyle);
}

void SceneEditor::send_changes() {
  if (following_ || !studio_.bench().has_document()) return;
  const std::string now = plain_text(*document()).toStdString();
  const workbench::TextChange change = workbench::change_between(studio_.bench().text(), now);
  if (change.empty()) return;
  following_ = true;  // the text is the one of the bench after the command
  studio_.run(fmt::format("edit {} {} {} Typing typing", change.begin, change.removed,
                          workbench::quoted(change.text)));
  following_ = false;
}

void SceneEditor::follow() {
  const workbench::SceneBench& bench = studio_.bench();
  setEnabled(bench.has_document());
  if (following_ || !bench.has_document()) return;
  const std::string before = plain_text(*document()).toStdString();
  const workbench::TextChange change = workbench::change_between(before, bench.text());
  if (change.empty()) return;
  const auto offset = [&](size_t byte) {
    const language::Position at = language::position_at(before, byte);
    return offset_of(at.line, at.column);
  };
  following_ = true;
  QTextCursor cursor(document());  // not the user's: the caret and the scroll position stay
  cursor.setPosition(offset(change.begin));
  cursor.setPosition(offset(change.begin + change.removed), QTextCursor::KeepAnchor);
  cursor.insertText(text_of(change.text));
  following_ = false;
}

int SceneEditor::offset_of(int line, int column) const {
  const QTextBlock block = document()->findBlockByNumber(std::max(0, line - 1));
  if (!block.isValid()) return document()->characterCount() - 1;
  return block.position() + units_before(block.text(), column);
}

QTextCursor SceneEditor::cursor_of(const SourceLocation& where) const {
  QTextCursor cursor(document());
  cursor.setPosition(offset_of(where.line, where.column));
  if (where.has_end())
    cursor.setPosition(offset_of(where.end_line, where.end_column), QTextCursor::KeepAnchor);
  return cursor;
}

void SceneEditor::show_selection() {
  const workbench::SceneBench& bench = studio_.bench();
  if (!bench.has_document() || bench.jumps() == jumps_) return;
  jumps_ = bench.jumps();
  if (bench.selection().file != bench.file().string()) return;
  setTextCursor(cursor_of(bench.selection()));
  centerCursor();
}

void SceneEditor::show_meanings() {
  if (!studio_.bench().has_document()) return;
  following_ = true;  // formats are changes of the document, too
  highlighter_->show(language::semantic_tokens(*studio_.bench().analysis()));
  following_ = false;
}

void SceneEditor::show_problems() {
  const workbench::SceneBench& bench = studio_.bench();
  if (!bench.has_document()) return;
  const auto problems = bench.status().problems;
  if (problems == shown_problems_) return;
  shown_problems_ = problems;
  QList<QTextEdit::ExtraSelection> squiggles;
  for (const Diagnostic& each : problems->all()) {
    if (each.where.file != bench.file().string() || !each.where.known()) continue;
    QTextEdit::ExtraSelection squiggle;
    squiggle.cursor = cursor_of(each.where);
    if (!squiggle.cursor.hasSelection()) squiggle.cursor.select(QTextCursor::WordUnderCursor);
    squiggle.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    squiggle.format.setUnderlineColor(each.severity == Severity::error ? theme().error
                                                                       : theme().open);
    squiggle.format.setToolTip(text_of(each.message));
    squiggles.append(squiggle);
  }
  setExtraSelections(squiggles);
}

void SceneEditor::restyle() {
  highlighter_->restyle();
  shown_problems_.reset();
  show_problems();
}

QStringList SceneEditor::squiggles() const {
  QStringList out;
  for (const QTextEdit::ExtraSelection& each : extraSelections()) out << each.cursor.selectedText();
  return out;
}

QString SceneEditor::meaning_at(int line, int column) const {
  const language::SemanticToken* token = highlighter_->token_at(line, column);
  return token ? language::meaning_names().at(static_cast<size_t>(token->meaning)) : "";
}

bool SceneEditor::event(QEvent* event) {
  // The keys of undo and redo are those of the window.
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) return false;
  }
  return QPlainTextEdit::event(event);
}

void SceneEditor::keyPressEvent(QKeyEvent* event) {
  const bool open = completer_->popup()->isVisible();
  const bool chooses = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter ||
                       event->key() == Qt::Key_Tab;
  if (open && chooses) {
    QModelIndex index = completer_->popup()->currentIndex();
    if (!index.isValid()) index = completer_->popup()->model()->index(0, 0);
    completer_->popup()->hide();
    return insert_completion(index);
  }
  if (event->key() == Qt::Key_Space && event->modifiers() == Qt::ControlModifier) return complete();
  QPlainTextEdit::keyPressEvent(event);
  if (open && !event->text().isEmpty()) complete();
}

void SceneEditor::complete() {
  const workbench::SceneBench& bench = studio_.bench();
  if (!bench.has_document()) return;
  const QTextCursor caret = textCursor();
  const QString before = caret.block().text().left(caret.positionInBlock());
  const language::Position at{caret.blockNumber() + 1,
                              static_cast<int>(before.toUcs4().size()) + 1};
  const language::AnalysisPtr analysis = bench.analysis();
  const language::Completions found = language::complete(bench.workspace(), *analysis, at);
  completed_ = found.range;
  completions_->clear();
  std::vector<language::Completion> items = found.items;
  std::stable_sort(items.begin(), items.end(),
                   [](const auto& a, const auto& b) { return a.rank < b.rank; });
  for (const language::Completion& each : items) {
    auto* item = new QStandardItem(text_of(each.label));
    item->setData(without_fields(each.snippet.empty() ? each.label : each.snippet), kSnippetRole);
    item->setToolTip(text_of(each.detail + (each.doc.empty() ? "" : "\n" + each.doc)));
    completions_->appendRow(item);
  }
  QTextCursor prefix = cursor_of(found.range);
  const int begin = prefix.selectionStart();
  prefix.setPosition(begin);
  prefix.setPosition(std::max(begin, caret.position()), QTextCursor::KeepAnchor);
  completer_->setCompletionPrefix(prefix.selectedText());
  if (completer_->completionCount() == 0) return completer_->popup()->hide();
  QRect place = cursorRect();
  place.setWidth(320 + completer_->popup()->verticalScrollBar()->sizeHint().width());
  completer_->complete(place);
  completer_->popup()->setCurrentIndex(completer_->popup()->model()->index(0, 0));
}

void SceneEditor::insert_completion(const QModelIndex& index) {
  if (!index.isValid()) return;
  QTextCursor cursor = cursor_of(completed_);
  const int begin = cursor.selectionStart();
  const int end = std::max(cursor.selectionEnd(), textCursor().position());
  cursor.setPosition(begin);
  cursor.setPosition(end, QTextCursor::KeepAnchor);
  cursor.insertText(index.data(kSnippetRole).toString());
  setTextCursor(cursor);
}

}  // namespace vug::studio
