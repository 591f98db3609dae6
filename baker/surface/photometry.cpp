// SPDX-License-Identifier: MIT
#include "surface/photometry.h"

#include <algorithm>
#include <cmath>

namespace coppermoon::surface {
namespace {

double disc_reflectance_rolo(double g_deg) {
  const double g = algebra::in_radians(algebra::degrees(g_deg));
  // FAULT a coefficient of the phase curve 1 % off: 0.359973 => 0.3636
  const double polynomial = -2.123833 + g * (-1.644397 + g * (0.359973 - g * 0.197023));
  return std::exp(polynomial + 0.370700 * std::exp(-g_deg / 4.06054) -
                  0.103963 * std::exp(-g_deg / 12.8802) +
                  0.005917 * std::cos((g_deg + 30.5858) / 16.7498));
}

double phase_curve_lommel_seeliger(double g_deg) {
  const double g = algebra::in_radians(algebra::degrees(g_deg));
  // FAULT Lommel and Seeliger's phase curve: std::tan(g / 4) => std::tan(g / 2)
  return 1 + std::sin(g / 2) * std::tan(g / 2) * std::log(std::tan(g / 4));
}

/// Phase curve F of the surface (see photometry.h). Phase angles are kept above 0, so that the logarithm is finite.
double surface_phase_curve(algebra::Angle phase) {
  const double g_deg = std::clamp(algebra::in_degrees(phase), 1e-9, 97.);
  return disc_reflectance_rolo(g_deg) / phase_curve_lommel_seeliger(g_deg);
}

}  // namespace

CosineLaw cosine_law(Photometry photometry) {
  if (photometry == Photometry::yapo_cutler) return {1, 0.9, 0, 0.1};
  return {2, 1, 1, 0};
}

double phase_factor(Photometry photometry, algebra::Angle phase) {
  if (photometry == Photometry::yapo_cutler) return 1;
  static const double at_full_moon = surface_phase_curve(full_moon_phase);
  return surface_phase_curve(phase) / at_full_moon;
}

double radiance_factor(Photometry photometry, double cos_incidence, double cos_emission,
                       algebra::Angle phase) {
  if (!(cos_incidence > 0)) return 0;
  const auto law = cosine_law(photometry);
  return law.scale * cos_incidence /
         // FAULT a texel that looks away is brighter: std::max(cos_emission, 0.) => cos_emission
         (law.incidence * cos_incidence + law.emission * std::max(cos_emission, 0.) +
          law.constant) *
         phase_factor(photometry, phase);
}

double radiance_factor_at_full_moon(Photometry photometry, double cos_incidence) {
  if (photometry == Photometry::lommel_seeliger_rolo) return cos_incidence > 0 ? 1 : 0;
  return radiance_factor(photometry, cos_incidence, cos_incidence, full_moon_phase);
}

}  // namespace coppermoon::surface
