// Edits as data: what a session stores, a window sends and a command line says.
#pragma once

#include <vug/modeller/facade_state.h>

#include <string>
#include <vector>

namespace vug::modeller {

/// What is done to one node.
struct Edit {
  std::string kind;  ///< "apply"; see edit_kinds.
  std::string node;  ///< A path, as of the state that is edited.
  std::string rule;  ///< By name, as Style::find_rule takes it; empty where none is needed.
  facade::NumberValues
      numbers;  ///< Metres from the lower left corner of the node, counts, columns.
  bool operator==(const Edit&) const = default;
};

/// An edit that cannot be done.
class RejectedEdit : public Error {
 public:
  /// `key` is what of the edit is wrong: "node", "rule", "numbers/rows", or empty: all of it.
  RejectedEdit(std::string key, const Error& error)
      : Error(error.code(), error.what(), error.where(), error.hint()), key_(std::move(key)) {}
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

struct EditKind {
  std::string name;
  std::string doc;
  /// What it takes beside the node.
  bool rule = false;
  bool free_numbers = false;         ///< Those of the node's split.
  std::vector<std::string> numbers;  ///< Its own; each is needed and is one number.
  /// InfeasiblePlan and Error(bad_input) where it cannot be done.
  FacadeState (*run)(const FacadeState& state, int node, const Edit& edit);
};
/// Made from the list in CMakeLists.txt.
const std::vector<const EditKind*>& edit_kinds();
/// Refused, with the nearest, for a name that is none.
const EditKind& edit_kind(const std::string& name);

/// The state after the edit. Refused where it cannot be done; `state` is what it was in any case.
FacadeState perform_edit(const FacadeState& state, const Edit& edit);

/// "apply 0.1 RegularGrid columns=4 dx=2.1,2.4": the kind where `kind` is empty, the node, the rule
/// where the kind takes one, numbers. Lengths are metres or have a unit: 90cm, and 120px where a
/// pixel has a size. Error(bad_input) for what is none.
Edit parse_edit(const std::string& text, const std::string& kind = "", double metres_per_pixel = 0);
/// The same back.
std::string to_string(const Edit& edit);

}  // namespace vug::modeller

/// Opens the one definition that the file of an edit exports; see VUG_EXPORT_KIND.
#define VUG_EDIT_KIND(name) VUG_EXPORT_KIND(vug::modeller, EditKind, name##_edit)
