// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "atmosphere/atmosphere.h"

namespace coppermoon::photons {

/// Half-line in the shadow frame: origin [m] and unit direction.
struct Ray {
  glm::dvec3 position_m, direction;
};

/// Step lengths of tracing.
struct Stepping {
  double step_m = 1000;         ///< arc length of one step, 1 to 100 000 m
  double gradient_step_m = 10;  ///< step of the forward differences for ∇n, 1e-3 to 1e4 m
};

/// Result of tracing a ray that has left the air again.
struct Traced {
  Ray leaving;
  double transmittance;  ///< due to dust and Rayleigh scattering along the path, and ozone
  int steps;
};

/// Moves a ray to its first intersection with a sphere about the Earth's centre; returns nothing if it misses.
///
/// Given  ray  one that starts outside the sphere
std::optional<Ray> entered(const Ray& ray, double radius_m);

/// Traces light through the air in three dimensions, step by step, exactly as Yapo & Cutler (2009) do. Each step
/// advances along the current direction, turns by the gradient of refractivity, and attenuates by Beer–Lambert;
/// gradient and extinction are taken at the beginning of the step.
///
///     x' = x + t Δl      t' = (n(x) t + ∇n(x) Δl) / n(x')      I' = I exp(−(α + β(x)) Δl)
///
/// with ∇n by forward differences over 10 m, axis by axis. Scalar, one wavelength, any atmosphere: a reference for
/// the faster methods. (Turning before advancing would halve the step's error; the paper's figures need this
/// order.)
///
/// Given     entering  ray at the top of the air, directed inwards
///           chance    0 to 1: chooses one of the two belts between which the ray lies
/// Returned  nothing if the ray met the ground, or passed above the air over an ellipsoid's pole
/// Accuracy  with steps of 1 km, bending is too small by 0.14 % for a ray that grazes at 876 m, by 0.11 % at 3791 m;
///           0.06 % is due to the forward difference and stays as the step shrinks
/// Throws    Error  when a step is outside its range, or the air traps light
///                  (atmosphere::critical_refractivity)
/// Source    Yapo & Cutler (2009), Eq. 1 to 3, 11 and 12, after Seron et al. (2004)
std::optional<Traced> trace(const Ray& entering, const atmosphere::Atmosphere& atmosphere,
                            const atmosphere::Optics& optics, const Stepping& stepping,
                            double chance = 0);

}  // namespace coppermoon::photons
