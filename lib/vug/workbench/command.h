// SPDX-License-Identifier: Apache-2.0
// Commands: the one language of buttons, menus, keys, the palette, scripts and journals. A command
// is a line of text: its name, then its arguments.
#pragma once

#include <vug/base/kind.h>
#include <vug/modeller/edit.h>

#include <string>
#include <vector>

namespace vug::workbench {

class FacadeBench;

/// The words of a command line after its name.
struct CommandCall {
  std::vector<std::string> words;
  std::string rest;  ///< The text after the name, for commands with a syntax of their own.

  /// The word, or `otherwise`.
  std::string word(size_t index, const std::string& otherwise = "") const {
    return index < words.size() ? words[index] : otherwise;
  }
};

struct Command {
  std::string name;
  std::string title;           ///< For menus: "Open...".
  std::string doc;             ///< One sentence.
  std::string arguments = {};  ///< Syntax: "FILE [WIDTH]".
  /// In the form of Qt's portable text, "Ctrl+Shift+Z"; several are separated by "; ".
  std::string keys = {};
  bool changes = false;  ///< It changes the document, so that journals record it.
  bool opens = false;    ///< It replaces the document.
  bool saves = false;    ///< It writes the document to a file.
  size_t required = 0;   ///< Minimum number of words.
  size_t most = 100;     ///< Maximum number of words.
  /// The reason why it cannot run now; empty if it can.
  std::string (*unavailable)(const FacadeBench&) = nullptr;
  void (*run)(FacadeBench&, const CommandCall&) = nullptr;
};

/// The commands in commands/; generated from the list in CMakeLists.txt.
const std::vector<const Command*>& commands();
/// These commands, and one for each kind of edit (modeller::edit_kinds), sorted by name.
const std::vector<const Command*>& all_commands();
/// Error(bad_input) with the nearest name for an unknown command.
const Command& find_command(const std::string& name);

/// Runs a line and returns its command; null for an empty line and a comment, which do nothing.
/// Error(bad_input) for an unknown command, wrong arguments, or a command that is not available,
/// whose message is the reason.
const Command* run_command(FacadeBench& bench, const std::string& line);

/// Reasons that several commands share.
std::string without_document(const FacadeBench& bench);
std::string without_photo(const FacadeBench& bench);

/// The line of the command `replace`, which makes these edits the only ones.
std::string replace_line(const std::string& step, const std::vector<modeller::Edit>& edits);

}  // namespace vug::workbench

/// Opens the one definition that the file of a command exports; see VUG_EXPORT_KIND.
#define VUG_COMMAND(name) VUG_EXPORT_KIND(vug::workbench, Command, name##_command)
