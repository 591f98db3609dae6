// SPDX-License-Identifier: MIT
// Factors on the chance of cloud and on the free troposphere's aerosol that fit measured eclipses best, and how well they
// foretell each eclipse when it is left out: a table in Markdown, magnitudes of observed less computed brightness.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "algebra/interpolation.h"
#include "tests/measurements/umbral_light.h"
#include "uses/light/photometer.h"
#include "uses/picture/brightness.h"
#include "uses/picture/moment_text.h"

using namespace coppermoon;
using namespace coppermoon::measurements;

namespace {

const std::vector<double> cloud{0.25, 0.35, 0.5, 0.7, 1, 1.4}, free_air{0, 0.5, 1, 1.5, 2, 3};

struct Factors {
  double cloud, free_troposphere;
};

uses::Air air_with(const Factors& factors) {
  uses::Air air;
  air.column.cloud_chance = factors.cloud;
  air.column.free_troposphere = factors.free_troposphere;
  return air;
}

/// Differences of an eclipse [mag]: one of the whole Moon, or two at each place of the umbra.
using Differences = std::vector<double>;

struct Measured {
  std::string name;
  std::vector<Differences> on_grid;  ///< [cloud][free troposphere]

  Differences at(const Factors& factors) const {
    const auto c = algebra::on_line(cloud, factors.cloud),
               f = algebra::on_line(free_air, factors.free_troposphere);
    const auto grid = [&](std::size_t i, std::size_t j) {
      return on_grid[i * free_air.size() + j];
    };
    auto all = grid(c.below, f.below);
    for (std::size_t k = 0; k < all.size(); ++k)
      all[k] = std::lerp(std::lerp(grid(c.below, f.below)[k], grid(c.below, f.above)[k], f.further),
                         std::lerp(grid(c.above, f.below)[k], grid(c.above, f.above)[k], f.further),
                         c.further);
    return all;
  }
  double rms(const Factors& factors) const {
    double sum = 0;
    const auto all = at(factors);
    for (const double one : all) sum += one * one;
    return std::sqrt(sum / static_cast<double>(all.size()));
  }
};

/// Magnitude by which an observer's value exceeds the computed one.
double apart(const std::string& date, const std::string& quantity, double value,
             const uses::Air& air) {
  const auto sky = almanac::sky_at(uses::moment_in(date));
  uses::MoonRequest moon;
  moon.light.air = air;
  const auto V = [&] { return uses::brightness_of(moon, sky).disc.magnitudes[uses::V_band]; };
  double computed = V();
  if (quantity == "dimming") {
    moon.unshadowed = true;
    computed -= V();
  } else if (quantity == "standard") {
    const double moon_km = glm::length(sky.moon_m) / 1e3,
                 sun_au = glm::length(sky.sun_m) / 1.495978707e11;
    computed += 5 * std::log10(384400 / moon_km / sun_au);
  }
  return value - computed;
}

template <class Difference>
Measured on_grid(const std::string& name, Difference difference) {
  Measured measured{name, {}};
  for (const double c : cloud)
    for (const double f : free_air) measured.on_grid.push_back(difference(air_with({c, f})));
  return measured;
}

std::vector<Measured> measured(const std::string& photometers, const std::string& umbra) {
  std::vector<Measured> all;
  std::ifstream file(photometers);
  if (!file) throw algebra::Error(photometers + ": cannot be read");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto rows = algebra::parse_text_table(text);
  for (std::size_t r = 1; r < rows.size(); ++r)
    all.push_back(on_grid(rows[r][0], [&](const uses::Air& air) {
      return Differences{apart(rows[r][0], rows[r][1], std::stod(rows[r][2]), air)};
    }));
  all.push_back(on_grid("2022-05-16, the umbra", [&](const uses::Air& air) {
    Differences together;
    for (const auto& [utc, seen] : frames_in(umbra))
      for (const auto& [red, green] : differences(air, utc, seen))
        together.insert(together.end(), {red, green});
    return together;
  }));
  return all;
}

enum class Fitted { cloud_alone, both };

/// Factors of the least mean square over all eclipses but one, each of which counts once.
Factors best(Fitted fitted, const std::vector<Measured>& all, const Measured* left_out = nullptr) {
  Factors best{};
  double least = 1e9;
  const auto look = [&](const Factors& factors) {
    double sum = 0;
    for (const auto& one : all)
      if (&one != left_out) sum += std::pow(one.rms(factors), 2);
    if (sum < least) least = sum, best = factors;
  };
  for (double c = cloud.front(); c <= cloud.back() + 1e-9; c += 0.01) {
    if (fitted == Fitted::cloud_alone) look({c, 1});
    if (fitted == Fitted::both)
      for (double f = 0; f <= free_air.back() + 1e-9; f += 0.05) look({c, f});
  }
  return best;
}

std::string shown(const Measured& one, const Factors& factors) {
  const auto differences = one.at(factors);
  return differences.size() > 1
             ? fmt::format("rms {:.2f}", one.rms(factors))
             : (differences[0] < 0 ? "−" : "+") + fmt::format("{:.2f}", std::abs(differences[0]));
}

void print(const std::vector<Measured>& all) {
  constexpr Factors standard{1, 1};
  std::array<double, 3> squares{};
  fmt::print(
      "| eclipse | `standard` | cloud fitted to the others | its factor | both fitted to the "
      "others | "
      "their factors |\n| --- | ---: | ---: | ---: | ---: | ---: |\n");
  for (const auto& one : all) {
    const auto c = best(Fitted::cloud_alone, all, &one), both = best(Fitted::both, all, &one);
    std::size_t k = 0;
    for (const auto& factors : {standard, c, both}) squares[k++] += std::pow(one.rms(factors), 2);
    fmt::print("| {} | {} | {} | {:.2f} | {} | {:.2f}, {:.2f} |\n", one.name, shown(one, standard),
               shown(one, c), c.cloud, shown(one, both), both.cloud, both.free_troposphere);
  }
  const auto rms = [&](std::size_t k) {
    return std::sqrt(squares[k] / static_cast<double>(all.size()));
  };
  const auto c = best(Fitted::cloud_alone, all), both = best(Fitted::both, all);
  fmt::print("| rms; factors of all | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f}, {:.2f} |\n",
             rms(0), rms(1), c.cloud, rms(2), both.cloud, both.free_troposphere);
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count != 3) throw algebra::Error("two words: photometers.csv, umbra_profile.csv");
    print(measured(words[1], words[2]));
  } catch (const std::exception& error) {
    fmt::print(stderr, "calibration: {}\n", error.what());
    return 1;
  }
}
