// SPDX-License-Identifier: Apache-2.0
// The schema of a kind: name, documentation, source and parameters; reports arguments that are
// unknown, of the wrong type or out of range. Everything that refers to kinds (binding of a scene's
// arguments, diagnostics, `vug list`, manuals, sweep tests) reads it; base/kind.h makes a kind from
// it.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/value_traits.h>

#include <cmath>
#include <concepts>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vug {

/// An argument as written, by name or by position (empty name), with its location.
struct Argument {
  std::string name;
  Value value;
  SourceLocation where;
  std::vector<SourceLocation> elements = {};  ///< Places of the elements of a list in the text.
};
using Arguments = std::vector<Argument>;

/// The description of one parameter.
struct ParamInfo {
  std::string name;
  std::string type;  ///< "number", "vector", "text", "file", "name", "field", "list of field", ...
  Dimension dimension = Dimension::none;
  std::string doc;       ///< One sentence; states the unit unless the dimension implies it.
  std::string fallback;  ///< Default as scene text, with its unit; empty if required.
  bool required = false;
  double min = -kInfinity;  ///< Closed bounds for numbers and for each vector component.
  double max = kInfinity;
  bool above_min = false;            ///< True if min itself is excluded.
  std::vector<std::string> choices;  ///< The valid names, for parameters of type "name".
};

struct KindInfo {
  std::string name;
  std::string category;  ///< "primitive", "operator", "light", ...
  std::string doc;
  std::string cite;  ///< Key in docs/references.bib, or empty.
  std::vector<ParamInfo> params;
};

/// The properties of a parameter beyond its member; used with designated initialisers.
struct ParamSpec {
  std::string doc;
  Dimension dimension = Dimension::none;
  double min = -kInfinity;
  double max = kInfinity;
  bool above_min = false;
  bool required = false;
};

/// Common parameter specifications.
inline ParamSpec positive_length(std::string doc) {
  return {.doc = std::move(doc), .dimension = Dimension::length, .min = 0, .above_min = true};
}
inline ParamSpec any_length(std::string doc) {
  return {.doc = std::move(doc), .dimension = Dimension::length};
}

/// The description of the parameter struct P; filled by the kind's `describe`.
template <class P>
class Schema {
 public:
  Schema(std::string name, std::string category) {
    info_.name = std::move(name);
    info_.category = std::move(category);
  }

  Schema& doc(std::string text) { return info_.doc = std::move(text), *this; }
  Schema& cite(std::string key) { return info_.cite = std::move(key), *this; }

  /// Adds a parameter stored in `member` of P or of a base of P; its default is the member's
  /// initialiser. A std::filesystem::path is relative to the folder of the text that names it.
  template <class T, class Base>
  requires std::derived_from<P, Base> Schema& param(std::string name, T Base::*member,
                                                    ParamSpec spec = {});

  /// Adds a parameter that is a number or one of the names, for a T whose traits read both.
  template <class T, class Base>
  requires std::derived_from<P, Base> Schema& number_or_name(std::string name, T Base::*member,
                                                             std::vector<std::string> names,
                                                             ParamSpec spec) {
    param(std::move(name), member, std::move(spec));
    info_.params.back().choices = std::move(names);
    return *this;
  }

  /// Adds an enumeration stored in `member`, written in the text as one of the names.
  template <class E>
  Schema& choice(std::string name, E P::*member, std::vector<std::pair<std::string, E>> names,
                 std::string doc);

  const KindInfo& info() const { return info_; }

  /// Converts arguments into the struct. Returns nothing, with diagnostics, if an argument is
  /// unknown, repeated, missing, ill-typed or out of range, or if P has `std::string fault() const`
  /// and it returns a sentence about parameters that contradict each other (empty: no fault).
  std::optional<P> bind(const Arguments& arguments, const SourceLocation& where,
                        Diagnostics& diagnostics) const;

 private:
  using Setter = std::function<void(P&, const Argument&, const ParamInfo&, Diagnostics&)>;
  void add(ParamInfo info, Setter setter) {
    info_.params.push_back(std::move(info));
    setters_.push_back(std::move(setter));
  }
  KindInfo info_;
  std::vector<Setter> setters_;
};

namespace detail {
/// The index of the parameter for each argument; -1 (with a diagnostic) if there is none.
std::vector<int> match_arguments(const KindInfo& kind, const Arguments& arguments,
                                 const SourceLocation& where, Diagnostics& diagnostics);
/// Reports an argument of the wrong type. `misfit` is the index of the list element with the wrong
/// type, or -1 if the argument is not a list.
void report_type(const ParamInfo& info, const Argument& argument, int misfit,
                 Diagnostics& diagnostics);
/// Checks the dimension and range of every number in the argument: a number, the components of a
/// vector, the elements of a list. Returns false, with a diagnostic, if one is invalid.
bool check_range(const ParamInfo& info, const Argument& argument, Diagnostics& diagnostics);
/// A default value as scene text, in the unit of its dimension.
std::string default_text(const Value& value, Dimension dimension);
/// The file that an argument names (see Schema::param); nothing if the argument is not a text.
std::optional<std::filesystem::path> read_file_name(const Argument& argument);
}  // namespace detail

}  // namespace vug

#include <vug/base/schema_inl.h>
