// SPDX-License-Identifier: MIT
#include "algebra/quantity.h"

#include <type_traits>

#include "support/testing.h"

namespace coppermoon::algebra::quantity_test {

template <class A, class B>
concept Addable = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept Comparable = requires(A a, B b) {
  a < b;
};

// What must not compile: one quantity for another, a bare number for any, sums across dimensions.
static_assert(!std::is_convertible_v<Wavelength, Length>);
static_assert(!std::is_convertible_v<Length, Wavelength>);
static_assert(!std::is_convertible_v<Angle, Length>);
static_assert(!std::is_constructible_v<Length, Wavelength>);
static_assert(!std::is_assignable_v<Length&, Wavelength>);
static_assert(!std::is_convertible_v<double, Length>);
static_assert(!std::is_convertible_v<Length, double>);
static_assert(Addable<Length, Length> && !Addable<Length, Wavelength> && !Addable<Length, double>);
static_assert(Comparable<Length, Length> && !Comparable<Length, Wavelength>);

TEST(Quantity, IsReadInTheUnitItWasMadeIn) {
  EXPECT_EQ(in_kilometres(kilometres(42)), 42);
  EXPECT_EQ(in_metres(metres(7)), 7);
  EXPECT_EQ(in_nanometres(nanometres(550)), 550);
  EXPECT_EQ(in_radians(radians(0.25)), 0.25);
  EXPECT_WITHIN(in_degrees(degrees(33)), 33.0, 1e-14, "rounding");
}

TEST(Quantity, ConvertsBetweenUnits) {
  EXPECT_EQ(in_metres(kilometres(42)), 42000);
  EXPECT_WITHIN(in_radians(degrees(180)), std::numbers::pi, 1e-15, "rounding");
  EXPECT_WITHIN(in_degrees(radians(1)), 57.29577951308232, 1e-13, "printed to 16 digits");
  EXPECT_WITHIN(in_arcminutes(degrees(1.5)), 90.0, 1e-13, "rounding");
}

TEST(Quantity, AddsScalesAndCompares) {
  EXPECT_EQ(kilometres(1) + metres(500), metres(1500));
  EXPECT_EQ(kilometres(1) - metres(1500), -metres(500));
  EXPECT_EQ(3 * metres(2), metres(6));
  EXPECT_EQ(kilometres(1) / metres(250), 4);
  EXPECT_LT(metres(999), kilometres(1));
  EXPECT_EQ(Length{}, metres(0));
}

TEST(Quantity, OfADirectionIsAnAngleWithinACircle) {
  constexpr double circle = 2 * std::numbers::pi;
  for (const double angle : {0.1, 1., 3.5, 6.2}) {
    EXPECT_EQ(in_radians(within_circle(radians(angle))), angle);
    for (const double circles : {-2., -1., 1., 3.})
      EXPECT_WITHIN(in_radians(within_circle(radians(angle + circles * circle))), angle, 1e-14,
                    "rounding of three circles");
  }
}

}  // namespace coppermoon::algebra::quantity_test
