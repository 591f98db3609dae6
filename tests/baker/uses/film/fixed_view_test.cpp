// SPDX-License-Identifier: MIT
#include "uses/film/film_setup.h"

#include "support/testing.h"

namespace coppermoon::uses::fixed_view_test {

/// Film of the eclipse of 2018 July 27 on a tripod in Nairobi, which points at the Moon half way.
Film on_a_tripod(const char* from, const char* to, double field_deg) {
  using almanac::instant_from_utc;
  Film film;
  film.moments = moments_of({.eclipse = eclipse::nearest_eclipse(instant_from_utc("2018-07-27"),
                                                                 eclipse::ShadowConvention::danjon),
                             .from = instant_from_utc(from),
                             .to = instant_from_utc(to),
                             .frames = 10});
  film.view.observer = almanac::Observer{algebra::degrees(-1.29), algebra::degrees(36.82), {}};
  film.view.field_deg = field_deg;
  film.view.width = 300, film.view.height = 200;
  film.view.aim = apparent_place(*film.view.observer, film.sky(5));
  return film;
}

Film seen(Film film, const FixedView& view) {
  film.view.aim = view.aim;
  film.view.field_deg = view.field_deg;
  return film;
}

/// Moons whose middle is in the picture of the renderer's camera.
std::size_t rendered_within(const Film& film) {
  std::size_t within = 0;
  for (std::size_t frame = 1; frame <= 10; ++frame) {
    const auto camera = view_of(film, film.sky(frame)).camera;
    const auto& p = camera.position;
    const auto pixel =
        povray_scenes::pixel_of(camera, {algebra::radians(std::atan2(p.z, std::hypot(p.x, p.y))),
                                         algebra::radians(std::atan2(p.y, p.x))});
    if (pixel && pixel->x > 0 && pixel->x < 300 && pixel->y > 0 && pixel->y < 200) ++within;
  }
  return within;
}

TEST(FixedView, HoldsTheMoonsOfAShortFilm) {
  const auto view = fixed_view(on_a_tripod("2018-07-27T20:00:00Z", "2018-07-27T21:00:00Z", 22));
  EXPECT_EQ(view.outside, 0U);
  EXPECT_EQ(view.looked_at, 10U);
}

TEST(FixedView, OfALongFilmCountsMoonsOutsideAndSaysWhatHoldsThem) {
  const auto film = on_a_tripod("2018-07-27T18:24:00Z", "2018-07-27T22:19:00Z", 22);
  const auto view = fixed_view(film);
  // 15 degrees an hour: within 11 degrees of the middle for three quarters of an hour on each side, of 26 minutes a frame
  EXPECT_GE(view.outside, 6U);
  EXPECT_LE(view.outside, 8U);
  EXPECT_EQ(rendered_within(film), 10 - view.outside);
  ASSERT_TRUE(view.aim);
  EXPECT_EQ(fixed_view(seen(film, view)).outside, 0U);
  EXPECT_EQ(rendered_within(seen(film, view)), 10U);
  auto narrower = seen(film, view);
  *narrower.view.field_deg -= 2;
  EXPECT_GT(fixed_view(narrower).outside, 0U);
}

TEST(FixedView, KeepsTheFieldWhereAnotherAimIsEnough) {
  auto film = on_a_tripod("2018-07-27T20:00:00Z", "2018-07-27T21:00:00Z", 22);
  film.view.aim->azimuth = film.view.aim->azimuth + algebra::degrees(180);
  const auto view = fixed_view(film);
  EXPECT_EQ(view.outside, 10U);
  ASSERT_TRUE(view.aim);
  EXPECT_WITHIN(view.field_deg, 22, 1e-9, "degrees: rounding");
  EXPECT_EQ(fixed_view(seen(film, view)).outside, 0U);
}

}  // namespace coppermoon::uses::fixed_view_test
