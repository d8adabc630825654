// SPDX-License-Identifier: Apache-2.0
#include "case_run.h"

#include "process.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/image/report.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

namespace vug::cli {
namespace {

namespace fs = std::filesystem;

/// The last message in another program's log, as one line.
std::string last_message(const fs::path& log) {
  std::string said, line;
  for (const char c : read_text(log) + "\n") {
    if (c != '\n') {
      line += c;
      continue;
    }
    if (line.rfind("hint: ", 0) != 0 && !line.empty()) said = line;
    if (line.find("error: ") != std::string::npos) break;  // the lines that follow explain it
    line.clear();
  }
  return said;
}

/// Creates the case's picture and returns its path. Throws on failure.
fs::path make_picture(const ImageCase& image_case, const CaseOptions& options, const fs::path& room,
                      std::optional<uint64_t> seed) {
  const std::string stem = seed ? fmt::format("seed{}", *seed) : "test";
  const fs::path picture = room / (stem + image_case.reference.extension().string());
  const fs::path log = room / (seed ? stem + ".txt" : "log.txt");
  fs::remove(picture);
  const ProcessResult ended =
      run_program(image_case.render_command(picture, options.threads, seed), image_case.folder, log,
                  image_case.timeout, *options.progress);
  if (ended.timed_out)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("the command of the case did not finish within {} seconds", image_case.timeout),
        {}, "raise \"timeout\" in its case.json or reduce its work");
  if (ended.exit != 0)
    throw Error(ErrorCode::bad_input,
                fmt::format("rendering its picture failed with exit code {}: {}", ended.exit,
                            last_message(log)),
                {},
                fmt::format("its full output is in {}/log.txt in the folder given by --output",
                            image_case.name));
  if (!fs::exists(picture))
    throw Error(ErrorCode::bad_input, "the command of the case did not write a picture", {},
                "write {output} where the program expects the name of its output file");
  return picture;
}

image::Diff judge(const ImageCase& image_case, const fs::path& picture) {
  image::DiffOptions options = image_case.diff;
  const image::ImageUnderTest reference = image::read_image_under_test(image_case.reference);
  if (!image_case.mask.empty())
    options.mask = image::read_mask(image_case.mask, reference.image.width, reference.image.height);
  return image::diff(reference, image::read_image_under_test(picture), options);
}

void write_report(const ImageCase& image_case, const image::Diff& diff, const fs::path& picture,
                  const fs::path& room) {
  const std::string reference = image_case.reference.filename().string();
  const std::string test = picture.filename().string();
  write_text(room / "report.html", to_html(diff, image_case.name, reference, test));
  write_text(room / "report.json", to_json(diff, reference, test));
}

/// Repeats the case with other seeds; a verdict that differs from `first` makes it flaky.
void reseed(const ImageCase& image_case, const CaseOptions& options, const fs::path& room,
            bool first, Outcome& out) {
  if (!image_case.can_be_reseeded()) {
    out.message += "; its command has no {seed}, so it was not repeated with other seeds";
    return;
  }
  int same = first ? 1 : 0;
  for (int i = 1; i <= options.reseed; ++i)
    if (judge(image_case, make_picture(image_case, options, room, static_cast<uint64_t>(i))).same)
      ++same;
  const int all = options.reseed + 1;
  out.message += fmt::format("; {} of {} seeds pass", same, all);
  if (same == 0 || same == all) return;
  out.verdict = Verdict::flaky;
  out.hint = "render more samples or loosen its limits";
}

void update(const ImageCase& image_case, const CaseOptions& options, const fs::path& picture,
            Outcome& out) {
  const bool had = fs::exists(image_case.reference);
  replace_reference(image_case, picture, options.reason);
  out.verdict = Verdict::updated;
  out.message = had ? "the reference was replaced" : "the reference was created";
  out.hint.clear();
}

/// Throws the error for a missing reference. If the output is kept, first renders the picture that
/// could become the reference.
[[noreturn]] void throw_missing_reference(const ImageCase& image_case, const CaseOptions& options,
                                          const fs::path& room, const std::string& name,
                                          Outcome& out) {
  if (!image_case.scene.empty())
    if (const std::string why = unreadable_reason(image_case.scene); !why.empty())
      throw Error(ErrorCode::bad_input,
                  fmt::format("its scene '{}' cannot be read: {}",
                              image_case.scene.lexically_relative(image_case.folder).string(), why),
                  {}, "\"scene\" is a path relative to the case's folder");
  std::string look = "look at its picture (--output keeps it)";
  if (options.kept) {
    fs::path picture = make_picture(image_case, options, room, {});
    if (const fs::path shown = fs::path(picture).replace_extension(".png"); fs::exists(shown))
      picture = shown;
    look = fmt::format("look at {}", picture.string());
    out.page = fs::path(name) / picture.filename();
  }
  throw Error(
      ErrorCode::bad_input,
      fmt::format("its reference '{}' is missing", image_case.reference.filename().string()), {},
      look + ", then: vug test FOLDER --update --reason \"...\"");
}

void run_case_in(const fs::path& room, const CaseFolder& folder, const CaseOptions& options,
                 Outcome& out) {
  const ImageCase image_case = read_case(folder.folder, folder.name);
  const bool missing = !fs::exists(image_case.reference);
  if (missing && !options.update)
    throw_missing_reference(image_case, options, room, folder.name, out);
  if (!missing && !options.update) require_recorded(image_case.reference);
  const fs::path picture = make_picture(image_case, options, room, {});
  if (missing) return update(image_case, options, picture, out);
  image::Diff diff;
  try {
    diff = judge(image_case, picture);
  } catch (const Error& error) {  // the pictures differ in size or in their layers
    if (!options.update || error.code() == ErrorCode::cancelled) throw;
    return update(image_case, options, picture, out);
  }
  out.verdict = diff.same ? Verdict::same : Verdict::different;
  out.message = verdict_text(diff);
  for (const std::string& reason : diff.reasons) out.message += "; " + reason;
  if (!diff.same && options.update) return update(image_case, options, picture, out);
  if (options.reseed > 0) reseed(image_case, options, room, diff.same, out);
  if (out.verdict == Verdict::same) return;
  write_report(image_case, diff, picture, room);
  out.page = fs::path(folder.name) / "report.html";
}

}  // namespace

