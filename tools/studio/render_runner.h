// SPDX-License-Identifier: Apache-2.0
// Runs the renders of the queue, one after the other, as processes of `vug render`.
#pragma once

#include <vug/workbench/render_queue.h>

#include <QProcess>
#include <QTimer>

namespace vug::studio {

class RenderRunner : public QObject {
  Q_OBJECT
 public:
  explicit RenderRunner(workbench::RenderQueue& queue, QObject* parent = nullptr);
  /// Asks the running program to write its checkpoint, and waits for it.
  ~RenderRunner() override;

  /// Starts the next render, or stops the one that no longer runs in the queue.
  void update();
  bool busy() const { return number_ != 0 || queue_.next(); }

 Q_SIGNALS:
  void changed();  ///< The queue: a progress, or an end.

 private:
  void start(int number);
  void end(int exit);

  workbench::RenderQueue& queue_;
  QProcess process_;
  QTimer end_timer_;  ///< Runs from the request to end until the process is killed.
  int number_ = 0;    ///< The render of the process; 0: none runs.
};

}  // namespace vug::studio
