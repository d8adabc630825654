// SPDX-License-Identifier: Apache-2.0
// The controller of a window, without its bench: runs command lines, and announces changes and
// errors.
#pragma once

#include <vug/base/error.h>
#include <vug/workbench/recovery.h>

#include <QObject>
#include <QString>
#include <string>

namespace vug::studio {

class BenchStudio : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Runs a command line; throws vug::Error.
  virtual void execute(const std::string& line) = 0;
  /// Runs a command line and shows its error as a message; false if it failed.
  bool run(const std::string& line);
  /// Recovers the work of a killed program. An error is shown as a message; false if it prevented
  /// that the document was opened.
  virtual bool recover(const workbench::LostJournal& lost) = 0;

 Q_SIGNALS:
  void changed();   ///< The document, the selection or the view.
  void restyled();  ///< Another theme.
  void message(const QString& text, bool error);

 protected:
  void show(const Error& error);
};

/// Text of the library, which is UTF-8.
inline QString text_of(const std::string& text) { return QString::fromStdString(text); }

}  // namespace vug::studio
