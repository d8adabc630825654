// SPDX-License-Identifier: Apache-2.0
// The paper's experiment as a grammar.
#include <vug/sgm/derive.h>

#include <algorithm>
#include <cmath>

namespace vug::sgm {
namespace {

using grammar::Content;
using grammar::Production;
using grammar::RewriteSite;
using grammar::SuccessorItem;

void require(bool holds, const std::string& message) {
  if (!holds) throw Error(ErrorCode::bad_input, message);
}

void require_valid(const Rules& rules) {
  require(rules.classic >= 0 && rules.morphic >= 0 && rules.classic + rules.morphic > 0,
          "PC and PM are numbers of productions: both must be 0 or more, and one at least 1");
  require(rules.pieces >= 0, "PS is a number of primitives: it must be 0 or more");
  require(rules.amount >= 0 && rules.amount <= 1, "MP must be between 0 % and 100 %");
  double total = 0;
  for (const ShapeChoice& shape : rules.shapes) {
    require(shape.weight >= 0 && std::isfinite(shape.weight) && shape.make,
            "the shape '" + shape.name + "' needs a weight of 0 or more");
    total += shape.weight;
  }
  require(total > 0, "an experiment needs at least one shape to choose from");
}

Piece draw(const std::vector<ShapeChoice>& shapes, RandomKey key) {
  double total = 0;
  for (const ShapeChoice& shape : shapes) total += shape.weight;
  double dart = RandomStream(key.at("choice")).uniform() * total;
  const ShapeChoice* chosen = nullptr;
  for (const ShapeChoice& shape : shapes) {
    if (shape.weight <= 0) continue;
    chosen = &shape;
    if (dart < shape.weight) break;
    dart -= shape.weight;
  }
  return {chosen->name, chosen->make(key.at("shape"))};
}

/// symbol @weight -> operation.
Production production(const Rules& rules, const std::string& symbol, Operation operation,
                      double weight) {
  SuccessorItem part;
  part.symbol = sign_of(operation);
  part.terminal = true;
  part.content = [rules, operation](const RewriteSite& site) {
    ProductionStep step;
    step.operation = operation;
    std::string names;
    for (int i = 0; i < std::max(rules.pieces, 1); ++i) {
      step.pieces.push_back(draw(rules.shapes, site.key.at(static_cast<uint64_t>(i))));
      names += " " + step.pieces.back().name;
    }
    step.piece_label = rules.piece_label;
    step.label = rules.label;
    step.amount = rules.amount;
    step.blend = rules.blend;
    const std::string text = sign_of(operation) + names + " label " + to_string(rules.label);
    return Content{{}, std::move(step), text};
  };
  Production out;
  out.symbol = symbol;
  out.name = symbol + " -> " + to_string(operation);
  out.weight = [weight](const RewriteSite&) { return weight; };
  out.successor = {std::move(part)};
  return out;
}

SuccessorItem repeated(const std::string& symbol, int64_t count) {
  SuccessorItem part;
  part.symbol = symbol;
  part.count = [count](const RewriteSite&) { return count; };
  return part;
}

}  // namespace

grammar::Grammar grammar_of(const Rules& rules) {
  require_valid(rules);
  grammar::Grammar out;
  out.name = "cave";
  // j / (P_M + 1) of the classic productions precede the j-th morphic one.
  int64_t done = 0;
  for (int j = 1; j <= rules.morphic; ++j) {
    const int64_t upto = int64_t{rules.classic} * j / (rules.morphic + 1);
    out.axiom.push_back(repeated("Classic", upto - done));
    out.axiom.push_back(repeated("Morphic", 1));
    done = upto;
  }
  out.axiom.push_back(repeated("Classic", rules.classic - done));
  out.productions = {production(rules, "Classic", Operation::unite, rules.unite),
                     production(rules, "Classic", Operation::subtract, rules.subtract),
                     production(rules, "Classic", Operation::intersect, rules.intersect),
                     production(rules, "Morphic", Operation::morph, 1)};
  return out;
}

}  // namespace vug::sgm
