// SPDX-License-Identifier: MIT
#include "uses/fit/nuisance_table.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "uses/fit/nuisances_of_air.h"

namespace coppermoon::uses {
namespace {

/// Prior standard deviation of the logarithm of a quantity about which nothing is known.
constexpr double unknown_deviation = 10;

/// Logarithmic mean y of two values: ln(a/b) = (a − b)/y.
double logarithmic_mean(double a, double b) {
  const double ratio = a / b - 1;
  return std::abs(ratio) < 1e-4 ? std::sqrt(a * b) : b * ratio / std::log1p(ratio);
}

/// Derivatives of the light in a channel, divided by the mean of its expected and its measured light.
struct Growth {
  std::array<double, 3>
      by_channel{};  ///< derivatives with respect to the share of each Rec.709 channel in this one
  glm::dvec3 by_gain{0};  ///< derivatives with respect to the logarithm of each camera gain
};

std::array<double, 3> mixed(const std::array<double, 3>& light, const Mixing& mixing) {
  std::array<double, 3> written;
  for (std::size_t k = 0; k < 3; ++k)
    written[k] = std::inner_product(light.begin(), light.end(), mixing[k].begin(), 0.);
  return written;
}

/// Logarithm of the ratio of red to blue light in a photograph, 0 or more.
double redness(const Binned& photograph) {
  const auto& values = photograph.light.values;
  double red = 0, blue = 0;
  for (std::size_t b = 0; b < photograph.scene->bins; ++b)
    if (values(b, 0) > 0 && values(b, 2) > 0) {
      red += values(b, 0);
      blue += values(b, 2);
    }
  return blue > 0 ? std::max(0., std::log(red / blue)) : 0;
}

/// Derivatives of a measurement's light at the expected brightness.
Growth growth_of(const Binned& photograph, const NightErrors& night, const NightRows& rows,
                 const Measurement& measurement) {
  const auto& [p, b, k, logarithm, error, of_computation] = measurement;
  const auto usual = xyz_of_rec709(photograph.scene->usual_values.row(b));
  const std::span<const double> xyz =
      night.expected.empty() ? std::span<const double>(usual) : night.expected.row(rows.own(p, b));
  const auto& colours = photograph.colours;
  const auto light = rec709_by(colours, xyz, least_of_brightest);
  const auto written = mixed(light, night.mixing);
  const auto brightest =
      static_cast<std::size_t>(std::ranges::max_element(written) - written.begin());
  const auto seen = photograph.light.values.row(b);
  // measured light, scaled so that the brightest channel has its expected brightness
  const double as_bright =
      seen[brightest] > 0 ? seen[k] / seen[brightest] * written[brightest] : written[k];
  const double least = least_of_brightest * written[brightest];
  const double mean = logarithmic_mean(std::max(as_bright, least), std::max(written[k], least));
  Growth growth{light, colours ? parts_of(k, *colours, xyz) / mean : glm::dvec3(0)};
  for (double& value : growth.by_channel) value /= mean;
  return growth;
}

}  // namespace

std::vector<double> clock_steps_s(double clock_error_s) {
  constexpr double step_s = 60;
  return clock_error_s > 0 ? std::vector<double>{-step_s, 0, step_s} : std::vector<double>{0};
}

NightRows rows_of(std::span<const Binned> photographs, const NightErrors& night) {
  return {clock_steps_s(night.clock_error_s).size(),
          photographs.empty() ? 0 : photographs.front().scene->bins};
}

bool is_mixed(std::span<const Binned> photographs) {
  return std::ranges::any_of(photographs,
                             [](const Binned& one) { return one.errors.mixing_error > 0; });
}

std::array<double, 3> as_written(std::span<const double> xyz,
                                 const std::optional<CameraColours>& colours, const Mixing& mixing,
                                 double least) {
  const auto rgb = rec709_by(colours, xyz, least);
  auto written = mixed(rgb, mixing);
  const double dark = std::max(1e-12, least * *std::ranges::max_element(rgb));
  for (double& value : written) value = std::max(value, dark);
  return written;
}

std::vector<Nuisance> nuisances_of(std::span<const Binned> photographs, const NightErrors& known) {
  constexpr auto night = SharedBy::night, each = SharedBy::photograph;
  const auto rows = rows_of(photographs, known);
  const auto of = [=](const Measurement& m) -> const Binned& { return photographs[m.photograph]; };
  const auto errors = [=](const Measurement& m) -> const PhotometricErrors& {
    return of(m).errors;
  };
  const auto scaled = [=](const Measurement& m) { return errors(m).value_per_cd_m2.has_value(); };
  const auto shared = [=](const Measurement& m) { return errors(m).white_balance_shared; };
  const auto alike = [](const Measurement&, std::size_t) { return 1.; };
  const auto over_light = [=](const Measurement& m) {
    return 1 / of(m).light.values(m.bin, m.channel);
  };
  const auto growth = [=, &known](const Measurement& m) {
    return growth_of(of(m), known, rows, m);
  };
  const auto red_or_blue = [=](const Measurement& m, std::size_t n) {
    const auto gain = static_cast<int>(2 * n);
    if (of(m).colours) return growth(m).by_gain[gain];
    return m.channel == 2 * n ? 1. : 0.;
  };
  const auto of_brightest = [=](const Measurement& m, std::size_t n) {
    return n == m.channel ? std::ranges::max(of(m).light.values.row(m.bin)) * over_light(m) : 0;
  };
  const bool curved =
      std::ranges::any_of(photographs, [](const Binned& one) { return !one.light.slopes.empty(); });
  const std::size_t cameras =
      photographs.empty() ? 0 : photographs.front().scene->by_filters.size();
  const bool any_mixed = is_mixed(photographs);
  const auto limbs = limbs_of(photographs);
  return {
      {"exposure", night, 1,
       [=](const Measurement& m) { return scaled(m) ? errors(m).exposure_error : 0; }, alike},
      {"white balance", night, 2,
       [=](const Measurement& m) { return shared(m) ? errors(m).white_balance_error : 0; },
       red_or_blue},
      // the redder a photograph, the more blue an automatic white balance adds
      {"automatic balance", night, 1,
       [=](const Measurement& m) { return shared(m) ? 0 : errors(m).white_balance_error; },
       [=](const Measurement& m, std::size_t) {
         return (red_or_blue(m, 1) - red_or_blue(m, 0)) / 2 * redness(of(m));
       }},
      {"tone curve", night, curved ? colour::tone_numbers : 0,
       [=](const Measurement& m) { return of(m).light.slopes.empty() ? 0. : 1.; },
       [=](const Measurement& m, std::size_t n) {
         return of(m).light.slopes(m.bin, m.channel)[n];
       }},
      {"saturation", night, any_mixed ? 1UL : 0,
       [=](const Measurement& m) { return errors(m).saturation_error; },
       [=](const Measurement& m, std::size_t) {
         const auto by = growth(m).by_channel;
         return by[m.channel] -
                std::inner_product(by.begin(), by.end(), luminance_of_rec709.begin(), 0.);
       }},
      // off-diagonal elements of the colour matrix, row by row
      {"mixing", night, any_mixed ? 6UL : 0,
       [=](const Measurement& m) { return errors(m).mixing_error; },
       [=](const Measurement& m, std::size_t n) {
         return n / 2 == m.channel ? growth(m).by_channel[(n % 2) + (n % 2 >= m.channel)] : 0;
       }},
      {"dark channels", night, any_mixed ? 3UL : 0,
       [=](const Measurement& m) { return errors(m).dark_error; }, of_brightest},
      // this prior gives the error the covariance of the other cameras' differences from the assumed camera
      {"filters", night, cameras,
       [=](const Measurement&) { return 1 / std::sqrt(static_cast<double>(cameras)); },
       [=](const Measurement& m, std::size_t n) {
         return of(m).scene->by_filters[n](m.bin, m.channel);
       }},
      weather_of(photographs, known, rows, limbs),
      aerosol_of(photographs, known, rows, limbs),
      {"shutter", each, 1,
       [=](const Measurement& m) {
         return scaled(m) ? errors(m).shutter_error : unknown_deviation;
       },
       alike},
      {"own white balance", each, 2,
       [=](const Measurement& m) {
         return shared(m) ? errors(m).white_balance_drift : errors(m).white_balance_error;
       },
       red_or_blue},
      {"own dark channels", each, any_mixed ? 3UL : 0,
       [=](const Measurement& m) { return errors(m).dark_error / 2; }, of_brightest},
      {"sky", each, 3,
       [=](const Measurement& m) { return of(m).light.sky_errors(m.bin, m.channel); },
       [=](const Measurement& m, std::size_t n) { return n == m.channel ? over_light(m) : 0; }},
      {"place", each, 1, [=](const Measurement& m) { return errors(m).place_error_km; },
       [=](const Measurement& m, std::size_t) {
         return of(m).scene->place_slopes(m.bin, m.channel);
       }},
      {"glow", each, 1,
       [=](const Measurement& m) { return of(m).light.glow_errors(m.bin, m.channel); },
       [=](const Measurement& m, std::size_t) { return over_light(m); }},
  };
}

Design design_of(std::span<const Nuisance> table, std::span<const Measurement> measurements,
                 std::size_t photographs) {
  Design design;
  std::size_t columns = 0;
  for (const auto& nuisance : table) {
    const bool own = nuisance.shared_by == SharedBy::photograph;
    if (!own) design.first_own = columns + nuisance.count;
    design.first[nuisance.name] = columns;
    columns += own ? nuisance.count * photographs : nuisance.count;
  }
  design.matrix = {measurements.size(), columns};
  for (const auto& nuisance : table)
    for (std::size_t i = 0; nuisance.count > 0 && i < measurements.size(); ++i) {
      const auto& measurement = measurements[i];
      const double prior = nuisance.prior(measurement);
      if (prior == 0) continue;
      const auto first =
          design.first.at(nuisance.name) + (nuisance.shared_by == SharedBy::photograph
                                                ? measurement.photograph * nuisance.count
                                                : 0);
      for (std::size_t n = 0; n < nuisance.count; ++n)
        design.matrix(i, first + n) = prior * nuisance.derivative(measurement, n);
    }
  return design;
}

}  // namespace coppermoon::uses
