// SPDX-License-Identifier: Apache-2.0
// Pictures: layers as arrays that share memory, and files.
#include "image.h"

#include "arrays.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/image/layers.h>

namespace vug::python {
namespace {

/// View of a layer's channels in the picture's memory: (height, width) for one channel, otherwise
/// (height, width, k). The channels of a layer are contiguous in rendered pictures.
py::array layer_view(const Image& self, const image::Layer& layer) {
  const image::Image& picture = self.image();
  const auto first = static_cast<size_t>(picture.find_channel(layer.channels.front()));
  for (size_t c = 0; c < layer.channels.size(); ++c)
    if (picture.find_channel(layer.channels[c]) != static_cast<int>(first + c))
      throw Error(ErrorCode::internal,
                  fmt::format("the channels of '{}' are not contiguous", layer.name));
  constexpr auto kFloat = static_cast<py::ssize_t>(sizeof(float));
  const auto pixel = kFloat * static_cast<py::ssize_t>(picture.channels.size());
  std::vector<py::ssize_t> shape = {picture.height, picture.width};
  std::vector<py::ssize_t> strides = {pixel * picture.width, pixel};
  if (layer.channels.size() > 1) {
    shape.push_back(static_cast<py::ssize_t>(layer.channels.size()));
    strides.push_back(kFloat);
  }
  return view(py::dtype::of<float>(), shape, strides, picture.pixels.data() + first,
              capsule_of(self.rendered));
}

py::dict layers(const Image& self) {
  py::dict out;
  for (const image::Layer& each : image::layers_of(self.image().channels))
    out[py::str(each.name)] = layer_view(self, each);
  return out;
}

py::array layer(const Image& self, const std::string& name) {
  std::vector<std::string> names;
  for (const image::Layer& each : image::layers_of(self.image().channels)) {
    if (each.name == name) return layer_view(self, each);
    names.push_back(each.name);
  }
  throw py::key_error(
      fmt::format("the picture has no layer '{}'; {}", name, suggestion(name, names)));
}

py::array pixels(const Image& self) {
  const image::Image& picture = self.image();
  const auto channels = static_cast<py::ssize_t>(picture.channels.size());
  constexpr auto kFloat = static_cast<py::ssize_t>(sizeof(float));
  return view(py::dtype::of<float>(), {picture.height, picture.width, channels},
              {kFloat * channels * picture.width, kFloat * channels, kFloat}, picture.pixels.data(),
              capsule_of(self.rendered));
}

py::dict metadata(const Image& self) {
  py::dict out;
  for (const auto& [name, text] : self.part().output.metadata) out[py::str(name)] = text;
  return out;
}

py::dict views(const Image& self) {
  if (!self.in_stereo()) return py::dict();
  return py::dict("left"_a = Image{self.rendered, 0, self.checkpoint},
                  "right"_a = Image{self.rendered, 1, self.checkpoint});
}

void save_image(const Image& self, const std::filesystem::path& file) {
  const py::gil_scoped_release others;
  const std::vector<picture::PictureView> all = picture::picture_views(*self.rendered);
  picture::write_picture_file(file, self.view ? std::vector{all[*self.view]} : all);
  std::error_code ignored;
  if (extension_of(file) == ".exr" && !self.view && !self.checkpoint.empty())
    std::filesystem::remove(self.checkpoint, ignored);
}

}  // namespace

void bind_image(py::module_& module) {
  py::class_<Image>(
      module, "Image",
      "A rendered picture: float32 layers of linear light.\n\n"
      "Its arrays are read-only views that share its memory and keep it alive. Row 0\n"
      "is the top row.")
      .def_property_readonly("width", [](const Image& i) { return i.image().width; })
      .def_property_readonly("height", [](const Image& i) { return i.image().height; })
      .def_property_readonly(
          "channels", [](const Image& i) { return i.image().channels; },
          "Names of the channels as in the EXR: 'R', 'Z', 'albedo.R'.")
      .def_property_readonly(
          "origin",
          [](const Image& i) {
            const render::Region& crop = i.part().header.crop;
            return py::make_tuple(crop.x0, crop.y0);
          },
          "Position of the top left pixel in the whole picture, (0, 0) unless cropped.")
      .def_property_readonly("pixels", &pixels, "All channels: (height, width, channels).")
      .def_property_readonly("layers", &layers,
                             "Arrays by layer: (height, width, k), or (height, width) for layers\n"
                             "with one channel. 'beauty' consists of R, G and B.")
      .def("__getitem__", &layer, "layer"_a, "A layer by name.")
      .def_property_readonly("metadata", &metadata,
                             "Metadata of files about the origin of the picture.")
      .def_property_readonly("views", &views,
                             "The images 'left' and 'right' of a stereo camera; otherwise empty.")
      .def("save", &save_image, "file"_a,
           "Writes the files of `vug render`: NAME.exr with all layers, NAME.png with the view\n"
           "transform, or NAME.deep.exr of a deep picture. Writes both views of a stereo picture,\n"
           "or only one for an element of `views`.")
      .def("__repr__", [](const Image& i) {
        return fmt::format("<vug.Image {}x{}, {} channels>", i.image().width, i.image().height,
                           i.image().channels.size());
      });
}

}  // namespace vug::python
