// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

#include <fmt/format.h>

#include <algorithm>
#include <deque>

namespace vug::workbench {
namespace {

/// The command of an edit's kind; edits are not bound to keys, since they name a node.
Command edit_command(const modeller::EditKind& kind) {
  Command out;
  out.name = kind.name;
  out.title = kind.name;
  out.doc = kind.doc;
  out.arguments = "NODE";
  if (kind.rule) out.arguments += " RULE";
  for (const std::string& number : kind.numbers) out.arguments += fmt::format(" {}=N", number);
  if (kind.free_numbers) out.arguments += " [NAME=N ...]";
  out.changes = true;
  out.required = 1;
  out.unavailable = without_document;
  return out;
}

bool is_edit(const std::string& name) {
  const auto& kinds = modeller::edit_kinds();
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](const modeller::EditKind* kind) { return kind->name == name; });
}

void run_edit(FacadeBench& bench, const std::string& name, const std::string& rest) {
  modeller::Edit edit = modeller::parse_edit(rest, name, bench.document().metres_per_pixel());
  // "." is the selected node in commands, since the facade itself has no rule.
  if (edit.node == ".") edit.node = bench.state().path(bench.selected());
  bench.edit(edit);
}

}  // namespace

const std::vector<const Command*>& all_commands() {
  static const std::vector<const Command*> all = [] {
    static std::deque<Command> edits;
    std::vector<const Command*> out = commands();
    for (const modeller::EditKind* kind : modeller::edit_kinds())
      out.push_back(&edits.emplace_back(edit_command(*kind)));
    std::sort(out.begin(), out.end(),
              [](const Command* a, const Command* b) { return a->name < b->name; });
    return out;
  }();
  return all;
}

const Command& find_command(const std::string& name) {
  return find_command_in(all_commands(), name);
}

const Command* run_command(FacadeBench& bench, const std::string& line) {
  CommandCall call;
  const Command* command = parse_command<FacadeBench>(all_commands(), bench, line, call);
  if (!command) return nullptr;
  if (is_edit(command->name))
    run_edit(bench, command->name, call.rest);
  else
    command->run(bench, call);
  if (command->changes && bench.journal) bench.journal(line);
  return command;
}

std::string without_document(const FacadeBench& bench) {
  return bench.has_document() ? "" : "no facade is open";
}

std::string without_photo(const FacadeBench& bench) {
  if (!bench.has_document()) return without_document(bench);
  return bench.photo().empty() ? "the session has no photo" : "";
}

std::string replace_line(const std::string& step, const std::vector<modeller::Edit>& edits) {
  std::string out = "replace " + quoted(step);
  for (const modeller::Edit& edit : edits) out += ' ' + quoted(to_string(edit));
  return out;
}

}  // namespace vug::workbench
