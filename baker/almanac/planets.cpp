// SPDX-License-Identifier: MIT
#include "almanac/planets.h"

#include <erfam.h>
#include <libnova/jupiter.h>
#include <libnova/ln_types.h>
#include <libnova/mars.h>
#include <libnova/mercury.h>
#include <libnova/neptune.h>
#include <libnova/saturn.h>
#include <libnova/uranus.h>
#include <libnova/venus.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "almanac/earth_motion.h"
#include "almanac/ephemeris.h"

namespace coppermoon::almanac {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// How a planet is lit by the Sun and seen from the Earth.
struct Aspect {
  glm::dvec3 from_sun_au, from_earth_au;
  double year;

  double sun_au() const { return glm::length(from_sun_au); }
  double earth_au() const { return glm::length(from_earth_au); }
  double phase_deg() const {
    const double cosine = glm::dot(from_sun_au, from_earth_au) / (sun_au() * earth_au());
    return std::acos(std::clamp(cosine, -1., 1.)) / degree;
  }
};

template <std::size_t count>
double polynomial(double x, const std::array<double, count>& coefficients) {
  double sum = 0;
  for (std::size_t k = count; k-- > 0;) sum = sum * x + coefficients[k];
  return sum;
}

double mercury(const Aspect& a) {
  return polynomial(a.phase_deg(), std::array{-0.613, 6.3280e-2, -1.6336e-3, 3.3644e-5, -3.4265e-7,
                                              1.6893e-9, -3.0334e-12});
}

double venus(const Aspect& a) {
  const double phase = a.phase_deg();
  return phase <= 163.7
             ? polynomial(phase, std::array{-4.384, -1.044e-3, 3.687e-4, -2.814e-6, 8.938e-9})
             : polynomial(phase, std::array{236.05828, -2.81914, 8.39034e-3});
}

/// Magnitude of Mars, valid for phase angles up to 50 degrees. As seen from the Earth, they are at most 47 degrees.
double mars(const Aspect& a) {
  return polynomial(a.phase_deg(), std::array{-1.601, 2.267e-2, -1.302e-4});
}

double jupiter(const Aspect& a) {
  return polynomial(a.phase_deg(), std::array{-9.395, -3.7e-4, 6.16e-4});
}

/// Magnitude of Saturn with its rings. It depends on the elevations of the Sun and the Earth above the rings' plane.
double saturn(const Aspect& a) {
  const double centuries = (a.year - 2000) / 100;
  const double right_ascension = (40.589 - 0.036 * centuries) * degree,
               declination = (83.537 - 0.004 * centuries) * degree;
  const glm::dvec3 pole(std::cos(declination) * std::cos(right_ascension),
                        std::cos(declination) * std::sin(right_ascension), std::sin(declination));
  const double of_sun = glm::dot(pole, a.from_sun_au) / a.sun_au(),
               of_earth = glm::dot(pole, a.from_earth_au) / a.earth_au();
  const double sine = std::sqrt(std::max(0., of_sun * of_earth)), phase = a.phase_deg();
  return -8.914 - 1.825 * sine + 0.026 * phase - 0.378 * sine * std::exp(-2.25 * phase);
}

double uranus(const Aspect& a) {
  return polynomial(a.phase_deg(), std::array{-7.110, 6.587e-3, 1.045e-4});
}

/// Magnitude of Neptune, which brightened from 1980 to 2000.
double neptune(const Aspect& a) { return -6.89 - 0.0055 * std::clamp(a.year - 1980, 0., 20.); }

struct Model {
  std::string_view name;
  void (*heliocentric)(double, ln_helio_posn*);
  double (*magnitude)(const Aspect&);  ///< at 1 au from both the Sun and the Earth
  double b_minus_v, radius_km;
};

constexpr std::array models{Model{"Mercury", ln_get_mercury_helio_coords, mercury, 0.93, 2440.53},
                            Model{"Venus", ln_get_venus_helio_coords, venus, 0.82, 6051.8},
                            Model{"Mars", ln_get_mars_helio_coords, mars, 1.36, 3396.19},
                            Model{"Jupiter", ln_get_jupiter_helio_coords, jupiter, 0.83, 71492},
                            Model{"Saturn", ln_get_saturn_helio_coords, saturn, 1.04, 60268},
                            Model{"Uranus", ln_get_uranus_helio_coords, uranus, 0.56, 25559},
                            Model{"Neptune", ln_get_neptune_helio_coords, neptune, 0.41, 24764}};

glm::dvec3 heliocentric_au(const Model& model, const Instant& instant) {
  ln_helio_posn place{};
  {
    const std::lock_guard lock(libnova_is_single_threaded());
    model.heliocentric(instant.tt_day + instant.tt_fraction, &place);
  }
  const double longitude = place.L * degree, latitude = place.B * degree;
  return gcrs_from_ecliptic(place.R * glm::dvec3(std::cos(latitude) * std::cos(longitude),
                                                 std::cos(latitude) * std::sin(longitude),
                                                 std::sin(latitude)));
}

Planet seen(const Model& model, const Instant& instant, const EarthMotion& earth) {
  Aspect aspect{heliocentric_au(model, instant), {}, year_of(instant)};
  aspect.from_earth_au = aspect.from_sun_au - earth.heliocentric_au;
  for (int pass = 0; pass < 2; ++pass) {  // each pass divides the error in light time by 1e4
    const Instant then = later(instant, -aspect.earth_au() * ERFA_AULT);
    const EarthMotion earth_then = earth_at(then);
    aspect.from_sun_au = heliocentric_au(model, then);
    aspect.from_earth_au = aspect.from_sun_au + earth_then.barycentric_au -
                           earth_then.heliocentric_au - earth.barycentric_au;
  }
  const double away = aspect.earth_au();
  return {model.name, aberrated(aspect.from_earth_au / away, earth) * (away * astronomical_unit_m),
          model.magnitude(aspect) + 5 * std::log10(aspect.sun_au() * away), model.b_minus_v,
          algebra::kilometres(model.radius_km)};
}

}  // namespace

std::vector<Planet> planets_at(const Instant& instant) {
  const EarthMotion earth = earth_at(instant);
  std::vector<Planet> planets;
  for (const auto& model : models) planets.push_back(seen(model, instant, earth));
  return planets;
}

}  // namespace coppermoon::almanac
