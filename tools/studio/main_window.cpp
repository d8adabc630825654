// SPDX-License-Identifier: Apache-2.0
#include "main_window.h"

#include "prompts.h"
#include "recovery_bar.h"
#include "score_panel.h"
#include "specification_panel.h"
#include "theme.h"
#include "tree_panel.h"

#include <vug/workbench/command.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>
#include <QCloseEvent>
#include <QDropEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QSlider>
#include <QSplitter>
#include <QStatusBar>
#include <QVBoxLayout>
#include <algorithm>

namespace vug::studio {

MainWindow::MainWindow(Studio& studio) : studio_(studio) {
  setObjectName("window");
  setAccessibleName(tr("Vug Studio"));
  setAcceptDrops(true);
  resize(1280, 820);
  build_panels();
  build_menus();
  build_tool_bar();
  message_ = new QLabel;
  message_->setObjectName("message");
  message_->setAccessibleName(tr("Message"));
  message_->setTextInteractionFlags(Qt::NoTextInteraction);
  position_ = new QLabel;
  position_->setAccessibleName(tr("Position"));
  position_->setMinimumWidth(170);
  statusBar()->addWidget(message_, 1);
  statusBar()->addPermanentWidget(position_);
  statusBar()->setSizeGripEnabled(false);
  connect(canvas_, &Canvas::pointed, position_, &QLabel::setText);
  connect(&studio_, &Studio::message, this, &MainWindow::show_message);
  connect(&studio_, &Studio::changed, this, &MainWindow::refresh);
  refresh();
}

void MainWindow::build_panels() {
  actions_ = new ActionPanel(studio_);
  canvas_ = new Canvas(studio_);
  auto* left = new QSplitter(Qt::Vertical);
  left->addWidget(actions_);
  left->addWidget(new TreePanel(studio_));
  left->setStretchFactor(1, 1);
  left->setChildrenCollapsible(false);
  auto* below = new QWidget;
  auto* line = new QHBoxLayout(below);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(0);
  line->addWidget(new SpecificationPanel(studio_), 1);
  line->addWidget(new ScorePanel(studio_));
  auto* middle = new QSplitter(Qt::Vertical);
  middle->addWidget(canvas_);
  middle->addWidget(below);
  middle->setStretchFactor(0, 1);
  middle->setChildrenCollapsible(false);
  middle->setSizes({590, 210});
  auto* all = new QSplitter;
  all->addWidget(left);
  all->addWidget(middle);
  all->setStretchFactor(1, 1);
  all->setChildrenCollapsible(false);
  all->setSizes({330, 950});
  auto* centre = new QWidget;
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  recovery_ = new QWidget;
  recovery_->hide();
  column->addWidget(recovery_);
  column->addWidget(all, 1);
  setCentralWidget(centre);
}

void MainWindow::refresh() {
  const workbench::FacadeBench& bench = studio_.bench();
  for (const auto& [name, action] : commands_) {
    const workbench::Command& command = workbench::find_command(name);
    const std::string why = command.unavailable ? command.unavailable(bench) : "";
    action->setEnabled(why.empty());
    const QString doc = text_of(command.doc);
    action->setToolTip(why.empty() ? doc : tr("%1 Not available: %2.").arg(doc, text_of(why)));
    action->setStatusTip(action->toolTip());
  }
  const bool open = bench.has_document();
  for (const auto& [name, action] : own_)
    if (action->data().toBool()) action->setEnabled(open);
  opacity_->setEnabled(open && !bench.photo().empty());
  if (!open) return setWindowTitle(tr("Vug Studio"));
  const auto name_step = [&](const char* name, const QString& title, const std::string& step) {
    commands_.at(name)->setText(step.empty() ? title : title + ": " + text_of(step));
  };
  name_step("undo", tr("Undo"), bench.stack().undo_name());
  name_step("redo", tr("Redo"), bench.stack().redo_name());
  opacity_->setValue(static_cast<int>(100 * bench.view().opacity));
  commands_.at("differences")->setChecked(bench.view().differences);
  const std::string file =
      bench.file().empty() ? bench.photo().filename().string() : bench.file().filename().string();
  setWindowTitle(tr("%1[*] – Vug Studio").arg(text_of(file)));
  setWindowModified(!bench.stack().is_clean());
}

void MainWindow::show_message(const QString& text, bool error) {
  QPalette palette = message_->palette();
  palette.setColor(QPalette::WindowText, error ? theme().error : theme().muted);
  message_->setPalette(palette);
  message_->setText(text);
  message_->setToolTip(text);
}

QString MainWindow::shown_message() const { return message_->text(); }

void MainWindow::ask_and_run(const std::string& name) {
  if ((name == "open" || name == "photo") && !may_discard()) return;
  if (const std::string line = prompt(*this, studio_, name); !line.empty()) studio_.run(line);
}

bool MainWindow::may_discard() {
  const workbench::FacadeBench& bench = studio_.bench();
  if (!bench.has_document() || bench.stack().is_clean()) return true;
  QMessageBox box(QMessageBox::Question, tr("Unsaved edits"),
                  tr("The edits of this session are not saved."),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setObjectName("unsaved");
  const int answer = box.exec();
  if (answer == QMessageBox::Save) ask_and_run("save");
  return answer == QMessageBox::Discard ||
         (answer == QMessageBox::Save && bench.stack().is_clean());
}

void MainWindow::closeEvent(QCloseEvent* event) { event->setAccepted(may_discard()); }

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString file = event->mimeData()->urls().value(0).toLocalFile();
  if (file.isEmpty() || !may_discard()) return;
  studio_.run((file.endsWith(".json") ? "open " : "photo ") +
              workbench::quoted(file.toStdString()));
}

void MainWindow::offer_recovery(const std::vector<workbench::LostJournal>& lost) {
  if (lost.empty()) return;
  fill_recovery_bar(*recovery_, lost.front(), [this, journal = lost.front()] {
    return may_discard() && studio_.recover(journal);
  });
}

void MainWindow::apply_theme() {
  for (const auto& [action, name] : icons_) action->setIcon(icon(name));
  Q_EMIT studio_.restyled();
  Q_EMIT studio_.changed();
}

}  // namespace vug::studio
