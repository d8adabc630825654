// Runs cases of image tests and says how they went.
#pragma once

#include "image_case.h"

#include <vug/base/progress.h>

namespace vug::cli {

struct CaseOptions {
  std::filesystem::path output;  ///< Each case's folder is made below it.
  bool kept = false;             ///< `output` is there for someone to look at afterwards.
  int jobs = 1;                  ///< Cases at the same time.
  int threads = 1;               ///< For each of them.
  int reseed = 0;                ///< Runs with other samples, to find verdicts that change.
  bool update = false;           ///< Takes what a case makes for its reference where they differ.
  Progress* progress = &Progress::none();  ///< Where the run is told to stop.
  std::string reason;                      ///< Why; goes into the reference's history.
};

enum class Verdict { same, different, flaky, updated, unusable };

struct Outcome {
  std::string name;
  Verdict verdict = Verdict::unusable;
  std::string message;  ///< One line: why.
  std::string hint;     ///< What to do about it; may be empty.
  double seconds = 0;
  /// Its report, or its picture if it has no reference, seen from the output folder; may be empty.
  std::filesystem::path page;
};

const char* to_text(Verdict verdict);

/// Runs one case: makes its picture as OUTPUT/NAME/test.exr, what was said as log.txt, and, where
/// it is not the same, page and JSON as report.html and report.json. Never throws for the case's
/// own faults: they make it unusable; Error(cancelled) when told to stop.
Outcome run_case(const CaseFolder& folder, const CaseOptions& options);

/// All of them, in their order; `done` hears of each as it ends, one at a time.
/// Error(cancelled) when told to stop.
std::vector<Outcome> run_cases(const std::vector<CaseFolder>& folders, const CaseOptions& options,
                               const std::function<void(const Outcome&)>& done);

/// For a build server. Times are the only thing that two equal runs tell differently.
std::string to_junit(const std::vector<Outcome>& outcomes, const std::string& suite);
/// A page that lists the cases and links to their reports.
std::string to_index(const std::vector<Outcome>& outcomes, const std::string& suite);

}  // namespace vug::cli
