// SPDX-License-Identifier: Apache-2.0
// Commands: the one language of buttons, menus, keys, the palette, scripts and journals. A command
// is a line of text: its name, then its arguments.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/kind.h>
#include <vug/modeller/edit.h>
#include <vug/workbench/words.h>

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

/// A command of a bench: of facades (FacadeBench) or of scenes (SceneBench).
template <class Bench>
struct CommandOf {
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
  std::string (*unavailable)(const Bench&) = nullptr;
  void (*run)(Bench&, const CommandCall&) = nullptr;
};
using Command = CommandOf<FacadeBench>;

/// The commands in commands/; generated from the list in CMakeLists.txt.
const std::vector<const Command*>& commands();
/// These commands, and one for each kind of edit (modeller::edit_kinds), sorted by name.
const std::vector<const Command*>& all_commands();
/// Error(bad_input) with the nearest name for an unknown command.
template <class Bench>
const CommandOf<Bench>& find_command_in(const std::vector<const CommandOf<Bench>*>& all,
                                        const std::string& name) {
  std::vector<std::string> names;
  for (const CommandOf<Bench>* each : all) {
    if (each->name == name) return *each;
    names.push_back(each->name);
  }
  throw Error(ErrorCode::bad_input, "unknown command '" + name + "'", {},
              did_you_mean(name, names, "Ctrl+Shift+P lists all commands"));
}
const Command& find_command(const std::string& name);

/// Splits a line into its command and the arguments; null for an empty line and a comment.
/// Error(bad_input) for an unknown command, wrong arguments, or a command that is not available.
template <class Bench>
const CommandOf<Bench>* parse_command(const std::vector<const CommandOf<Bench>*>& all,
                                      const Bench& bench, const std::string& line,
                                      CommandCall& call) {
  call.words = split_words(line);
  if (call.words.empty()) return nullptr;
  const CommandOf<Bench>& command = find_command_in(all, call.words.front());
  call.words.erase(call.words.begin());
  call.rest = line.substr(line.find(command.name) + command.name.size());
  if (call.words.size() < command.required || call.words.size() > command.most)
    throw Error(ErrorCode::bad_input, "wrong number of arguments: '" + line + "'", {},
                command.name + " " + command.arguments);
  if (command.unavailable)
    if (const std::string why = command.unavailable(bench); !why.empty())
      throw Error(ErrorCode::bad_input, "'" + command.name + "' is not available: " + why);
  return &command;
}

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
