// SPDX-License-Identifier: Apache-2.0
#include "scene_window.h"

#include "changed_file_bar.h"
#include "look_bar.h"
#include "params_panel.h"
#include "pictures_panel.h"
#include "preset_bar.h"
#include "renders_panel.h"
#include "scene_lists.h"

#include <vug/base/pluralize.h>
#include <vug/language/outline.h>
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>
#include <QComboBox>
#include <QFileDialog>
#include <QInputDialog>
#include <QLabel>
#include <QMessageBox>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

namespace vug::studio {
namespace {

/// A splitter whose parts do not vanish.
QSplitter* splitter(Qt::Orientation orientation, const QList<QWidget*>& parts,
                    const QList<int>& sizes) {
  auto* out = new QSplitter(orientation);
  for (QWidget* each : parts) out->addWidget(each);
  out->setChildrenCollapsible(false);
  out->setSizes(sizes);
  return out;
}

/// Widgets one below the other; the one at `wide` takes the room.
QWidget* stacked(const QList<QWidget*>& parts, int wide) {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  for (int i = 0; i < parts.size(); ++i) column->addWidget(parts[i], i == wide ? 1 : 0);
  return box;
}

QWidget* titled(const QString& title, QWidget* content) {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 6, 0, 0);
  column->setSpacing(4);
  auto* heading = new QLabel(title);
  heading->setProperty("role", "heading");
  heading->setContentsMargins(12, 0, 0, 0);
  column->addWidget(heading);
  column->addWidget(content, 1);
  return box;
}

}  // namespace

SceneWindow::SceneWindow(SceneStudio& studio) : BenchWindow(studio), studio_(studio) {
  build_panels();
  build_menus();
  status_ = new QLabel;
  status_->setObjectName("status");
  status_->setAccessibleName(tr("Status of the picture"));
  status_->setMinimumWidth(300);
  build_status_bar(status_);
  connect(&studio_, &SceneStudio::changed, this, &SceneWindow::refresh);
  connect(&studio_, &SceneStudio::news, this, &SceneWindow::show_status);
  refresh();
}

void SceneWindow::build_panels() {
  editor_ = new SceneEditor(studio_);
  viewport_ = new ViewportWidget(studio_);
  lists_ = new QTabWidget;
  lists_->setObjectName("lists");
  lists_->setAccessibleName(tr("Lists"));
  lists_->setDocumentMode(true);
  lists_->tabBar()->setDrawBase(false);
  lists_->addTab(new ProblemList(studio_), tr("Problems"));
  lists_->addTab(new PicturesPanel(studio_), tr("Pictures"));
  lists_->addTab(new RendersPanel(studio_, [this] { ask_and_run("queue_render"); }), tr("Renders"));
  auto* left = splitter(Qt::Vertical, {editor_, lists_}, {540, 190});
  auto* side = splitter(
      Qt::Vertical,
      {titled(tr("Parameters"), stacked({new PresetBar(studio_), new ParamsPanel(studio_)}, 1)),
       titled(tr("Outline"), new OutlineTree(studio_))},
      {380, 340});
  auto* middle = stacked({viewport_, new LookBar(studio_)}, 0);
  auto* all = splitter(Qt::Horizontal, {left, middle, side}, {480, 540, 260});
  left->setStretchFactor(0, 1);
  all->setStretchFactor(1, 1);
  set_content(stacked({new ChangedFileBar(studio_), all}, 1));
}

void SceneWindow::show_list(int index) {
  lists_->setCurrentIndex(index);
  lists_->currentWidget()->setFocus();
}

void SceneWindow::refresh() {
  const workbench::SceneBench& bench = studio_.bench();
  const bool open = bench.has_document();
  mode_->setEnabled(open);
  if (!open) return setWindowTitle(tr("Vug Studio"));
  name_steps(bench.stack().undo_name(), bench.stack().redo_name());
  set_title(bench.file().filename().string(), bench.is_modified());
  mode_->setCurrentIndex(static_cast<int>(bench.viewport().request().mode));
  show_status();
}

void SceneWindow::show_status() {
  const workbench::SceneBench& bench = studio_.bench();
  refresh_commands(bench, workbench::find_scene_command);
  if (!bench.has_document()) return;
  const viewport::ViewportStatus status = bench.status();
  QString text;
  if (status.building)
    text =
        tr("Building: %1, %2 %").arg(text_of(status.stage)).arg(100 * status.fraction, 0, 'f', 0);
  else if (status.stopped)
    text = tr("Stopped; F5 builds the text");
  else if (status.picture)
    text = tr("%1 x %2, %3%4")
               .arg(status.picture->width)
               .arg(status.picture->height)
               .arg(text_of(pluralize(static_cast<size_t>(status.picture->samples), "sample")))
               .arg(status.picture->complete ? "" : tr(", more follow"));
  status_->setText(text);
}

void SceneWindow::ask_and_run(const std::string& name) {
  const QString folder =
      studio_.bench().has_document()
          ? text_of(std::filesystem::absolute(studio_.bench().file()).parent_path().string())
          : QString();
  const QString kinds = tr("Scenes (*.vug)");
  QString file;
  if (name == "open" && !may_discard()) return;
  if (name == "open") file = QFileDialog::getOpenFileName(this, tr("Open scene"), folder, kinds);
  if (name == "save") file = QFileDialog::getSaveFileName(this, tr("Save scene"), folder, kinds);
  if (name == "queue_render") return ask_for_render();
  if (name == "save_preset") {
    bool given = false;
    const QString preset =
        QInputDialog::getText(this, tr("Save preset"), tr("Name"), QLineEdit::Normal, "", &given);
    if (given) studio_.run(name + " " + workbench::quoted(preset.toStdString()));
    return;
  }
  if (name == "go") {
    bool given = false;
    const int line =
        QInputDialog::getInt(this, tr("Go to line"), tr("Line"), 1, 1, 1'000'000, 1, &given);
    if (given) studio_.run(fmt::format("go {}", line));
    return editor_->setFocus();
  }
  if (!file.isEmpty()) studio_.run(name + " " + workbench::quoted(file.toStdString()));
}

void SceneWindow::ask_for_render() {
  const std::filesystem::path scene = std::filesystem::absolute(studio_.bench().file());
  QStringList renders;
  for (const language::OutlineItem& each : language::outline_of(*studio_.bench().analysis()))
    if (each.detail == "render") renders << text_of(each.name);
  QString render;
  if (renders.size() > 1) {
    bool given = false;
    render = QInputDialog::getItem(this, tr("Queue a render"), tr("Render block"), renders, 0,
                                   false, &given);
    if (!given) return;
  }
  const QString stem = text_of((scene.parent_path() / scene.stem()).string());
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Queue a render"), stem + (render.isEmpty() ? "" : "_" + render) + ".exr",
      tr("Pictures (*.exr)"));
  if (file.isEmpty()) return;
  if (studio_.run("queue_render " + workbench::quoted(file.toStdString()) +
                  (render.isEmpty() ? "" : " " + workbench::quoted(render.toStdString()))))
    show_list(2);
}

bool SceneWindow::may_discard() {
  const workbench::SceneBench& bench = studio_.bench();
  if (!bench.has_document() || !bench.is_modified()) return true;
  QMessageBox box(QMessageBox::Question, tr("Unsaved text"), tr("The text is not saved."),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setObjectName("unsaved");
  const int answer = box.exec();
  if (answer == QMessageBox::Save) return studio_.run("save");
  return answer == QMessageBox::Discard;
}

}  // namespace vug::studio
