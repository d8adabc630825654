// SPDX-License-Identifier: Apache-2.0
// Errors and warnings found while reading a user's text, collected so that one run reports them
// all.
#pragma once

#include <vug/base/error.h>

#include <string>
#include <vector>

namespace vug {

enum class Severity { warning, error };

struct Diagnostic {
  Severity severity = Severity::error;
  SourceLocation where;
  std::string message;
  std::string hint;  ///< E.g. "did you mean 'radius'?"; may be empty.
};

/// A list to which checks append; they continue after an error.
class Diagnostics {
 public:
  void error(SourceLocation where, std::string message, std::string hint = {});
  void warning(SourceLocation where, std::string message, std::string hint = {});

  void add(Diagnostic diagnostic);
  /// Adds an error at its own location in the text, or at `otherwise` if that is unknown.
  void add(const Error& error, const SourceLocation& otherwise);
  /// Appends another list, in order.
  void append(const Diagnostics& other);

  bool has_errors() const { return errors_ > 0; }
  const std::vector<Diagnostic>& all() const { return all_; }

 private:
  std::vector<Diagnostic> all_;
  int errors_ = 0;
};

/// The candidate that differs from `name` in upper and lower case only, else the nearest by edit
/// distance (Damerau-Levenshtein), or an empty string if the distance of each exceeds a third of
/// the name's length (at least 1).
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

/// "did you mean 'x'?" for the nearest candidate, or another hint if none is near.
std::string did_you_mean(const std::string& name, const std::vector<std::string>& candidates,
                         const std::string& otherwise = {});

/// "did you mean 'x'?" for the nearest candidate, else "known: a, b, c". Empty without candidates.
std::string suggestion(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace vug
