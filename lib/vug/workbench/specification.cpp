// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/workbench/handles.h>
#include <vug/workbench/specification.h>

#include <fmt/format.h>

namespace vug::workbench {

using modeller::FacadeState;

Specification specification(const FacadeState& state, int selected) {
  Specification out;
  out.node = numbers_node(state, selected);
  if (out.node == FacadeState::kWhole) return out;
  const facade::Node& node = state.node(out.node);
  out.title = fmt::format("{}, {:.4g} x {:.4g} m", node.symbol, node.rect.width, node.rect.height);
  for (const facade::FreeNumber& number : state.planned(out.node).free)
    for (size_t i = 0; i < number.values.size(); ++i)
      out.fields.push_back(
          {number.name, i,
           number.values.size() > 1 ? fmt::format("{} {}", number.name, i + 1) : number.name,
           number.whole, number.least, number.most, number.values[i], number.fixed});
  return out;
}

modeller::Edit field_edit(const FacadeState& state, const Specification& form, const Field& field,
                          double value) {
  modeller::Edit out{"set", state.path(form.node), "", {}};
  std::vector<double>& values = out.numbers[field.number];
  for (const Field& each : form.fields)
    if (each.number == field.number) values.push_back(each.value);
  const double change = value - values[field.index];
  values[field.index] = value;
  // Shares of an extent: the next part, or the one before the last, makes room. The last share is
  // the rest, which the derivation computes.
  const bool shares = field.number.ends_with("widths") || field.number.ends_with("heights");
  if (shares && values.size() > 1) {
    values[field.index + 1 < values.size() ? field.index + 1 : field.index - 1] -= change;
    values.pop_back();
  }
  return out;
}

std::vector<RuleField> rule_fields(const FacadeState& state, int selected) {
  std::vector<RuleField> out;
  if (selected == FacadeState::kWhole) return out;
  const auto add = [&](int node) {
    RuleField made{node, state.node(node).symbol, {}, -1};
    for (const int rule : state.style().rules_of(made.symbol)) {
      if (rule == state.rule(node)) made.current = static_cast<int>(made.rules.size());
      made.rules.push_back(state.style().rule_name(rule));
    }
    if (!made.rules.empty()) out.push_back(std::move(made));
  };
  const int start = state.node(selected).element && state.node(selected).parent >= 0
                        ? state.node(selected).parent
                        : selected;
  add(start);
  const int numbers = numbers_node(state, start);
  for (int above = numbers; above > start; above = state.node(above).parent)
    if (state.node(above).parent == start) return add(numbers), out;
  return out;
}

modeller::Edit rule_edit(const FacadeState& state, const RuleField& field, size_t rule) {
  return {field.current < 0 ? "apply" : "change", state.path(field.node), field.rules.at(rule), {}};
}

const Field& find_field(const Specification& form, const std::string& label) {
  std::vector<std::string> names;
  for (const Field& each : form.fields) {
    if (each.label == label) return each;
    names.push_back(each.label);
  }
  throw Error(ErrorCode::bad_input, fmt::format("the form has no field '{}'", label), {},
              did_you_mean(label, names, "select a node with free numbers"));
}

}  // namespace vug::workbench
