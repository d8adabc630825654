// SPDX-License-Identifier: Apache-2.0
// Comparison of two pictures.
#include "image.h"

#include <fmt/format.h>
#include <vug/image/diff.h>
#include <vug/image/report.h>
#include <vug/image/views.h>

#include <map>
#include <variant>

namespace vug::python {
namespace {

struct DiffResult {
  image::Diff diff;
  std::string reference, test;
};

/// A picture in memory or in a file.
using Picture = std::variant<Image, std::filesystem::path>;

image::ImageUnderTest image_under_test(const Picture& given, const std::string& name) {
  if (const auto* file = std::get_if<std::filesystem::path>(&given))
    return image::read_image_under_test(*file);
  const Image& rendered = std::get<Image>(given);
  const picture::PictureOutput& output = rendered.part().output;
  image::ImageUnderTest out;
  out.name = name;
  out.image = rendered.in_stereo()
                  ? image::stereo_image(rendered.image(), *rendered.rendered->at(1).image)
                  : rendered.image();
  out.metadata = output.metadata;
  out.left = rendered.part().header.crop.x0;
  out.top = rendered.part().header.crop.y0;
  out.space = output.settings.working_space;
  return out;
}

DiffResult compare(const Picture& reference, const Picture& test,
                   const std::map<std::string, double>& limits,
                   const std::vector<std::string>& layers, const std::vector<std::string>& measures,
                   const std::optional<double>& alarm) {
  const image::ImageUnderTest right = image_under_test(reference, "reference"),
                              judged = image_under_test(test, "test");
  image::DiffOptions options;
  options.layers = layers;
  options.measures = measures;
  options.false_alarm_rate = alarm;
  for (const auto& [name, value] : limits) options.limits.push_back(image::limit_of(name, value));
  const py::gil_scoped_release others;
  return {image::diff(right, judged, options), right.name, judged.name};
}

}  // namespace

void bind_diff(py::module_& module) {
  py::class_<DiffResult>(module, "Diff",
                         "The result of a comparison of two pictures. str() gives a table.")
      .def_property_readonly(
          "same", [](const DiffResult& v) { return v.diff.same; },
          "Whether the pictures differ by no more than limits or noise allow.")
      .def_property_readonly("verdict",
                             [](const DiffResult& v) { return image::verdict_text(v.diff); })
      .def_property_readonly(
          "reasons", [](const DiffResult& v) { return v.diff.reasons; },
          "Sentences that state why the pictures are different.")
      .def(
          "data",
          [](const DiffResult& v) {
            return from_json(image::to_json(v.diff, v.reference, v.test));
          },
          "The result as dicts and lists, as in `vug diff --json`.")
      .def("__str__", [](const DiffResult& v) { return image::to_table(v.diff); })
      .def("__repr__", [](const DiffResult& v) {
        return fmt::format("<vug.Diff: {}>", v.diff.same ? "the same" : "different");
      });
  module.def(
      "diff", &compare, "reference"_a, "test"_a, "limits"_a = std::map<std::string, double>(),
      "layers"_a = std::vector<std::string>(), "measures"_a = std::vector<std::string>(),
      "alarm"_a = py::none(),
      "Compares two pictures, each a vug.Image or a file, as `vug diff` does. limits: bounds of\n"
      "measures, {'rmse': 0.01, 'N.max': 0.1}; alarm: requires the significance test with this\n"
      "false-alarm rate.");
}

}  // namespace vug::python
