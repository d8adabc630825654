// SPDX-License-Identifier: Apache-2.0
// The command palette: a line that runs any command, with a list of those that match.
#pragma once

#include <QDialog>
#include <functional>
#include <string>
#include <vector>

class QLineEdit;
class QListWidget;

namespace vug::studio {

/// A command in the list.
struct PaletteEntry {
  std::string name, arguments, doc, keys;
  std::string unavailable;  ///< The reason; empty if it can run.
  bool asks = false;        ///< It has required arguments.
};

class CommandPalette : public QDialog {
  Q_OBJECT
 public:
  /// `run` performs a line and returns whether it succeeded. `example`: a line with arguments.
  CommandPalette(std::vector<PaletteEntry> entries, std::function<bool(const std::string&)> run,
                 const QString& example, QWidget* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void filter();
  void add(const PaletteEntry& entry);
  /// 0 to 2 for a command that matches, the best first; 3 for another one.
  static int rank_of(const PaletteEntry& entry, const QString& wanted);
  void run();

  std::vector<PaletteEntry> entries_;
  std::function<bool(const std::string&)> run_;
  QLineEdit* line_;
  QListWidget* list_;
};

/// The entries of a bench's commands.
template <class Commands, class Bench>
std::vector<PaletteEntry> palette_entries(const Commands& commands, const Bench& bench) {
  std::vector<PaletteEntry> out;
  for (const auto* each : commands)
    out.push_back({each->name, each->arguments, each->doc, each->keys,
                   each->unavailable ? each->unavailable(bench) : "", each->required > 0});
  return out;
}

}  // namespace vug::studio
