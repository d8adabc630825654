// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "case_run.h"
#include "progress_bar.h"
#include "verb.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/pluralize.h>
#include <vug/base/scratch_folder.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace vug::cli {
namespace {

struct TestOptions {
  std::string folder;
  std::string filter;
  std::string output, junit;
  CaseOptions cases;
  int jobs = 0;
  bool quiet = false;
};

void require_fitting(const TestOptions& options) {
  const bool reasoned = options.cases.reason.find_first_not_of(" \t\n") != std::string::npos;
  if (options.cases.update && !reasoned)
    throw Error(ErrorCode::bad_input, "an update of a reference requires a reason", {},
                "write --update --reason \"why the new pictures are correct\"");
  if (!options.cases.update && !options.cases.reason.empty())
    throw Error(ErrorCode::bad_input, "--reason requires --update", {}, "write --update as well");
  if (options.cases.update && options.cases.reseed > 0)
    throw Error(ErrorCode::bad_input, "--update and --flaky exclude each other");
  if (options.cases.reason.find('\n') != std::string::npos)
    throw Error(ErrorCode::bad_input, "the reason must be a single line");
}

/// Maximum length of a message on the line of its case.
constexpr size_t kShort = 60;

/// "different  hall", followed by the message if it is short.
std::string line_of(const Outcome& outcome) {
  const std::string line = fmt::format("{:<10} {}", to_text(outcome.verdict), outcome.name);
  return line + (outcome.message.size() <= kShort ? "  " + outcome.message : "") + "\n";
}

/// The rest of the message, with one reason per line, and the hint. Empty if nothing is left.
std::string details_of(const Outcome& outcome) {
  std::string out;
  std::string_view rest = outcome.message;
  if (rest.size() <= kShort) rest = {};
  while (!rest.empty()) {
    const size_t end = std::min(rest.find("; "), rest.size());
    out += fmt::format("  {}\n", rest.substr(0, end));
    rest.remove_prefix(std::min(end + 2, rest.size()));
  }
  if (!outcome.hint.empty()) out += fmt::format("  hint: {}\n", outcome.hint);
  return out.empty() ? out : fmt::format("\n{}:\n{}", outcome.name, out);
}

/// "5 cases in 12.3 s: 4 same, 1 different".
std::string summary_of(const std::vector<Outcome>& outcomes, double seconds) {
  std::string out = fmt::format("{} in {:.1f} s", pluralize(outcomes.size(), "case"), seconds);
  const char* apart = ": ";
  for (const Verdict verdict :
       {Verdict::same, Verdict::different, Verdict::flaky, Verdict::updated, Verdict::unusable}) {
    const auto count = std::count_if(outcomes.begin(), outcomes.end(),
                                     [&](const Outcome& o) { return o.verdict == verdict; });
    if (count == 0) continue;
    out += fmt::format("{}{} {}", apart, count, to_text(verdict));
    apart = ", ";
  }
  return out;
}

int exit_of(const std::vector<Outcome>& outcomes) {
  int exit = kDone;
  for (const Outcome& outcome : outcomes)
    if (outcome.verdict == Verdict::unusable)
      return kUnusable;
    else if (outcome.verdict == Verdict::different || outcome.verdict == Verdict::flaky)
      exit = kAnswerNo;
  return exit;
}

int run_test(TestOptions options) {
  if (const char* reason = std::getenv("VUG_REASON"); reason && options.cases.update)
    if (options.cases.reason.empty()) options.cases.reason = reason;
  require_fitting(options);
  const std::vector<CaseFolder> folders = find_cases(options.folder, options.filter);
  if (folders.empty())
    throw Error(ErrorCode::bad_input,
                options.filter.empty()
                    ? fmt::format("'{}' contains no case", options.folder)
                    : fmt::format("no case in '{}' has a name that contains '{}'", options.folder,
                                  options.filter),
                {}, "a case is a folder with a case.json; see docs/guides/image_tests.md");
  const int cores = thread_count();
  options.cases.jobs = options.jobs > 0 ? options.jobs : cores;
  options.cases.threads =
      std::max(1, cores / std::min(options.cases.jobs, static_cast<int>(folders.size())));
  std::optional<ScratchFolder> scratch;
  if (options.output.empty()) scratch.emplace("vug_test");
  options.cases.output = scratch ? scratch->path() : std::filesystem::path(options.output);
  options.cases.kept = !scratch;
  if (!scratch) require_writable(options.cases.output / "index.html");
  if (!options.junit.empty()) require_writable(options.junit);
  options.cases.progress = &terminal_progress(ProgressBarMode::never);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  size_t ended = 0;
  const auto outcomes = run_cases(folders, options.cases, [&](const Outcome& outcome) {
    if (!options.quiet)
      fmt::print(stderr, "[{}/{}] {}: {} ({:.1f} s)\n", ++ended, folders.size(), outcome.name,
                 to_text(outcome.verdict), outcome.seconds);
  });
  for (const Outcome& outcome : outcomes)
    if (!options.quiet || outcome.verdict != Verdict::same) fmt::print("{}", line_of(outcome));
  for (const Outcome& outcome : outcomes)
    if (!options.quiet || outcome.verdict != Verdict::same) fmt::print("{}", details_of(outcome));
  const std::string suite =
      std::filesystem::absolute(options.folder).lexically_normal().filename().string();
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (!options.quiet) fmt::print("\n{}\n", summary_of(outcomes, seconds));
  if (!options.junit.empty()) write_text(options.junit, to_junit(outcomes, suite));
  if (!scratch) {
    write_text(options.cases.output / "index.html", to_index(outcomes, suite));
    fmt::print("{}\n", (options.cases.output / "index.html").string());
  }
  const int exit = exit_of(outcomes);
  if (exit == kUnusable) fmt::print(stderr, "error: some cases are unusable\n");
  return exit;
}

}  // namespace

Verb test_verb() {
  return {
      "test", "Renders the cases of a folder and compares them with their references.",
      [](CLI::App& app) {
        auto o = std::make_shared<TestOptions>();
        app.add_option("folder", o->folder, "Case, or folder of cases")->required();
        app.add_option("--filter", o->filter, "Run only cases whose name contains this text");
        app.add_option("-o,--output", o->output,
                       "Folder for pictures, reports and index.html; without it they are not kept");
        app.add_option("--junit", o->junit, "Write a JUnit XML report to this file");
        app.add_option("-j,--jobs", o->jobs,
                       "Number of cases that run at the same time; 0 uses all cores")
            ->check(integer_in(0, 1024));
        app.add_option("--flaky", o->cases.reseed,
                       "Repeat each case with N other seeds and report verdicts that change")
            ->check(integer_in(1, 1000));
        app.add_flag("--update", o->cases.update,
                     "Replace references that differ or are missing; requires --reason");
        app.add_option("--reason", o->cases.reason,
                       "Reason of the update, for the reference's history; default $VUG_REASON");
        app.add_flag("--quiet,-q", o->quiet, "List only cases that are not the same");
        return [o] { return run_test(*o); };
      }};
}

}  // namespace vug::cli
