// The schema of a kind: its name, doc, source and parameters. Everything that talks about kinds
// (binding a scene's arguments, diagnostics, `vug list`, manuals, sweep tests) reads it from here;
// base/kind.h makes a kind of it.
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

/// An argument as written: by name or by position (empty name), with its place.
struct Argument {
  std::string name;
  Value value;
  SourceLocation where;
};
using Arguments = std::vector<Argument>;

/// One parameter as data.
struct ParamInfo {
  std::string name;
  std::string type;  ///< "number", "vector", "text", "file", "name", "field", "list of field", ...
  Dimension dimension = Dimension::none;
  std::string doc;       ///< One sentence; states the unit where it is not the dimension's.
  std::string fallback;  ///< Default as scene text, with its unit; empty when required.
  bool required = false;
  double min = -kInfinity;  ///< Closed bounds for numbers and for each vector component.
  double max = kInfinity;
  bool above_min = false;            ///< True when min itself is excluded.
  std::vector<std::string> choices;  ///< For names: what may be given.
};

struct KindInfo {
  std::string name;
  std::string category;  ///< "primitive", "operator", "light", ...
  std::string doc;
  std::string cite;  ///< Key in docs/references.bib, or empty.
  std::vector<ParamInfo> params;
};

/// What a parameter may be told beyond its member: used with designated initialisers.
struct ParamSpec {
  std::string doc;
  Dimension dimension = Dimension::none;
  double min = -kInfinity;
  double max = kInfinity;
  bool above_min = false;
  bool required = false;
};

/// Bounds that occur again and again.
inline ParamSpec positive_length(std::string doc) {
  return {.doc = std::move(doc), .dimension = Dimension::length, .min = 0, .above_min = true};
}
inline ParamSpec any_length(std::string doc) {
  return {.doc = std::move(doc), .dimension = Dimension::length};
}

/// Describes the parameter struct P; filled by the kind's `describe`.
template <class P>
class Schema {
 public:
  Schema(std::string name, std::string category) {
    info_.name = std::move(name);
    info_.category = std::move(category);
  }

  Schema& doc(std::string text) { return info_.doc = std::move(text), *this; }
  Schema& cite(std::string key) { return info_.cite = std::move(key), *this; }

  /// A parameter held in `member` of P or of a base of P; its default is the member's initialiser.
  /// A std::filesystem::path is read relative to the folder of the text that names it.
  template <class T, class Base>
  requires std::derived_from<P, Base> Schema& param(std::string name, T Base::*member,
                                                    ParamSpec spec = {});

  /// An enumeration in `member`, given in text by one of the names.
  template <class E>
  Schema& choice(std::string name, E P::*member, std::vector<std::pair<std::string, E>> names,
                 std::string doc);

  const KindInfo& info() const { return info_; }

  /// The struct that `arguments` describe; nothing, with diagnostics, when an argument is unknown,
  /// repeated, missing, ill-typed or out of range, or when P has `std::string fault() const`
  /// (empty, or a sentence on parameters that do not fit together) and that finds one.
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
/// Index of the parameter each argument goes to; -1 (with a diagnostic) when there is none.
std::vector<int> match_arguments(const KindInfo& kind, const Arguments& arguments,
                                 const SourceLocation& where, Diagnostics& diagnostics);
/// `misfit`: index of the element that a list parameter cannot take, -1 when it is no list.
void report_type(const ParamInfo& info, const Argument& argument, int misfit,
                 Diagnostics& diagnostics);
/// Checks dimension and range of every number in the argument: one, the parts of a vector, the
/// elements of a list. False with a diagnostic when one does not fit.
bool check_range(const ParamInfo& info, const Argument& argument, Diagnostics& diagnostics);
/// A default as people write it, in the unit of its dimension.
std::string default_text(const Value& value, Dimension dimension);
/// The file that an argument names; see Schema::param. Nothing when it is no text.
std::optional<std::filesystem::path> read_file_name(const Argument& argument);
}  // namespace detail

}  // namespace vug

#include <vug/base/schema_inl.h>
