// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/lsystem/turtle_table.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::lsystem {

const std::vector<TurtleEntry>& turtle_table() {
  static const std::vector<TurtleEntry> all = {
      {TurtleAction::draw, {"F", 0, 2, "draws a stem of a length, to a radius at its end"}},
      {TurtleAction::trace, {"G", 0, 2, "like F, but draws a stem in an open polygon, too"}},
      {TurtleAction::move, {"f", 0, 1, "moves without drawing"}},
      {TurtleAction::left, {"+", 0, 1, "turns left by an angle, about its up vector"}},
      {TurtleAction::right, {"-", 0, 1, "turns right"}},
      {TurtleAction::down, {"&", 0, 1, "pitches down, about its left vector"}},
      {TurtleAction::up, {"^", 0, 1, "pitches up"}},
      {TurtleAction::roll_left, {"\\", 0, 1, "rolls left, about its heading"}},
      {TurtleAction::roll_right, {"/", 0, 1, "rolls right"}},
      {TurtleAction::back, {"|", 0, 0, "turns back, about its up vector"}},
      {TurtleAction::level,
       {"$", 0, 0, "rolls until its left is horizontal and its up points upwards"}},
      {TurtleAction::width,
       {"!", 0, 1, "sets the diameter; without a parameter stems get thinner"}},
      {TurtleAction::colour,
       {"'", 0, 1, "sets the number of the colour; without a parameter the next one"}},
      {TurtleAction::push, {"[", 0, 0, "begins a branch"}},
      {TurtleAction::pop, {"]", 0, 0, "ends the branch and returns to its start"}},
      {TurtleAction::open, {"{", 0, 0, "begins a polygon; F and f add the corner that they reach"}},
      {TurtleAction::corner, {".", 0, 0, "adds a corner"}},
      {TurtleAction::close, {"}", 0, 0, "ends the polygon"}},
      {TurtleAction::node,
       {"node", 0, 1, "adds a node to the stem, of a size; branches begin after it"}},
      {TurtleAction::age, {"age", 1, 1, "sets the age of everything that follows"}},
      {TurtleAction::guide, {"guide", 1, 2, "follows the curve of that number, times a scale"}},
      {TurtleAction::elasticity, {"elasticity", 1, 1, "sets how much stems bend to the tropism"}},
  };
  return all;
}

const std::vector<TurtleCommand>& turtle_commands() {
  static const std::vector<TurtleCommand> all = [] {
    std::vector<TurtleCommand> commands;
    for (const TurtleEntry& entry : turtle_table()) commands.push_back(entry.command);
    return commands;
  }();
  return all;
}

std::vector<SymbolAction> symbol_actions(const Alphabet& alphabet, const TurtleOptions& options) {
  std::vector<SymbolAction> all(alphabet.size());
  for (size_t id = 0; id < all.size(); ++id) {
    const std::string& name = alphabet.name(static_cast<SymbolId>(id));
    const auto& things = options.instances;
    if (const auto thing = std::find(things.begin(), things.end(), name); thing != things.end()) {
      all[id] = {TurtleAction::instance, static_cast<uint32_t>(thing - things.begin())};
      continue;
    }
    for (const TurtleEntry& entry : turtle_table()) {
      if (name != entry.command.name) continue;
      if (alphabet.parameters(static_cast<SymbolId>(id)) < entry.command.least)
        throw Error(ErrorCode::bad_input, fmt::format("the turtle's '{}' needs a parameter: it {}",
                                                      name, entry.command.doc));
      all[id].type = entry.action;
    }
  }
  return all;
}

}  // namespace vug::lsystem
