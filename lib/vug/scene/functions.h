// The functions that every scene knows: plain arithmetic, no objects.
#pragma once

#include <vug/base/schema.h>
#include <vug/scene/arithmetic.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::scene {

/// A built-in function; `takes` says in words what it takes, for messages and lists.
struct Function {
  const char* name;
  const char* takes;
  const char* doc;
  /// Nothing when the arguments are of other types (then the resolver is asked, so that kinds
  /// may bear the same name: round(2.4) here, round(10cm) there).
  std::optional<Value> (*apply)(const Arguments& arguments, const FaultSite& site);
};

const std::vector<Function>& functions();
const Function* find_function(const std::string& name);

}  // namespace vug::scene
