// SPDX-License-Identifier: Apache-2.0
#include "pictures_panel.h"

#include "focused_box.h"
#include "list_layout.h"
#include "named_button.h"

#include <fmt/format.h>
#include <QComboBox>
#include <QContextMenuEvent>

namespace vug::studio {
namespace {

constexpr int kPictureNumber = Qt::UserRole;
constexpr QSize kThumbnail(112, 63);

QImage thumbnail(const workbench::ShownPicture& picture) {
  const QImage whole(picture.rgb.data(), picture.width, picture.height, 3 * picture.width,
                     QImage::Format_RGB888);
  return whole.scaled(kThumbnail, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

}  // namespace

PictureList::PictureList(SceneStudio& studio) : studio_(studio) {
  setObjectName("pictures");
  setAccessibleName(tr("Kept pictures"));
  setToolTip(tr("Click: show; right button or R: compare with it; Del: forget"));
  setViewMode(QListView::IconMode);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setIconSize(kThumbnail);
  setSpacing(4);
  connect(this, &QListWidget::itemActivated, this,
          [this](const QListWidgetItem* item) { run("show_picture", item); });
  connect(this, &QListWidget::itemClicked, this,
          [this](const QListWidgetItem* item) { run("show_picture", item); });
  connect(&studio_, &SceneStudio::changed, this, &PictureList::refresh);
}

int PictureList::current() const {
  return currentItem() ? currentItem()->data(kPictureNumber).toInt() : 0;
}

void PictureList::run(const char* command, const QListWidgetItem* item) {
  if (item) studio_.run(fmt::format("{} {}", command, item->data(kPictureNumber).toInt()));
}

void PictureList::contextMenuEvent(QContextMenuEvent* event) {
  run("reference_picture",
      event->reason() == QContextMenuEvent::Mouse ? itemAt(event->pos()) : currentItem());
}

void PictureList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_R) return run("reference_picture", currentItem());
  if (event->key() == Qt::Key_Delete && current() != 0) return run("forget_picture", currentItem());
  QListWidget::keyPressEvent(event);
}

void PictureList::refresh() {
  const workbench::PictureHistory& history = studio_.bench().history();
  if (!studio_.bench().has_document() || history.revision() == shown_) return;
  shown_ = history.revision();
  const bool compares = history.comparison() != workbench::ComparisonMode::off;
  const int rows = static_cast<int>(history.all().size()) + 1;
  // Items are kept: this is also called from within the click on one of them.
  while (count() > rows) delete takeItem(count() - 1);
  while (count() < rows) addItem(new QListWidgetItem);
  for (int row = 0; row < rows; ++row) {
    const workbench::KeptPicture* kept =
        row > 0 ? history.all()[static_cast<size_t>(row - 1)].get() : nullptr;
    const int number = kept ? kept->number : 0;
    QListWidgetItem* each = item(row);
    if (each->data(kPictureNumber) != QVariant(number)) {
      QPixmap blank(kThumbnail);
      blank.fill(palette().color(QPalette::Mid));
      each->setData(kPictureNumber, number);
      each->setIcon(kept ? QPixmap::fromImage(thumbnail(kept->shown)) : blank);
    }
    QString label = kept ? QString::number(number) : tr("Present");
    if (number == history.shown()) label += compares ? tr(" (A)") : tr(" (shown)");
    if (compares && number == history.reference()) label += tr(" (B)");
    const QString doc = kept ? text_of(kept->settings()) : tr("The picture of the present text");
    each->setText(label);
    each->setToolTip(doc);
    each->setData(Qt::AccessibleTextRole, label + ": " + doc);
  }
  if (!currentItem()) setCurrentRow(0);
}

PicturesPanel::PicturesPanel(SceneStudio& studio) : studio_(studio) {
  const auto [column, line] = list_layout(this);
  keep_ = named_button(tr("Keep"), "keep picture");
  keep_->setToolTip(tr("Keeps the picture with its text, view and display"));
  comparison_ = new FocusedBox<QComboBox>;
  comparison_->setObjectName("comparison");
  comparison_->setAccessibleName(tr("Comparison"));
  comparison_->setToolTip(tr("A: the shown picture; B: the reference"));
  comparison_->addItems({tr("Show A"), tr("Wipe A | B"), tr("Difference")});
  restore_ = named_button(tr("Restore text"), "restore text");
  restore_->setToolTip(tr("Replaces the text by that of the selected picture; undo returns"));
  forget_ = named_button(tr("Forget"), "forget picture");
  forget_->setToolTip(tr("Removes the selected picture"));
  for (QWidget* each : std::initializer_list<QWidget*>{keep_, comparison_, restore_, forget_})
    line->addWidget(each);
  line->addStretch(1);
  list_ = new PictureList(studio_);
  column->addWidget(list_, 1);
  setFocusProxy(list_);
  connect(keep_, &QPushButton::clicked, this, [this] { studio_.run("keep_picture"); });
  connect(comparison_, &QComboBox::activated, this, [this](int index) {
    studio_.run("compare " + workbench::comparison_names()[static_cast<size_t>(index)]);
  });
  connect(restore_, &QPushButton::clicked, this,
          [this] { studio_.run(fmt::format("restore_text {}", list_->current())); });
  connect(forget_, &QPushButton::clicked, this,
          [this] { studio_.run(fmt::format("forget_picture {}", list_->current())); });
  connect(list_, &QListWidget::currentItemChanged, this, &PicturesPanel::refresh);
  connect(&studio_, &SceneStudio::changed, this, &PicturesPanel::refresh);
  connect(&studio_, &SceneStudio::news, this, &PicturesPanel::refresh);
  refresh();
}

void PicturesPanel::refresh() {
  const workbench::SceneBench& bench = studio_.bench();
  const bool some = bench.status().picture != nullptr;
  keep_->setEnabled(some);
  comparison_->setEnabled(some);
  restore_->setEnabled(list_->current() != 0);
  forget_->setEnabled(list_->current() != 0);
  comparison_->setCurrentIndex(static_cast<int>(bench.history().comparison()));
}

}  // namespace vug::studio
