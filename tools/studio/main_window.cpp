// SPDX-License-Identifier: Apache-2.0
#include "main_window.h"

#include "prompts.h"
#include "score_panel.h"
#include "specification_panel.h"
#include "tree_panel.h"

#include <vug/workbench/command.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>
#include <QDropEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QSlider>
#include <QSplitter>
#include <algorithm>

namespace vug::studio {

MainWindow::MainWindow(Studio& studio) : BenchWindow(studio), studio_(studio) {
  setAcceptDrops(true);
  build_panels();
  build_menus();
  build_tool_bar();
  auto* position = new QLabel;
  position->setAccessibleName(tr("Position"));
  position->setMinimumWidth(170);
  build_status_bar(position);
  connect(canvas_, &Canvas::pointed, position, &QLabel::setText);
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
  set_content(all);
}

void MainWindow::refresh() {
  const workbench::FacadeBench& bench = studio_.bench();
  refresh_commands(bench, workbench::find_command);
  const bool open = bench.has_document();
  for (const auto& [name, action] : own_)
    if (action->data().toBool()) action->setEnabled(open);
  opacity_->setEnabled(open && !bench.photo().empty());
  if (!open) return setWindowTitle(tr("Vug Studio"));
  name_steps(bench.stack().undo_name(), bench.stack().redo_name());
  opacity_->setValue(static_cast<int>(100 * bench.view().opacity));
  command("differences")->setChecked(bench.view().differences);
  const std::string file =
      bench.file().empty() ? bench.photo().filename().string() : bench.file().filename().string();
  set_title(file, !bench.stack().is_clean());
}

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

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString file = event->mimeData()->urls().value(0).toLocalFile();
  if (file.isEmpty() || !may_discard()) return;
  studio_.run((file.endsWith(".json") ? "open " : "photo ") +
              workbench::quoted(file.toStdString()));
}

}  // namespace vug::studio
