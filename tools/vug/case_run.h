// SPDX-License-Identifier: Apache-2.0
// Runs the cases of an image test and reports their outcomes, also of cases without a reference.
#pragma once

#include "image_case.h"

#include <vug/base/progress.h>

namespace vug::cli {

struct CaseOptions {
  std::filesystem::path output;  ///< The folder of each case is created below it.
  bool kept = false;             ///< Whether `output` is kept after the run.
  int jobs = 1;                  ///< Number of cases that run at the same time.
  int threads = 1;               ///< Number of threads per case.
  int reseed = 0;  ///< Number of additional runs with other samples, to find verdicts that change.
  bool update = false;  ///< Replaces a reference that differs by the case's picture.
  Progress* progress = &Progress::none();  ///< Cancels the run.
  std::string reason;  ///< Reason for an update, recorded in the reference's history.
};

enum class Verdict { same, different, flaky, updated, unusable };

struct Outcome {
  std::string name;
  Verdict verdict = Verdict::unusable;
  std::string message;  ///< Reason in one line.
  std::string hint;     ///< Remedy; may be empty.
  double seconds = 0;
  /// Path of the report, or of the picture if there is no reference, relative to the output folder;
  /// may be empty.
  std::filesystem::path page;
};

const char* to_text(Verdict verdict);

/// Runs one case: writes its picture as OUTPUT/NAME/test.exr, the program's output as log.txt and,
/// if the pictures differ, report.html and report.json. Faults of the case itself do not throw but
/// make it unusable. Error(cancelled) if the run is cancelled.
Outcome run_case(const CaseFolder& folder, const CaseOptions& options);

/// Runs all cases and returns their outcomes in the same order. `done` is called as each case ends,
/// by one thread at a time. Error(cancelled) if the run is cancelled.
std::vector<Outcome> run_cases(const std::vector<CaseFolder>& folders, const CaseOptions& options,
                               const std::function<void(const Outcome&)>& done);

/// A JUnit XML report for build servers. Equal runs differ in the times only.
std::string to_junit(const std::vector<Outcome>& outcomes, const std::string& suite);
/// An HTML page that lists the cases and links to their reports.
std::string to_index(const std::vector<Outcome>& outcomes, const std::string& suite);

}  // namespace vug::cli
