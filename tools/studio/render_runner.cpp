// SPDX-License-Identifier: Apache-2.0
#include "render_runner.h"

#include "bench_studio.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTimer>
#include <csignal>

namespace vug::studio {
namespace {

/// Milliseconds in which a program writes its checkpoint and ends.
constexpr int kEndTimeout = 10'000;
/// Lower priority than that of the window, which must stay fluent.
constexpr int kNiceness = 10;

/// $VUG, or the program next to this one, or the one in PATH.
QString vug_program() {
  if (const QString named = qEnvironmentVariable("VUG"); !named.isEmpty()) return named;
  const QString beside = QCoreApplication::applicationDirPath() + "/vug";
  return QFileInfo(beside).isExecutable() ? beside : QStandardPaths::findExecutable("vug");
}

}  // namespace

RenderRunner::RenderRunner(workbench::RenderQueue& queue, QObject* parent)
    : QObject(parent), queue_(queue) {
  process_.setStandardOutputFile(QProcess::nullDevice());
  process_.setStandardInputFile(QProcess::nullDevice());
  // A killed window leaves no render behind, which would write the same checkpoint as the next one.
  process_.setChildProcessModifier([] {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    [[maybe_unused]] const int niceness = ::nice(kNiceness);
  });
  end_timer_.setSingleShot(true);
  connect(&end_timer_, &QTimer::timeout, &process_, &QProcess::kill);
  connect(&process_, &QProcess::readyReadStandardError, this, [this] {
    queue_.said(number_, process_.readAllStandardError().toStdString());
    Q_EMIT changed();
  });
  connect(&process_, &QProcess::finished, this, [this](int exit, QProcess::ExitStatus status) {
    queue_.said(number_, process_.readAllStandardError().toStdString());
    end(status == QProcess::NormalExit ? exit : -1);
  });
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;
    queue_.said(number_, tr("error: cannot run 'vug': %1\nhint: install it next to vug-studio, or "
                            "name it in the environment variable VUG\n")
                             .arg(process_.errorString())
                             .toStdString());
    end(-1);
  });
}

RenderRunner::~RenderRunner() {
  process_.disconnect(this);
  if (number_ == 0) return;
  process_.terminate();
  if (!process_.waitForFinished(kEndTimeout)) process_.kill();
}

void RenderRunner::update() {
  if (number_ == 0) {
    if (const auto next = queue_.next()) start(*next);
  } else if (queue_.find(number_).state != workbench::RenderState::running &&
             !end_timer_.isActive()) {
    process_.terminate();
    end_timer_.start(kEndTimeout);
  }
}

void RenderRunner::start(int number) {
  const workbench::QueuedRender& render = queue_.find(number);
  QStringList arguments;
  for (const std::string& each : render.arguments()) arguments << text_of(each);
  process_.setWorkingDirectory(text_of(render.scene.parent_path().string()));
  number_ = number;
  queue_.started(number);
  process_.start(vug_program(), arguments);
  Q_EMIT changed();
}

void RenderRunner::end(int exit) {
  end_timer_.stop();
  queue_.ended(std::exchange(number_, 0), exit);
  Q_EMIT changed();
  // Not from within the signal of the process that has just ended.
  QTimer::singleShot(0, this, &RenderRunner::update);
}

}  // namespace vug::studio
