// SPDX-License-Identifier: MIT
// What the bake of a texture costs beside the writing of its file: `coppermoon_bake_benchmark`,
// best with --benchmark_repetitions=5 --benchmark_report_aggregates_only=true. 4096 x 2048 texels, half,
// PIZ, float buffers on both sides, of an eclipsed Moon half in the umbra.
#include <OpenImageIO/imageio.h>
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <filesystem>

#include "shadow/by_quadrature.h"
#include "texture/bake.h"
#include "texture/write_image.h"

namespace {

using namespace coppermoon;

constexpr std::size_t rows = 2048;
const texture::Layout layout{2 * rows, rows, {"R", "G", "B"}};
constexpr auto photometry = surface::Photometry::lommel_seeliger_rolo;

struct Scene {
  almanac::SkyState sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:08:26Z"));
  algebra::Grid<float> albedo{rows, 2 * rows};
  shadow::Lookup light = lookup();

  Scene() {
    for (std::size_t i = 0; i < albedo.values().size(); ++i)
      albedo.values()[i] = 0.08F + 0.001F * static_cast<float>(i * 7919 % 61);
  }

  static shadow::Lookup lookup() {
    const std::vector<double> waves{450, 550, 650};
    std::vector<double> distances_m;
    for (double d = 0; d < 9.4e6; d += 25e3) distances_m.push_back(d);
    const auto refracted = shadow::by_quadrature({}, {1.479e11, {3.80e8, 3.82e8, 3.84e8}}, waves,
                                                 distances_m, {.rays = 100});
    shadow::ChannelWeights each(3, 3);
    for (std::size_t c = 0; c < 3; ++c) each(c, c) = 1000;
    return shadow::Lookup(refracted, shadow::DirectLight({}, refracted.arrangement, waves), each);
  }

  texture::Rows lit() const { return texture::lit_rows({albedo, sky, light}, rows, {photometry}); }
};

const Scene& scene() {
  static const Scene one;
  return one;
}

const texture::Image& baked() {
  static const auto image = texture::bake({scene().albedo, scene().sky, scene().light},
                                          layout.channels, rows, photometry);
  return image;
}

std::filesystem::path file() {
  return std::filesystem::temp_directory_path() / "coppermoon_bake_benchmark.exr";
}

void write_by_openimageio_alone(benchmark::State& state) {
  const auto& image = baked();
  OIIO::ImageSpec spec(2 * rows, rows, 3, OIIO::TypeDesc::HALF);
  spec.attribute("compression", "piz");
  for (auto _ : state) {
    const auto output = OIIO::ImageOutput::create("openexr");
    output->open(file().string(), spec);
    output->write_image(OIIO::TypeDesc::FLOAT, image.values.data());
    output->close();
  }
  std::filesystem::remove(file());
}

void bake_and_write(benchmark::State& state) {
  for (auto _ : state) texture::write_exr(file(), layout, scene().lit(), {});
  std::filesystem::remove(file());
}

void bake_to_memory(benchmark::State& state) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(0)));
  std::vector<float> values(rows * 2 * rows * 3);
  const auto lit = scene().lit();
  for (auto _ : state) lit(0, values);
}

BENCHMARK(write_by_openimageio_alone)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(bake_and_write)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(bake_to_memory)
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
