// SPDX-License-Identifier: MIT
#include "uses/tradeoff/sweeps.h"

#include <algorithm>

namespace coppermoon::uses {
namespace {

using Values = std::vector<double>;

Sweep with_at_most(Sweep sweep, double most) {
  std::erase_if(sweep.values, [&](double value) { return value > most; });
  return sweep;
}

/// The trial with only ten spectral bands, because 200 bands in 1000 sectors would fill the memory.
Trial in_ten_bands(Trial trial) {
  trial.wavelengths = 10;
  return trial;
}

}  // namespace

std::vector<Trial> Sweep::trials() const {
  std::vector<Trial> all(values.size(), middle);
  for (std::size_t i = 0; i < values.size(); ++i) all[i].*setting = values[i];
  return all;
}

std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const auto solver : plan::solvers) names.emplace_back(name(solver));
  return names;
}

std::vector<Sweep> sweeps(bool quick, double replicas) {
  const auto values = [=](const Values& few, const Values& all) { return quick ? few : all; };
  const double fewer = quick ? 10 : 1, step_km = quick ? 10 : 1, bands = quick ? 40 : 200,
               width = quick ? 256 : 512;
  const Trial exact{.solver = plan::Solver::quadrature, .rays = 300, .texture_width = width};
  const Trial table{.solver = plan::Solver::table,
                    .photons = 1e6 / fewer,
                    .wavelengths = bands,
                    .rays = 300,
                    .replicas = 100,
                    .texture_width = width};
  const Trial literal{.solver = plan::Solver::literal,
                      .photons = 1e4 / fewer,
                      .step_km = step_km,
                      .wavelengths = bands,
                      .replicas = 100,
                      .texture_width = width};
  const Values all_rays{30, 60, 100, 300, 1000, 3000},
      all_bands{3, 5, 10, 24, 32, 48, 80, 200, 400}, all_steps_km{30, 10, 3, 1, 0.3, 0.1};
  const auto decades = [&](const Values& few) {
    return values(few, {1e3, 1e4, 1e5, 1e6, 1e7, 1e8});
  };
  return {{exact, "rays", &Trial::rays, values({30, 100, 300}, all_rays)},
          {exact, "wavelengths", &Trial::wavelengths, values({3, 10, 40}, all_bands)},
          {exact, texture_sweep, &Trial::texture_width,
           values({64, 128, 256}, {256, 512, 1024, 2048, 4096, 8192})},
          {table, "photons", &Trial::photons, decades({1e3, 1e4, 1e5, 1e6})},
          {table, "rays", &Trial::rays, values({30, 300}, all_rays)},
          {table, "wavelengths", &Trial::wavelengths, values({3, 40}, all_bands)},
          with_at_most({in_ten_bands(table), "replicas", &Trial::replicas,
                        values({10, 100, 1000}, {1000, 100, 10, 1})},
                       replicas),
          {literal, "photons", &Trial::photons, decades({1e3, 1e4, 1e6})},
          {literal, "step", &Trial::step_km, values({30, 10, 3}, all_steps_km)}};
}

std::vector<Sweep> sweeps_of(std::span<const std::string> solvers, std::vector<Sweep> sweeps) {
  std::erase_if(sweeps, [&](const Sweep& sweep) {
    return !solvers.empty() &&
           std::ranges::find(solvers, name(sweep.middle.solver)) == solvers.end();
  });
  return sweeps;
}

}  // namespace coppermoon::uses
