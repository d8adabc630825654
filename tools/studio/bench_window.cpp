// SPDX-License-Identifier: Apache-2.0
#include "bench_window.h"

#include "recovery_bar.h"
#include "theme.h"

#include <QAction>
#include <QCloseEvent>
#include <QLabel>
#include <QMenu>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

namespace vug::studio {

BenchWindow::BenchWindow(BenchStudio& studio) : base_(studio) {
  setObjectName("window");
  setAccessibleName(tr("Vug Studio"));
  resize(1280, 820);
}

void BenchWindow::set_content(QWidget* content) {
  auto* centre = new QWidget;
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  recovery_ = new QWidget;
  recovery_->hide();
  column->addWidget(recovery_);
  column->addWidget(content, 1);
  setCentralWidget(centre);
}

void BenchWindow::build_status_bar(QWidget* permanent) {
  message_ = new QLabel;
  message_->setObjectName("message");
  message_->setAccessibleName(tr("Message"));
  message_->setTextInteractionFlags(Qt::NoTextInteraction);
  statusBar()->addWidget(message_, 1);
  statusBar()->addPermanentWidget(permanent);
  statusBar()->setSizeGripEnabled(false);
  connect(&base_, &BenchStudio::message, this, &BenchWindow::show_message);
}

QAction* BenchWindow::add_entry(QMenu* menu, const Entry& entry, const std::function<void()>& run) {
  auto* action = new QAction(entry.title, this);
  action->setObjectName(entry.name);
  action->setShortcuts(entry.keys);
  connect(action, &QAction::triggered, this, run);
  if (!entry.icon.isEmpty()) icons_[action] = entry.icon, action->setIcon(icon(entry.icon));
  menu->addAction(action);
  addAction(action);
  return action;
}

void BenchWindow::show_availability(QAction& action, const QString& doc,
                                    const std::string& obstacle) {
  action.setEnabled(obstacle.empty());
  action.setToolTip(obstacle.empty() ? doc
                                     : tr("%1 Not available: %2.").arg(doc, text_of(obstacle)));
  action.setStatusTip(action.toolTip());
}

void BenchWindow::name_steps(const std::string& undo, const std::string& redo) {
  const auto titled = [](const QString& title, const std::string& step) {
    return step.empty() ? title : title + ": " + text_of(step);
  };
  command("undo")->setText(titled(tr("Undo"), undo));
  command("redo")->setText(titled(tr("Redo"), redo));
}

void BenchWindow::set_title(const std::string& file, bool modified) {
  setWindowTitle(tr("%1[*] – Vug Studio").arg(text_of(file)));
  setWindowModified(modified);
}

QToolBar* BenchWindow::add_tools() {
  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName("tools");
  bar->setAccessibleName(tr("Tools"));
  bar->setMovable(false);
  bar->setIconSize({20, 20});
  return bar;
}

void BenchWindow::show_message(const QString& text, bool error) {
  QPalette palette = message_->palette();
  palette.setColor(QPalette::WindowText, error ? theme().error : theme().muted);
  message_->setPalette(palette);
  message_->setText(text);
  message_->setToolTip(text);
}

QString BenchWindow::shown_message() const { return message_->text(); }

void BenchWindow::closeEvent(QCloseEvent* event) { event->setAccepted(may_discard()); }

void BenchWindow::offer_recovery(const std::vector<workbench::LostJournal>& lost) {
  if (lost.empty()) return;
  fill_recovery_bar(*recovery_, lost.front(), [this, journal = lost.front()] {
    return may_discard() && base_.recover(journal);
  });
}

void BenchWindow::apply_theme() {
  for (const auto& [action, name] : icons_) action->setIcon(icon(name));
  Q_EMIT base_.restyled();
  Q_EMIT base_.changed();
}

}  // namespace vug::studio
