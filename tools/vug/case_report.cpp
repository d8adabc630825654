// SPDX-License-Identifier: Apache-2.0
// Reports of a run of image cases: JUnit for build servers, an HTML index for people.
#include "case_run.h"

#include <fmt/format.h>
#include <vug/base/xml.h>
#include <vug/image/page.h>

#include <algorithm>

namespace vug::cli {
namespace {

ptrdiff_t count(const std::vector<Outcome>& outcomes, std::initializer_list<Verdict> verdicts) {
  return std::count_if(outcomes.begin(), outcomes.end(), [&](const Outcome& outcome) {
    return std::find(verdicts.begin(), verdicts.end(), outcome.verdict) != verdicts.end();
  });
}

}  // namespace

std::string to_junit(const std::vector<Outcome>& outcomes, const std::string& suite) {
  double seconds = 0;
  for (const Outcome& outcome : outcomes) seconds += outcome.seconds;
  const std::string name = xml_text(suite);
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n<testsuite name=\"{}\" "
      "tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n",
      name, outcomes.size(), count(outcomes, {Verdict::different, Verdict::flaky}),
      count(outcomes, {Verdict::unusable}), seconds);
  for (const Outcome& outcome : outcomes) {
    out += fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", name,
                       xml_text(outcome.name), outcome.seconds);
    if (outcome.verdict == Verdict::same || outcome.verdict == Verdict::updated) {
      out += "/>\n";
      continue;
    }
    const char* element = outcome.verdict == Verdict::unusable ? "error" : "failure";
    out += fmt::format(">\n    <{} type=\"{}\" message=\"{}\">{}</{}>\n  </testcase>\n", element,
                       to_text(outcome.verdict), xml_text(outcome.message), xml_text(outcome.hint),
                       element);
  }
  return out + "</testsuite>\n</testsuites>\n";
}

std::string to_index(const std::vector<Outcome>& outcomes, const std::string& suite) {
  const auto good = count(outcomes, {Verdict::same, Verdict::updated});
  const bool all = good == static_cast<ptrdiff_t>(outcomes.size());
  std::string out = image::page_head(suite);
  out += fmt::format(
      "<header><span class=\"verdict {}\">{} of {}</span><h1>{}</h1></header>\n"
      "<p class=\"why\">{}</p>\n<table><tr><th>case</th><th>verdict</th><th>why</th></tr>\n",
      all ? "same" : "different", good, outcomes.size(), xml_text(suite),
      all ? "All pictures match their references."
          : "Some pictures do not match their references.");
  for (const Outcome& outcome : outcomes) {
    const std::string name = xml_text(outcome.name);
    out += fmt::format(
        "<tr class=\"first\"><td>{}</td><td><span class=\"verdict {}\">{}</span></td>"
        "<td>{}{}</td></tr>\n",
        outcome.page.empty()
            ? name
            : fmt::format("<a href=\"{}\">{}</a>", xml_text(outcome.page.generic_string()), name),
        to_text(outcome.verdict), to_text(outcome.verdict), xml_text(outcome.message),
        outcome.hint.empty() ? "" : "<br><small>" + xml_text(outcome.hint) + "</small>");
  }
  return out + "</table>\n" + image::page_foot();
}

}  // namespace vug::cli
