// SPDX-License-Identifier: Apache-2.0
// A hectare of bamboo whose culms are instances of a few plants: built and rendered with one sample
// per pixel. Measures the peak memory of the process; the limit is 500 MB.
//   bench_hectare [WIDTHxHEIGHT]      default: the scene's size
#include "peak_memory.h"

#include <vug/base/error.h>
#include <vug/building/instance_source.h>
#include <vug/loading/load.h>
#include <vug/picture/render_job.h>

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <filesystem>

using namespace vug;

int main(int argc, char** argv) {
  try {
    picture::PictureOptions options;
    options.settings = {{"spp", 1}};
    int width = 0, height = 0;
    if (argc > 1) {
      if (std::sscanf(argv[1], "%dx%d", &width, &height) != 2)
        throw Error(ErrorCode::bad_input,
                    fmt::format("invalid size '{}': expected WIDTHxHEIGHT", argv[1]));
      options.settings.emplace_back("size", List{width, height});
    }
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    loading::LoadOptions loading;
    loading.include_folders = {std::filesystem::path(VUG_DATA)};
    const loading::Loaded loaded =
        loading::load(std::filesystem::path(VUG_DATA) / "scenes/bamboo/hectare.vug", loading);
    if (!loaded.usable()) throw Error(ErrorCode::bad_input, loaded.report());
    fmt::print("{:24} {:6.1f} s, peak {:5.0f} MB\n", "four plants", seconds(),
               1e-6 * peak_memory());
    building::Builder builder(loaded.shot);
    size_t culms = 0;
    for (const shot::PointInstancer& place : loaded.shot.instancers)
      for (const shot::InstanceSource& at : place.at) culms += (*at)(builder, place.key).size();
    const picture::RenderResult picture =
        picture::render_picture(builder, picture::plan_picture(loaded.shot, options));
    fmt::print("{:24} {:6.1f} s, peak {:5.0f} MB (wanted: less than 500)\n",
               fmt::format("{}x{}, {} culms", picture.image->width, picture.image->height, culms),
               seconds(), 1e-6 * peak_memory());
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
