// SPDX-License-Identifier: Apache-2.0
#include "look_bar.h"

#include "focused_box.h"

#include <vug/viewport/shown_layer.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

namespace vug::studio {
namespace {

constexpr double kMostStops = 20, kStopStep = 0.25;

}  // namespace

LookBar::LookBar(SceneStudio& studio) : studio_(studio) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(8, 4, 8, 4);
  rows->setSpacing(2);
  auto* line = new QHBoxLayout;
  rows->addLayout(line);
  pause_ = new QToolButton;
  pause_->setObjectName("pause");
  pause_->setAccessibleName(tr("Pause the refinement of the picture"));
  pause_->setText(tr("Pause"));
  pause_->setCheckable(true);
  pause_->setFocusPolicy(Qt::StrongFocus);
  line->addWidget(pause_);
  exposure_ = new FocusedBox<QDoubleSpinBox>;
  exposure_->setObjectName("exposure");
  exposure_->setAccessibleName(tr("Exposure"));
  exposure_->setToolTip(
      tr("Stops that are added to the exposure of the text, in the display path"));
  exposure_->setRange(-kMostStops, kMostStops);
  exposure_->setSingleStep(kStopStep);
  exposure_->setSuffix(tr(" stops"));
  line->addWidget(exposure_);
  tone_ = new FocusedBox<QComboBox>;
  tone_->setObjectName("tone");
  tone_->setAccessibleName(tr("View transform"));
  tone_->setToolTip(tr("View transform of the display path; scene: that of the text"));
  tone_->addItems({"scene", "filmic", "standard", "aces"});
  line->addWidget(tone_);
  denoise_ = new QToolButton;
  denoise_->setObjectName("denoise");
  denoise_->setAccessibleName(tr("Denoise the light"));
  denoise_->setToolTip(
      tr("Shows the light denoised, in the display path; the picture becomes finer meanwhile"));
  denoise_->setText(tr("Denoise"));
  denoise_->setCheckable(true);
  denoise_->setFocusPolicy(Qt::StrongFocus);
  line->addWidget(denoise_);
  layer_ = new FocusedBox<QComboBox>;
  layer_->setObjectName("layer");
  layer_->setAccessibleName(tr("Layer"));
  layer_->setToolTip(
      tr("Layer of the picture in the display path: beauty, an AOV or a light group"));
  layer_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  line->addWidget(layer_);
  pixel_ = new QLabel;
  pixel_->setObjectName("pixel");
  pixel_->setAccessibleName(tr("Inspected pixel"));
  pixel_->setWordWrap(true);
  pixel_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  line->addStretch(1);
  rows->addWidget(pixel_);
  connect(pause_, &QToolButton::clicked, this,
          [this](bool paused) { studio_.run(paused ? "pause" : "continue"); });
  connect(exposure_, &QDoubleSpinBox::valueChanged, this,
          [this](double stops) { studio_.run(fmt::format("exposure {:.2f}", stops)); });
  connect(tone_, &QComboBox::activated, this,
          [this] { studio_.run("tone " + tone_->currentText().toStdString()); });
  connect(denoise_, &QToolButton::clicked, this,
          [this](bool denoise) { studio_.run(denoise ? "denoise on" : "denoise off"); });
  connect(layer_, &QComboBox::activated, this, [this] {
    studio_.run("layer " + workbench::quoted(layer_->currentText().toStdString()));
  });
  connect(&studio_, &SceneStudio::changed, this, &LookBar::refresh);
  connect(&studio_, &SceneStudio::news, this, &LookBar::refresh);
  refresh();
}

void LookBar::refresh() {
  const workbench::SceneBench& bench = studio_.bench();
  const bool open = bench.has_document();
  pause_->setEnabled(open);
  const viewport::ViewportStatus status = bench.status();
  const viewport::PreviewRequest request =
      open ? bench.viewport().request() : viewport::PreviewRequest();
  const bool light = open && status.picture && request.mode == viewport::Mode::path;
  exposure_->setEnabled(light);
  tone_->setEnabled(light);
  denoise_->setEnabled(light);
  layer_->setEnabled(light);
  denoise_->setChecked(request.display.denoise);
  QStringList layers;
  if (status.picture)
    for (const std::string& each : viewport::layers_to_show(*status.picture->light))
      layers << text_of(each);
  if (!layers.isEmpty() && layers != layers_) {
    layers_ = layers;
    layer_->clear();
    layer_->addItems(layers);
  }
  layer_->setCurrentText(request.display.layer.empty() ? "beauty" : text_of(request.display.layer));
  pause_->setChecked(status.paused);
  const QSignalBlocker quiet(exposure_);
  if (std::abs(exposure_->value() - request.display.stops) > 0.005)
    exposure_->setValue(request.display.stops);
  const QString tone = request.display.view.empty() ? "scene" : text_of(request.display.view);
  if (tone_->findText(tone) < 0) tone_->addItem(tone);  // of a configuration, by a command
  tone_->setCurrentText(tone);
  pixel_->setText(bench.inspected() ? text_of(viewport::describe(*bench.inspected()))
                                    : tr("Ctrl + click in the picture reads a pixel"));
}

}  // namespace vug::studio
