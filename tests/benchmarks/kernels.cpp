// SPDX-License-Identifier: MIT
// What the kernels cost, one core: `coppermoon_benchmarks --benchmark_filter=paper`. Items are steps of rays, or rays.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "atmosphere/presets.h"
#include "photons/bending.h"
#include "photons/photon.h"
#include "photons/trace.h"
#include "shadow/by_photons.h"
#include "shadow/by_quadrature.h"

namespace coppermoon {
namespace {

constexpr double sun_distance_m = 1.496e11;

atmosphere::Atmosphere air_of(const char* preset) {
  return atmosphere::preset(preset, algebra::degrees(-10));
}

atmosphere::Optics green_of(const atmosphere::Atmosphere& air) {
  return atmosphere::sea_level_optics(algebra::nanometres(550), air.molecules);
}

std::vector<photons::Ray> photons_entering(const atmosphere::Atmosphere& air) {
  std::vector<photons::Ray> rays;
  for (std::uint64_t i = 0; rays.size() < 64; ++i) {
    algebra::Random random(1, i);
    const auto ray = photons::aimed_at_the_ring(random, sun_distance_m, air);
    if (const auto met = photons::entered(ray, air.top_radius_m())) rays.push_back(*met);
  }
  return rays;
}

/// Photons of the paper's simulation, step by step of 1 km. Left out are those that meet the ground,
/// for their steps are not told.
void trace(benchmark::State& state, const char* preset) {
  const auto air = air_of(preset);
  const auto green = green_of(air);
  auto rays = photons_entering(air);
  std::erase_if(rays, [&](const auto& ray) { return !photons::trace(ray, air, green, {}); });
  std::int64_t steps = 0;
  for (auto _ : state)
    for (const auto& ray : rays) steps += photons::trace(ray, air, green, {})->steps;
  state.SetItemsProcessed(steps);
}

/// Tangent heights as even as those photons' impact parameters.
std::vector<double> tangent_heights(const atmosphere::Atmosphere& air) {
  constexpr int rays = 256;
  std::vector<double> heights;
  for (int i = 0; i < rays; ++i) heights.push_back(air.top_m() * (i + 0.5) / rays);
  return heights;
}

void limb_path(benchmark::State& state, const char* preset) {
  const auto air = air_of(preset);
  const auto green = green_of(air);
  const auto heights = tangent_heights(air);
  for (auto _ : state)
    for (const double h : heights)
      benchmark::DoNotOptimize(
          photons::limb_path(h, air.earth.equatorial_radius_m, air.column, green.refractivity));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(heights.size()));
}

/// 200 wavelengths at 1000 places, all threads.
void by_quadrature(benchmark::State& state, const char* preset) {
  const auto air = air_of(preset);
  std::vector<double> wavelengths_nm, places_m;
  for (int i = 0; i < 200; ++i) wavelengths_nm.push_back(381 + 2 * i);
  for (int i = 0; i < 1000; ++i) places_m.push_back(9e3 * i);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        shadow::by_quadrature(air, {sun_distance_m, {3.8e8}}, wavelengths_nm, places_m));
  state.SetItemsProcessed(state.iterations() *
                          static_cast<std::int64_t>(wavelengths_nm.size() * places_m.size()));
}

/// Photons of 200 wavelengths in rings, or rings and sectors, all threads; what is tabulated first
/// included.
void by_photons(benchmark::State& state, const char* preset, shadow::PhotonSettings settings) {
  const auto air = air_of(preset);
  std::vector<double> wavelengths_nm;
  for (int i = 0; i < 200; ++i) wavelengths_nm.push_back(381 + 2 * i);
  if (!air.symmetric()) settings.sectors = shadow::sectors_around;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        shadow::traced(air, {sun_distance_m, {3.8e8}}, wavelengths_nm, settings));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(settings.photons));
}

template <class... Arguments>
auto* registered(const std::string& kernel, const char* preset, Arguments... arguments) {
  return benchmark::RegisterBenchmark((kernel + "/" + preset).c_str(), arguments...)
      ->Unit(benchmark::kMillisecond);
}

void register_kernels(const char* preset) {
  registered("trace", preset, trace, preset);
  registered("limb_path", preset, limb_path, preset);
  registered("by_quadrature", preset, by_quadrature, preset)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
  shadow::PhotonSettings settings;
  settings.photons = 100 * shadow::photons_a_block;
  registered("photons_table", preset, by_photons, preset, settings)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
}

}  // namespace
}  // namespace coppermoon

int main(int argc, char** argv) {
  for (const char* preset : {"paper", "undated"}) coppermoon::register_kernels(preset);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
