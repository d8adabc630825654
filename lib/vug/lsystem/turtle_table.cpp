#include <vug/base/error.h>
#include <vug/lsystem/turtle_table.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::lsystem {

const std::vector<TurtleEntry>& turtle_table() {
  static const std::vector<TurtleEntry> all = {
      {Turn::draw, {"F", 0, 2, "draws a stem of a length, to a radius at its end"}},
      {Turn::trace, {"G", 0, 2, "the same, also where a polygon is open"}},
      {Turn::move, {"f", 0, 1, "moves without drawing"}},
      {Turn::left, {"+", 0, 1, "turns left by an angle, about its up"}},
      {Turn::right, {"-", 0, 1, "turns right"}},
      {Turn::down, {"&", 0, 1, "pitches down, about its left"}},
      {Turn::up, {"^", 0, 1, "pitches up"}},
      {Turn::roll_left, {"\\", 0, 1, "rolls left, about its heading"}},
      {Turn::roll_right, {"/", 0, 1, "rolls right"}},
      {Turn::back, {"|", 0, 0, "turns back, about its up"}},
      {Turn::level, {"$", 0, 0, "rolls until its left is level and its up is upwards"}},
      {Turn::width, {"!", 0, 1, "sets the diameter; without it stems get thinner"}},
      {Turn::colour, {"'", 0, 1, "sets the number of the colour; without it the next one"}},
      {Turn::push, {"[", 0, 0, "begins a branch"}},
      {Turn::pop, {"]", 0, 0, "ends it: back to where it began"}},
      {Turn::open, {"{", 0, 0, "begins a polygon; F and f add the corner they come to"}},
      {Turn::corner, {".", 0, 0, "adds a corner"}},
      {Turn::close, {"}", 0, 0, "ends the polygon"}},
      {Turn::node, {"node", 0, 1, "a node of the stem, of a size; branches begin after it"}},
      {Turn::age, {"age", 1, 1, "how old is what comes next"}},
      {Turn::guide, {"guide", 1, 2, "follows the curve of that number, times a scale"}},
      {Turn::elasticity, {"elasticity", 1, 1, "how much stems turn to the tropism"}},
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

std::vector<Meaning> meanings(const Alphabet& alphabet, const TurtleOptions& options) {
  std::vector<Meaning> all(alphabet.size());
  for (size_t id = 0; id < all.size(); ++id) {
    const std::string& name = alphabet.name(static_cast<SymbolId>(id));
    const auto& things = options.instances;
    if (const auto thing = std::find(things.begin(), things.end(), name); thing != things.end()) {
      all[id] = {Turn::instance, static_cast<uint32_t>(thing - things.begin())};
      continue;
    }
    for (const TurtleEntry& entry : turtle_table()) {
      if (name != entry.command.name) continue;
      if (alphabet.parameters(static_cast<SymbolId>(id)) < entry.command.least)
        throw Error(ErrorCode::bad_input, fmt::format("the turtle's '{}' needs a parameter: it {}",
                                                      name, entry.command.doc));
      all[id].turn = entry.turn;
    }
  }
  return all;
}

}  // namespace vug::lsystem
