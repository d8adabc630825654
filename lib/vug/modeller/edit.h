// SPDX-License-Identifier: Apache-2.0
// Edits as data: the form in which sessions store them, a GUI sends them and command lines spell
// them.
#pragma once

#include <vug/modeller/facade_state.h>

#include <string>
#include <vector>

namespace vug::modeller {

/// One operation on one node.
struct Edit {
  std::string kind;  ///< Name of an edit kind such as "apply"; see edit_kinds.
  std::string node;  ///< Path of the node in the state before the edit.
  std::string rule;  ///< Rule name as accepted by Style::find_rule; empty if the kind takes none.
  facade::NumberValues numbers;  ///< Metres from the node's lower left corner, counts, or indices.
  bool operator==(const Edit&) const = default;
};

/// Error(bad_input) for an invalid edit.
Error edit_error(const std::string& message, const std::string& hint = "");

/// An edit that cannot be performed.
class RejectedEdit : public Error {
 public:
  /// `key` names the invalid part of the edit: "node", "rule", "numbers/rows", or empty for the
  /// whole edit.
  RejectedEdit(std::string key, const Error& error)
      : Error(error.code(), error.what(), error.where(), error.hint()), key_(std::move(key)) {}
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

struct EditKind {
  std::string name;
  std::string doc;
  /// Arguments in addition to the node.
  bool rule = false;
  bool free_numbers = false;         ///< Whether it takes the free numbers of the node's split.
  std::vector<std::string> numbers;  ///< Its own numbers; each is required and a single number.
  /// Throws InfeasiblePlan or Error(bad_input) if the edit cannot be performed.
  FacadeState (*run)(const FacadeState& state, int node, const Edit& edit);
};
/// Generated from the list in CMakeLists.txt.
const std::vector<const EditKind*>& edit_kinds();
/// Throws RejectedEdit with the nearest name for an unknown kind.
const EditKind& edit_kind(const std::string& name);

/// The state after the edit; `state` is never modified. Throws RejectedEdit if the edit cannot be
/// performed.
FacadeState perform_edit(const FacadeState& state, const Edit& edit);

/// Parses "apply 0.1 RegularGrid columns=4 dx=2.1,2.4": the kind if `kind` is empty, the node, the
/// rule if the kind takes one, and numbers. Lengths are in metres or have a unit: 90cm, or 120px if
/// the pixel size is known. Error(bad_input) for anything else.
Edit parse_edit(const std::string& text, const std::string& kind = "", double metres_per_pixel = 0);
/// The inverse of parse_edit.
std::string to_string(const Edit& edit);

}  // namespace vug::modeller

/// Opens the one definition that the file of an edit exports; see VUG_EXPORT_KIND.
#define VUG_EDIT_KIND(name) VUG_EXPORT_KIND(vug::modeller, EditKind, name##_edit)