const char* to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::same:
      return "same";
    case Verdict::different:
      return "different";
    case Verdict::flaky:
      return "flaky";
    case Verdict::updated:
      return "updated";
    case Verdict::unusable:
      break;
  }
  return "unusable";
}

Outcome run_case(const CaseFolder& folder, const CaseOptions& options) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  Outcome out;
  out.name = folder.name;
  try {
    const fs::path room = fs::absolute(options.output) / folder.name;
    fs::create_directories(room);
    for (const char* old : {"report.html", "report.json"}) fs::remove(room / old);
    run_case_in(room, folder, options, out);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::cancelled) throw;
    out.verdict = Verdict::unusable;
    const std::string where = to_string(error.where());
    out.message = (where.empty() ? "" : where + ": ") + error.what();
    out.hint = error.hint();
  } catch (const std::exception& error) {  // file system errors, out of memory
    out.verdict = Verdict::unusable;
    out.message = error.what();
  }
  out.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return out;
}

std::vector<Outcome> run_cases(const std::vector<CaseFolder>& folders, const CaseOptions& options,
                               const std::function<void(const Outcome&)>& done) {
  std::vector<Outcome> out(folders.size());
  std::atomic<size_t> next{0};
  std::mutex done_mutex;
  const auto work = [&] {
    for (size_t i = next++; i < folders.size(); i = next++) try {
        out[i] = run_case(folders[i], options);
        const std::lock_guard lock(done_mutex);
        done(out[i]);
      } catch (const Error&) {  // cancelled, as are all other workers
        return;
      }
  };
  std::vector<std::thread> workers;
  const size_t count = std::min(static_cast<size_t>(std::max(options.jobs, 1)), folders.size());
  for (size_t i = 1; i < count; ++i) workers.emplace_back(work);
  work();
  for (std::thread& worker : workers) worker.join();
  options.progress->check();
  return out;
}

}  // namespace vug::cli
