// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/rescale.h>

#include <set>
#include <string>

namespace vug::workbench {
namespace {

/// Names of the counts that occur in a state.
std::set<std::string> counts_of(const modeller::FacadeState& state) {
  std::set<std::string> out = {"line", "column", "row"};
  for (size_t i = 0; i < state.tree().nodes.size(); ++i)
    for (const facade::FreeNumber& number : state.planned(static_cast<int>(i)).free)
      if (number.whole) out.insert(number.name);
  return out;
}

}  // namespace

FacadeDocument rescaled(const FacadeDocument& document, double factor) {
  if (!(factor > 0)) throw Error(ErrorCode::bad_input, "the factor of a scale must be above 0");
  modeller::SessionHeader header = document.header();
  if (header.width) *header.width *= factor;
  if (header.height) *header.height *= factor;
  if (header.photo && header.photo->scale > 0) header.photo->scale *= factor;
  if (!header.width && !(header.photo && header.photo->scale > 0))
    header.width = factor * document.state().canvas().width;
  if (!header.height && !(header.photo && header.photo->scale > 0))
    header.height = factor * document.state().canvas().height;
  FacadeDocument before = document.with_edits({});
  std::vector<modeller::Edit> edits;
  for (modeller::Edit edit : document.edits()) {
    before = before.edited(edit);
    const std::set<std::string> counts = counts_of(before.state());
    for (auto& [name, values] : edit.numbers)
      if (!counts.count(name))
        for (double& value : values) value *= factor;
    edits.push_back(std::move(edit));
  }
  return document.with_header(std::move(header), edits);
}

}  // namespace vug::workbench
