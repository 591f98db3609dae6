// SPDX-License-Identifier: MIT
#include "shadow/limb_landings.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "algebra/low_discrepancy.h"
#include "photons/limb_darkening.h"

namespace coppermoon::shadow {
namespace {

using algebra::Grid;
using std::numbers::pi;

constexpr std::size_t brightness_cells = 64;

/// Number of bins of axis distance, each with its own distribution of tangent heights.
constexpr std::size_t distance_bins = 96;

/// Largest number of wavelengths used to compute the distribution of tangent heights.
constexpr std::size_t deciding_waves = 8;

/// Fraction of photons whose tangent height is drawn regardless of how much light each height sends. Of these photons,
/// the fraction that is spread evenly over heights instead of landing distances.
constexpr double blind_share = 0.2, even_share = 0.25;

/// Half the angle of the arc about the axis that lies within a disc of radius 1. `centre` and `distance` are the axis
/// distances of the disc's centre and of the arc.
double half_arc(double centre, double distance) {
  const double q = std::abs(centre);
  if (q + distance <= 1) return pi;
  if (std::abs(q - distance) >= 1) return 0;
  return std::acos(std::clamp((distance * distance + q * q - 1) / (2 * distance * q), -1., 1.));
}

/// Landing places of two neighbouring rays, at the middle wavelength, and the nearer and farther limit of a bin of axis
/// distance, all in projected solar radii.
struct Cell {
  double low, high, near, far;

  double arc() const {
    double most = 0;
    for (const double centre : {low, high})
      for (const double distance : {near, (near + far) / 2, far})
        most = std::max(most, half_arc(centre, distance));
    return most;
  }

