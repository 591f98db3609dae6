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

/// Ten bands, for a thousand sectors of two hundred would fill the memory.
Trial in_ten_bands(Trial trial) {
  trial.wavelengths = 10;
  return trial;
}

std::vector<Sweep> quick_sweeps(double replicas) {
  constexpr double width = 256;
  const Trial exact{.solver = quadrature_solver, .rays = 300, .texture_width = width},
      table{.solver = table_solver,
            .photons = 1e5,
            .wavelengths = 40,
            .rays = 300,
            .replicas = 100,
            .texture_width = width},
      marched{.solver = marching_solver,
              .photons = 1e4,
              .step_km = 3,
              .wavelengths = 40,
              .replicas = 100,
              .texture_width = width},
      stepped{.solver = step_by_step_solver,
              .photons = 1e3,
              .step_km = 3,
              .wavelengths = 40,
              .replicas = 100,
              .texture_width = width};
  return {
      {exact, "rays", &Trial::rays, {30, 100, 300, 1000}},
      {exact, "wavelengths", &Trial::wavelengths, {3, 10, 40}},
      {exact, texture_sweep, &Trial::texture_width, {64, 128, 256}},
      {table, "photons", &Trial::photons, {1e3, 1e5, 1e7}},
      {table, "rays", &Trial::rays, {30, 300}},
      {table, "wavelengths", &Trial::wavelengths, {3, 40}},
      with_at_most({in_ten_bands(table), "replicas", &Trial::replicas, {10, 100, 1000}}, replicas),
      {marched, "photons", &Trial::photons, {1e3, 1e4, 1e5}},
      {marched, "step", &Trial::step_km, {30, 3}},
      {marched, "precision", &Trial::precision_bits, {32, 64}},
      {stepped, "photons", &Trial::photons, {1e3, 1e4, 1e5}},
      {stepped, "step", &Trial::step_km, {30, 10, 3}}};
}

}  // namespace

std::vector<Trial> Sweep::trials() const {
  std::vector<Trial> all(values.size(), middle);
  for (std::size_t i = 0; i < values.size(); ++i) all[i].*setting = values[i];
  return all;
}

std::vector<std::string> solver_names() {
  return {std::string(quadrature_solver), std::string(table_solver), std::string(marching_solver),
          std::string(step_by_step_solver)};
}

std::vector<Sweep> sweeps(bool quick, double replicas) {
  if (quick) return quick_sweeps(replicas);
  const Trial exact{.solver = quadrature_solver, .rays = 300},
      table{.solver = table_solver, .photons = 1e6, .rays = 300, .replicas = 100},
      marched{.solver = marching_solver, .photons = 1e5, .step_km = 1, .replicas = 100},
      stepped{.solver = step_by_step_solver, .photons = 1e4, .step_km = 1, .replicas = 100};
  const Values decades{1e3, 1e4, 1e5, 1e6, 1e7, 1e8}, rays{30, 60, 100, 300, 1000, 3000},
      bands{3, 5, 10, 20, 40, 100, 200, 400};
  return {{exact, "rays", &Trial::rays, rays},
          {exact, "wavelengths", &Trial::wavelengths, bands},
          {exact, texture_sweep, &Trial::texture_width, {256, 512, 1024, 2048, 4096, 8192}},
          {table, "photons", &Trial::photons, decades},
          {table, "rays", &Trial::rays, rays},
          {table, "wavelengths", &Trial::wavelengths, bands},
          with_at_most({in_ten_bands(table), "replicas", &Trial::replicas, {1000, 100, 10, 1}},
                       replicas),
          {marched, "photons", &Trial::photons, decades},
          {marched, "step", &Trial::step_km, {30, 10, 3, 1, 0.3, 0.1}},
          {marched, "precision", &Trial::precision_bits, {32, 64}},
          {stepped, "photons", &Trial::photons, decades},
          {stepped, "step", &Trial::step_km, {30, 10, 3, 1, 0.3, 0.1}}};
}

std::vector<Sweep> sweeps_of(std::span<const std::string> solvers, std::vector<Sweep> sweeps) {
  std::erase_if(sweeps, [&](const Sweep& sweep) {
    return !solvers.empty() && std::ranges::find(solvers, sweep.middle.solver) == solvers.end();
  });
  return sweeps;
}

}  // namespace coppermoon::uses
