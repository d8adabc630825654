// SPDX-License-Identifier: Apache-2.0
// The form of a node's free numbers: one field for each value, with its unit and range.
#pragma once

#include <vug/modeller/edit.h>

#include <string>
#include <vector>

namespace vug::workbench {

struct Field {
  std::string number;  ///< Name of the free number: "dx".
  size_t index = 0;    ///< Among its values.
  std::string label;   ///< "dx 2" if there are several values, else "dx".
  bool whole = false;  ///< A count; else a length in metres.
  double least = 0, most = 0;
  double value = 0;
  bool fixed = false;  ///< Set by the user; else a default.
};

struct Specification {
  int node = modeller::FacadeState::kWhole;  ///< The node that has the numbers.
  std::string title;                         ///< "Grid: 4.9 x 16.1 m".
  std::vector<Field> fields;
};

/// The choice of a node's rule, for actions that leave one: a mirror with or without a middle, a
/// grid with or without a door, the content of an element.
struct RuleField {
  int node = 0;
  std::string symbol;
  std::vector<std::string> rules;  ///< As Style::rule_name.
  int current = -1;                ///< Index in `rules`; below 0 if no rule divides the node yet.
};

/// The rules of the selected node, or of the parent of a selected element, and those of the node
/// below it that has the numbers.
std::vector<RuleField> rule_fields(const modeller::FacadeState& state, int selected);

/// The edit that applies a rule to the node, or changes the one that it has.
modeller::Edit rule_edit(const modeller::FacadeState& state, const RuleField& field, size_t rule);

/// The form for a selected node; see numbers_node.
Specification specification(const modeller::FacadeState& state, int selected);

/// The edit that gives a field a value. Other values of the same number stay the same.
modeller::Edit field_edit(const modeller::FacadeState& state, const Specification& form,
                          const Field& field, double value);

/// The field with that label. Error(bad_input) with the nearest label if it does not exist.
const Field& find_field(const Specification& form, const std::string& label);

}  // namespace vug::workbench