  bool lit() const {
    const double most = std::max(std::abs(low), std::abs(high)),
                 least = low * high < 0 ? 0 : std::min(std::abs(low), std::abs(high));
    return most > near - 1 && least < far + 1;
  }
};

/// Scales numbers so that their sum is 1, unless all are 0.
void normalise(std::span<double> row) {
  double sum = 0;
  for (const double value : row) sum += value;
  if (sum > 0)
    for (double& value : row) value /= sum;
}

/// Writes the importance of each cell (interval between two rays) into `chances`, whose elements must be 0 on entry:
/// the root mean square, over wavelengths, of the cell's share of all the light that lands, up to a common factor.
///
/// Given  light  (wavelength, cell)
void add_seeing(const Grid<double>& light, std::span<const double> arcs,
                std::span<double> chances) {
  for (std::size_t k = 0; k < light.rows(); ++k) {
    double all = 0;
    for (std::size_t c = 0; c < arcs.size(); ++c) all += light(k, c) * arcs[c];
    if (all <= 0) continue;
    for (std::size_t c = 0; c < arcs.size(); ++c)
      chances[c] += std::pow(light(k, c) * arcs[c] / all, 2);
  }
  for (double& chance : chances) chance = std::sqrt(chance);
}

/// Probability that each cell (interval between two rays) is drawn for photons uniform in landing distance or height.
std::vector<double> blind_chances(std::span<const double> heights_m,
                                  std::span<const double> landings) {
  double swept = 0;
  for (std::size_t c = 0; c + 1 < landings.size(); ++c)
    swept += std::abs(landings[c + 1] - landings[c]);
  std::vector<double> chances;
  for (std::size_t c = 0; c + 1 < landings.size(); ++c)
    chances.push_back((1 - even_share) * std::abs(landings[c + 1] - landings[c]) / swept +
                      even_share * (heights_m[c + 1] - heights_m[c]) /
                          (heights_m.back() - heights_m.front()));
  return chances;
}

}  // namespace

LimbLandings::LimbLandings(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
                           std::span<const double> wavelengths_nm, int rays)
    : limb_(atmosphere, optics_of(atmosphere, wavelengths_nm), rays),
      arrangement_(arrangement),
      waves_(wavelengths_nm.size()) {
  for (const auto& part : limb_.parts()) tables_.push_back(table(part));
  for (const auto& table : tables_)
    for (const double landing : table.middle_landing)
      reach_ = std::max(reach_, 1 + std::abs(landing));
  for (auto& table : tables_) fill_chances(table);
  if (arrangement.limb_darkening) darken_limb(wavelengths_nm);
}

LimbLandings::Table LimbLandings::table(const photons::WholeLimb::Part& part) const {
  Table table;
  table.heights_m = part.fans.front().tangent_height_m;
  const std::size_t rays = table.heights_m.size(), width = padded(waves_);
  table.light = Grid<float>(2 * (rays - 1), width);
  table.landing_m.assign(arrangement_.depths_m.size(), Grid<float>(rays, width));
  tbb::parallel_invoke([&] { fill_light(part, table); }, [&] { fill_landings(part, table); });
  const std::size_t plane = arrangement_.depths_m.size() / 2, wave = waves_ / 2;
  for (std::size_t i = 0; i < rays; ++i)
    table.middle_landing.push_back(
        table.landing_m[plane](i, wave) /
        projected_solar_radius_m(arrangement_, arrangement_.depths_m[plane]));
  return table;
}

void LimbLandings::fill_light(const photons::WholeLimb::Part& part, Table& table) const {
  tbb::parallel_for(std::size_t{0}, table.heights_m.size() - 1, [&](std::size_t i) {
    const double width_m = table.heights_m[i + 1] - table.heights_m[i];
    for (std::size_t w = 0; w < waves_; ++w) {
      const auto& fan = part.fans[w];
      const double low = part.radius_m + fan.impact_height_m[i],
                   high = part.radius_m + fan.impact_height_m[i + 1];
      const double light = 2 * pi * fan.filter[i] * (high - low) / width_m;
      const double steep =
          (std::log(high / low) - fan.optical_depth[i + 1] + fan.optical_depth[i]) / 2;
      const double fuller = std::abs(steep) < 1e-6 ? 1 : std::tanh(steep) / steep;
      table.light(2 * i, w) =
          static_cast<float>(light * fuller * low * std::exp(-fan.optical_depth[i]));
      table.light(2 * i + 1, w) =
          static_cast<float>(light * fuller * high * std::exp(-fan.optical_depth[i + 1]));
    }
  });
}

void LimbLandings::fill_landings(const photons::WholeLimb::Part& part, Table& table) const {
  for (std::size_t k = 0; k < table.landing_m.size(); ++k)
    tbb::parallel_for(std::size_t{0}, table.heights_m.size(), [&](std::size_t i) {
      for (std::size_t w = 0; w < waves_; ++w) {
        const auto& fan = part.fans[w];
        table.landing_m[k](i, w) = static_cast<float>(
            landing_m(part.radius_m + fan.impact_height_m[i], fan.bending_rad[i],
                      // FAULT photons of all planes land on the first: depths_m[k] => depths_m[0]
                      arrangement_.sun_distance_m, arrangement_.depths_m[k]));
      }
      std::ranges::fill(table.landing_m[k].row(i).subspan(waves_),  // pads with the last wavelength
                        table.landing_m[k](i, waves_ - 1));
    });
}

Grid<double> LimbLandings::brought(const Table& table) const {
  const std::size_t each = (waves_ + deciding_waves - 1) / deciding_waves;
  Grid<double> light((waves_ + each - 1) / each, table.heights_m.size() - 1);
  for (std::size_t k = 0; k < light.rows(); ++k)
    for (std::size_t c = 0; c < light.columns(); ++c)
      light(k, c) = (table.light(2 * c, k * each) + table.light(2 * c + 1, k * each)) *
                    (table.heights_m[c + 1] - table.heights_m[c]);
  return light;
}

void LimbLandings::fill_chances(Table& table) const {
  const std::size_t cells = table.heights_m.size() - 1;
  const auto light = brought(table);
  const auto blind = blind_chances(table.heights_m, table.middle_landing);
  table.chance = Grid<double>(distance_bins, cells + 1);
  tbb::parallel_for(std::size_t{0}, distance_bins, [&](std::size_t bin) {
    const double width = reach_ / distance_bins, near = static_cast<double>(bin) * width;
    std::vector<double> arcs(cells), chances(cells), unseeing(cells);
    for (std::size_t c = 0; c < cells; ++c) {
      const Cell cell{table.middle_landing[c], table.middle_landing[c + 1], near, near + width};
      arcs[c] = cell.arc();
      unseeing[c] = cell.lit() ? blind[c] : 0;
    }
    add_seeing(light, arcs, chances);
    normalise(unseeing);
    normalise(chances);
    for (std::size_t c = 0; c < cells; ++c)
      chances[c] = (1 - blind_share) * chances[c] + blind_share * unseeing[c];
    normalise(chances);
    for (std::size_t c = 0; c < cells; ++c)
      table.chance(bin, c + 1) = table.chance(bin, c) + chances[c];
  });
}

void LimbLandings::darken_limb(std::span<const double> wavelengths_nm) {
  brightness_ = Grid<float>(brightness_cells + 1, padded(waves_));
  for (std::size_t i = 0; i <= brightness_cells; ++i)
    for (std::size_t w = 0; w < waves_; ++w)
      brightness_(i, w) = static_cast<float>(
          photons::limb_darkening(algebra::nanometres(wavelengths_nm[w]),
                                  static_cast<double>(i) / static_cast<double>(brightness_cells)));
}

std::size_t LimbLandings::part_at(double position_angle_rad, double uniform) const {
  const auto shares = limb_.at(position_angle_rad);
  return shares[uniform < shares[0].share ? 0 : 1].part;
}

/// Given  point  coordinates in the unit cube that determine, in this order, the landing's axis distance, the tangent
///               height, the landing's direction, the position angle and the part of the limb
std::optional<Aim> LimbLandings::aim(std::span<const double> point, bool around) const {
  const double angle = around ? 2 * pi * point[3] : 0, distance = reach_ * point[0];
  const std::size_t part = around ? part_at(angle, point[4]) : 0;
  const auto& table = tables_[part];
  const auto chance = table.chance.row(static_cast<std::size_t>(point[0] * distance_bins));
  const double within = point[1] * chance.back();
  const auto above = std::upper_bound(chance.begin(), chance.end(), within);
  if (above == chance.end()) return std::nullopt;
  const auto cell = static_cast<std::size_t>(above - chance.begin()) - 1;
  const double share = chance[cell + 1] - chance[cell], along = (within - chance[cell]) / share;
  const double low_m = table.heights_m[cell], high_m = table.heights_m[cell + 1];
  const double centre =
      std::lerp(table.middle_landing[cell], table.middle_landing[cell + 1], along);
  const double arc = half_arc(centre, distance), psi = (2 * point[2] - 1) * arc;
  if (arc == 0) return std::nullopt;
  const glm::dvec2 toward(std::sin(angle), std::cos(angle));
  const glm::dvec2 ahead = centre < 0 ? -toward : toward, aside(-ahead.y, ahead.x);
  const glm::dvec2 source =
      (std::abs(centre) - distance * std::cos(psi)) * ahead - distance * std::sin(psi) * aside;
  return Aim{part,
             cell,
             along,
             std::lerp(low_m, high_m, along),
             toward,
             source,
             reach_ * distance * 2 * arc / pi * (high_m - low_m) / (share / chance.back())};
}

std::vector<Aim> LimbLandings::aims(std::uint64_t seed, std::uint64_t block, bool around) const {
  const auto points = algebra::scrambled_block(seed, block, around ? 5 : 3);
  std::vector<Aim> drawn, aims;
  std::vector<std::uint64_t> order;  // a photon's part, cell and index in `drawn`, in one number
  drawn.reserve(points.rows());
  for (std::size_t i = 0; i < points.rows(); ++i)
    if (const auto photon = aim(points.row(i), around)) {
      order.push_back((photon->part << 32 | photon->cell) << 10 | drawn.size());
      drawn.push_back(*photon);
    }
  std::sort(order.begin(), order.end());
  aims.reserve(drawn.size());
  for (const auto place : order) aims.push_back(drawn[place % algebra::points_a_block]);
  return aims;
}

void LimbLandings::pass(std::span<const Aim> aims, Grid<float>& light) const {
  std::vector<Between> places;
  for (const auto& aim : aims)
    places.push_back({tables_[aim.part].light.row(2 * aim.cell).data(),
                      static_cast<float>(aim.along), static_cast<float>(aim.weight_m)});
  interpolate(places, light);
  darken(aims, light);
}

void LimbLandings::darken(std::span<const Aim> aims, Grid<float>& light) const {
  if (brightness_.empty()) return;
  std::vector<Between> on_the_sun;
  for (const auto& aim : aims) {
    const double mu = std::sqrt(std::max(0., 1 - glm::dot(aim.source, aim.source)));
    const double place = mu * brightness_cells;
    const auto cell = std::min(static_cast<std::size_t>(place), brightness_cells - 1);
    on_the_sun.push_back(
        {brightness_.row(cell).data(), static_cast<float>(place - static_cast<double>(cell))});
  }
  multiply(on_the_sun, light);
}

void LimbLandings::land(std::span<const Aim> aims, std::size_t plane,
                        Grid<float>& landing_m) const {
  std::vector<Between> places;
  for (const auto& aim : aims)
    places.push_back(
        {tables_[aim.part].landing_m[plane].row(aim.cell).data(), static_cast<float>(aim.along)});
  interpolate(places, landing_m);
}

}  // namespace coppermoon::shadow
