// SPDX-License-Identifier: Apache-2.0
#include "renders_panel.h"

#include "list_layout.h"
#include "named_button.h"

#include <fmt/format.h>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <cmath>

namespace vug::studio {
namespace {

using workbench::QueuedRender;
using workbench::RenderState;

constexpr int kRenderNumber = Qt::UserRole;

QString state_text(const QueuedRender& render) {
  const int percent = static_cast<int>(std::lround(100 * render.fraction));
  switch (render.state) {
    case RenderState::waiting:
      return RendersPanel::tr("waiting");
    case RenderState::running:
      return render.stage.empty()
                 ? RendersPanel::tr("starting")
                 : RendersPanel::tr("%1, %2 %").arg(text_of(render.stage)).arg(percent);
    case RenderState::paused:
      return RendersPanel::tr("paused");
    case RenderState::done:
      return RendersPanel::tr("done");
    case RenderState::failed:
      return RendersPanel::tr("failed");
    case RenderState::cancelled:
      return RendersPanel::tr("ending");
  }
  return "";
}

QString source_text(const QueuedRender& render) {
  QString out = text_of(render.scene.filename().string());
  if (!render.render.empty()) out += ": " + text_of(render.render);
  for (const std::string& each : render.parameters) out += " " + text_of(each);
  return out;
}

}  // namespace

RendersPanel::RendersPanel(SceneStudio& studio, const std::function<void()>& add)
    : studio_(studio) {
  const auto [column, line] = list_layout(this);
  add_ = named_button(tr("Add..."), "add render");
  pause_ = named_button(tr("Pause"), "pause render");
  resume_ = named_button(tr("Resume"), "resume render");
  cancel_ = named_button(tr("Remove"), "cancel render");
  for (QPushButton* each : {add_, pause_, resume_, cancel_}) line->addWidget(each);
  line->addStretch(1);
  list_ = new QTreeWidget;
  list_->setObjectName("renders");
  list_->setAccessibleName(tr("Queue of renders"));
  list_->setHeaderLabels({tr("scene"), tr("state"), tr("file")});
  list_->setRootIsDecorated(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  column->addWidget(list_, 1);
  setFocusProxy(list_);
  error_ = new QLabel;
  error_->setObjectName("render error");
  error_->setAccessibleName(tr("Messages of the render"));
  error_->setWordWrap(true);
  error_->setTextFormat(Qt::PlainText);
  error_->setContentsMargins(8, 0, 8, 4);
  error_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  error_->hide();
  column->addWidget(error_);
  connect(add_, &QPushButton::clicked, this, add);
  connect(pause_, &QPushButton::clicked, this, [this] { run("pause_render"); });
  connect(resume_, &QPushButton::clicked, this, [this] { run("resume_render"); });
  connect(cancel_, &QPushButton::clicked, this, [this] { run("cancel_render"); });
  connect(list_, &QTreeWidget::currentItemChanged, this, &RendersPanel::refresh_buttons);
  connect(&studio_, &SceneStudio::changed, this, &RendersPanel::refresh);
  connect(&studio_.runner(), &RenderRunner::changed, this, &RendersPanel::refresh);
  refresh();
}

int RendersPanel::current() const {
  return list_->currentItem() ? list_->currentItem()->data(0, kRenderNumber).toInt() : 0;
}

void RendersPanel::run(const char* command) {
  if (current() != 0) studio_.run(fmt::format("{} {}", command, current()));
}

void RendersPanel::refresh() {
  const workbench::RenderQueue& queue = *studio_.bench().queue;
  if (queue.revision() != shown_) {
    shown_ = queue.revision();
    const int before = current(), count = static_cast<int>(queue.all().size());
    const QSignalBlocker quiet(list_);
    // Items are kept, so that the selection and the place in the list stay.
    while (list_->topLevelItemCount() > count) delete list_->topLevelItem(count);
    while (list_->topLevelItemCount() < count) list_->addTopLevelItem(new QTreeWidgetItem);
    for (int i = 0; i < count; ++i) {
      const QueuedRender& each = queue.all()[static_cast<size_t>(i)];
      QTreeWidgetItem* item = list_->topLevelItem(i);
      item->setData(0, kRenderNumber, each.number);
      item->setText(0, source_text(each));
      item->setText(1, state_text(each));
      item->setText(2, text_of(each.output.filename().string()));
      item->setToolTip(2, text_of(each.output.string()));
      item->setToolTip(1, text_of(each.error));
      if (each.number == before) list_->setCurrentItem(item);
    }
    if (!list_->currentItem() && count > 0) list_->setCurrentItem(list_->topLevelItem(count - 1));
  }
  refresh_buttons();
}

void RendersPanel::refresh_buttons() {
  const workbench::SceneBench& bench = studio_.bench();
  std::optional<QueuedRender> chosen;
  for (const QueuedRender& each : bench.queue->all())
    if (each.number == current()) chosen = each;
  const RenderState state = chosen ? chosen->state : RenderState::cancelled;
  add_->setEnabled(bench.has_document());
  pause_->setEnabled(state == RenderState::waiting || state == RenderState::running);
  resume_->setEnabled(state == RenderState::paused || state == RenderState::failed);
  cancel_->setEnabled(chosen && state != RenderState::cancelled);
  error_->setVisible(chosen && !chosen->error.empty());
  error_->setText(chosen ? text_of(chosen->error).trimmed() : "");
}

}  // namespace vug::studio
