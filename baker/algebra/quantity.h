// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <compare>
#include <numbers>

namespace coppermoon::algebra {

/// A number with a dimension, so that passing a wavelength where a length is expected does not compile.
/// Values are made and read only through functions that name the unit (`kilometres(42)`, `in_metres(x)`).
template <class Dimension>
class Quantity {
 public:
  constexpr Quantity() = default;
  constexpr explicit Quantity(double in_kept_unit) : value_(in_kept_unit) {}
  constexpr double in_kept_unit() const { return value_; }
  constexpr auto operator<=>(const Quantity&) const = default;
  friend constexpr Quantity operator+(Quantity a, Quantity b) {
    return Quantity(a.value_ + b.value_);
  }
  friend constexpr Quantity operator-(Quantity a, Quantity b) {
    return Quantity(a.value_ - b.value_);
  }
  friend constexpr Quantity operator-(Quantity a) { return Quantity(-a.value_); }
  friend constexpr Quantity operator*(double s, Quantity a) { return Quantity(s * a.value_); }
  friend constexpr double operator/(Quantity a, Quantity b) { return a.value_ / b.value_; }

 private:
  double value_ = 0;
};

using Angle = Quantity<struct AngleDimension>;            ///< stored in radians
using Length = Quantity<struct LengthDimension>;          ///< stored in metres
using Wavelength = Quantity<struct WavelengthDimension>;  ///< stored in nanometres

constexpr Length metres(double x) { return Length(x); }
constexpr Length kilometres(double x) { return Length(x * 1e3); }
constexpr double in_metres(Length x) { return x.in_kept_unit(); }
constexpr double in_kilometres(Length x) { return x.in_kept_unit() / 1e3; }

constexpr Angle radians(double x) { return Angle(x); }
constexpr Angle degrees(double x) { return Angle(x * std::numbers::pi / 180); }
constexpr double in_radians(Angle x) { return x.in_kept_unit(); }
constexpr double in_degrees(Angle x) { return x.in_kept_unit() * 180 / std::numbers::pi; }
constexpr double in_arcminutes(Angle x) { return in_degrees(x) * 60; }

/// Reduces an angle to at least 0 and less than 2π. Rounding may raise a result just below 2π to 2π.
inline Angle within_circle(Angle x) {
  const Angle circle = radians(2 * std::numbers::pi);
  const Angle rest = radians(std::fmod(in_radians(x), in_radians(circle)));
  return rest < Angle() ? rest + circle : rest;
}

constexpr Wavelength nanometres(double x) { return Wavelength(x); }
constexpr double in_nanometres(Wavelength x) { return x.in_kept_unit(); }

}  // namespace coppermoon::algebra
