// SPDX-License-Identifier: MIT
#include "uses/picture/development.h"

#include <glm/matrix.hpp>
#include <iostream>

#include "colour/camera.h"
#include "support/exposed.h"
#include "support/testing.h"
#include "uses/picture/picture_parameters.h"

namespace coppermoon::uses::development_test {

constexpr auto space = colour::WorkingSpace::linear_rec709;

texture::Image image_of(const std::vector<std::array<float, 3>>& colours) {
  texture::Image image(colours.size(), 1, {"R", "G", "B"});
  for (std::size_t i = 0; i < colours.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) image.values[3 * i + c] = colours[i][c];
  return image;
}

/// Grey lit ground of a partial eclipse, in two tones, and copper shadow for a share of the disc.
texture::Image partial_eclipse(std::size_t lit, std::size_t shadow) {
  std::vector<std::array<float, 3>> colours;
  for (std::size_t i = 0; i < lit; ++i) {
    const float grey = i % 2 == 0 ? 2000.F : 4000.F;
    colours.push_back({grey, grey, grey});
  }
  for (std::size_t i = 0; i < shadow; ++i) colours.push_back({0.04F, 0.01F, 0.003F});
  return image_of(colours);
}

Development two_exposures() {
  Development development;
  development.time.rule = ExposureTime::Rule::composite;
  return development;
}

texture::Image picture_of(const Development& development, const texture::Image& frame) {
  return developed(development, exposures_for(development, frame, space), {frame, space});
}

/// IEC 61966-2-1, backwards.
double linear(float coded) {
  return coded <= 0.04045F ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

TEST(Composite, ShowsGroundInSunlightAndInShadow) {
  for (const std::size_t shadow : {20U, 50U, 90U}) {
    const auto frame = partial_eclipse(100 - shadow, shadow);
    const auto picture = picture_of(two_exposures(), frame);
    EXPECT_GT(linear(picture.values[3]), 0.6);
    EXPECT_LT(picture.values[3], 0.98F) << "not clipped";
    EXPECT_GT(picture.values[3] - picture.values[0], 0.1F) << "seas stay darker than highlands";
    const float* dark = &picture.values[3 * 99];
    EXPECT_GT(dark[0], 0.2F) << "of 1, coded: well seen";
    EXPECT_LT(dark[0], picture.values[0]);
    EXPECT_WITHIN_RELATIVE(linear(dark[0]) / linear(dark[1]), 4., 2e-3,
                           "the curve in float, where it is steep: the shadow keeps its colour");
    const auto once = picture_of({}, frame);
    EXPECT_LT(once.values[3 * 99], 1.F / 255) << "auto leaves the shadow black";
  }
}

TEST(Composite, ShowsWhatIsBrighterBrighter) {
  std::vector<std::array<float, 3>> ramp;
  for (double y = 1e-5; y < 1e4; y *= 1.02)
    ramp.push_back({static_cast<float>(y), static_cast<float>(y), static_cast<float>(y)});
  const auto frame = image_of(ramp);
  const auto exposures = exposures_for(two_exposures(), frame, space);
  ASSERT_GT(*exposures.longer_s / exposures.shorter.time_s, 1e3);
  const auto picture = developed(two_exposures(), exposures, {frame, space});
  for (std::size_t i = 1; i < ramp.size(); ++i) {
    const float before = picture.values[3 * (i - 1)], after = picture.values[3 * i];
    EXPECT_GE(after, before) << i;
    EXPECT_LT(after - before, 0.012F) << "a step of 2 % in light is no edge; alone it is 0.009";
  }
  EXPECT_LT(picture.values[0], 0.1F);
  EXPECT_GT(picture.values.back(), 0.85F);
}

TEST(Composite, IsOneExposureWhereAllIsAlike) {
  const auto frame = image_of(std::vector<std::array<float, 3>>(100, {3000, 3000, 3000}));
  const auto exposures = exposures_for(two_exposures(), frame, space);
  EXPECT_WITHIN_RELATIVE(*exposures.longer_s, exposures.shorter.time_s, 1e-12, "sums");
  const double value = linear(developed(two_exposures(), exposures, {frame, space}).values[0]);
  EXPECT_WITHIN(value, 0.7 * 0.6 + 0.3 * (1 - std::exp(-0.6)), 1e-4,
                "float pixels: level of the shorter exposure in both");
}

TEST(Exposures, AreThoseOfTheMoonAlone) {
  const DiscOutline disc{5, 5, 1. / 16, 0, 1. / 16};  // a radius of 4 pixels
  texture::Image moon(20, 10, {"R", "G", "B"});
  for (std::size_t r = 3; r < 7; ++r)
    for (std::size_t c = 3; c < 7; ++c)
      for (std::size_t k = 0; k < 3; ++k) moon(r, c, k) = 0.01F * static_cast<float>(1 + r + c);
  auto starry = moon;
  for (std::size_t k = 0; k < 3; ++k) {
    starry(2, 15, k) = 1e3F;
    starry(8, 18, k) = 1e-9F;
  }
  for (const auto rule :
       {ExposureTime::Rule::automatic, ExposureTime::Rule::follow, ExposureTime::Rule::composite}) {
    Development development;
    development.time.rule = rule;
    const auto alone = exposures_for(development, moon, space, {.disc = disc}),
               among_stars = exposures_for(development, starry, space, {.disc = disc});
    EXPECT_EQ(among_stars.shorter.time_s, alone.shorter.time_s);
    EXPECT_EQ(among_stars.longer_s, alone.longer_s);
    EXPECT_EQ(alone.shorter.time_s, exposures_for(development, moon, space).shorter.time_s);
    SharedExposure shared(development);
    shared.add(starry, space, {.disc = disc});
    EXPECT_WITHIN_RELATIVE(shared.exposures().shorter.time_s, alone.shorter.time_s, 5e-4,
                           "levels are counted in steps of 2^-11");
  }
}

TEST(Exposures, AreOfTheBrightestChannelInAnySpace) {
  std::vector<std::array<float, 3>> copper;
  for (int i = 1; i <= 200; ++i) {
    const auto light = 1e-3F * static_cast<float>(i);
    copper.push_back({light, light / 8, light / 60});
  }
  const auto frame = image_of(copper);
  const auto exposures = exposures_for({}, frame, space);
  EXPECT_WITHIN_RELATIVE(0.199 * scale_of({}, exposures.shorter), 0.8, 1e-6,
                         "floats: red of the brightest 1 %, though luminance is a third of it");
  auto in_acescg = frame;
  const auto matrix = colour::channels_from_xyz(colour::WorkingSpace::acescg) *
                      glm::inverse(colour::channels_from_xyz(space));
  for (std::size_t i = 0; i < copper.size(); ++i) {
    const auto c = matrix * glm::dvec3(copper[i][0], copper[i][1], copper[i][2]);
    for (std::size_t k = 0; k < 3; ++k)
      in_acescg.values[3 * i + k] = static_cast<float>(c[static_cast<int>(k)]);
  }
  EXPECT_WITHIN_RELATIVE(exposures_for({}, in_acescg, colour::WorkingSpace::acescg).shorter.time_s,
                         exposures.shorter.time_s, 1e-6, "floats");
}

Development through(const std::string& camera, ExposureTime::Rule rule) {
  Development development;
  development.time.rule = rule;
  development.camera.model = camera;
  return development;
}

TEST(Exposures, CountTheSkyThatAFrameHolds) {
  const auto frame = image_of(std::vector<std::array<float, 3>>(100, {602, 602, 602}));
  const SeenFrame seen{.pixel_rad = 1e-5, .sky_cd_m2 = 600};
  EXPECT_EQ(sky_over_moon(frame, space, {.pixel_rad = 1e-5}), 0) << "no sky";
  EXPECT_WITHIN_RELATIVE(sky_over_moon(frame, space, seen), 300, 1e-6, "floats");
  for (const auto rule : {ExposureTime::Rule::automatic, ExposureTime::Rule::follow}) {
    const auto camera = through("400mm", rule);
    // auto shows a sky of a day no brighter than 0.4
    const double level = rule == ExposureTime::Rule::automatic ? 0.4 * 602 / 600 : 0.25;
    const auto exposures = exposures_for(camera, frame, space, seen);
    EXPECT_WITHIN_RELATIVE(602 * scale_of(camera, exposures.shorter), level, 1e-6, "floats");
    SharedExposure shared(camera);
    shared.add(frame, space, seen);
    EXPECT_WITHIN_RELATIVE(shared.exposures().shorter.time_s, exposures.shorter.time_s, 5e-4,
                           "levels are counted in steps of 2^-11");
  }
}

/// Frame of a Moon of which a share is sunlit and the rest copper, before and behind a blue sky [cd/m²].
texture::Image moon_in_sky(const DiscOutline& disc, double sunlit, double umbra, double sky) {
  texture::Image frame(32, 24, {"R", "G", "B"});
  const double copper[] = {2.9, 0.5, 0.1}, sun[] = {1.2, 0.97, 0.7}, blue[] = {0.8, 1, 1.5};
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c) {
      const double x = static_cast<double>(c) + 0.5, y = static_cast<double>(r) + 0.5;
      const bool lit = (x - disc.x) / 8 > 1 - 2 * sunlit;
      for (std::size_t k = 0; k < 3; ++k)
        frame(r, c, k) = static_cast<float>(
            sky * blue[k] +
            covered_share(disc, x, y) * (lit ? 2000 * sun[k] * (1 + y / 48) : umbra * copper[k]));
    }
  return frame;
}

TEST(Exposures, ShowMoonAndSkyWithoutWhite) {
  using enum ExposureTime::Rule;
  const DiscOutline disc{16, 12, 1 / 64., 0, 1 / 64.};
  double whitest = 0, plainest = 1;
  for (const auto& [model, rule] :
       {std::pair("", automatic), {"", composite}, {"400mm", composite}})
    for (const double sky : {0., 3e-4, 3e-3, 0.03, 0.3, 3., 30., 300., 3000.})
      for (const double umbra : {0.002, 0.02, 0.2})
        for (const double sunlit : {0., 0.02, 0.1, 0.5, 1.}) {
          if (*model && umbra != 0.02) continue;  // a photograph takes time
          const auto frame = moon_in_sky(disc, sunlit, umbra, sky);
          const SeenFrame seen{.pixel_rad = 1.8e-4, .sky_cd_m2 = sky, .disc = disc};
          const auto development = through(model, rule);
          const auto picture = developed(
              development, exposures_for(development, frame, space, seen), {frame, space, seen});
          const double allowed = testing_support::contrast_allowed(frame);
          whitest = std::max(whitest, testing_support::white_share(picture));
          EXPECT_LE(testing_support::white_share(picture), 0.02)
              << model << ", sky " << sky << ", umbra " << umbra << ", sunlit " << sunlit;
          if (allowed < 0.02) continue;  // a Moon that the sky outshines fiftyfold
          plainest = std::min(plainest, testing_support::contrast(picture) / allowed);
          EXPECT_GT(testing_support::contrast(picture), 0.2 * allowed)
              << model << ", sky " << sky << ", umbra " << umbra << ", sunlit " << sunlit;
        }
  std::cout << "at most " << 100 * whitest << " % white; contrast at least " << plainest
            << " of what the light allows\n";
}

TEST(Exposures, OfAHiddenMoonAreOfTheSkyAsItIs) {
  const texture::Image black(8, 8, {"R", "G", "B"});
  double before = 1;
  for (const double sky : {1000., 10., 1., 0.1, 0.01, 3e-4}) {
    const SeenFrame seen{.sky_cd_m2 = sky};
    for (const auto rule : {ExposureTime::Rule::automatic, ExposureTime::Rule::composite}) {
      const auto development = through("", rule);
      const auto exposures = exposures_for(development, black, space, seen);
      EXPECT_FALSE(exposures.longer_s);
      const double level = sky * scale_of(development, exposures.shorter);
      EXPECT_LE(level, before + 1e-9) << "a darker sky is shown darker";
      EXPECT_WITHIN(level, 0.25, 0.15 + 1e-9, "0.1 of white at night, 0.4 of a day");
      if (rule == ExposureTime::Rule::composite) before = level;
    }
  }
}

/// Light of a copper shadow on the left that grows to sunlight on the right, on a disc.
texture::Image warm_partial_eclipse(const DiscOutline& disc) {
  texture::Image frame(96, 64, {"R", "G", "B"});
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c) {
      const double share = covered_share(disc, static_cast<double>(c) + 0.5,
                                         static_cast<double>(r) + 0.5),
                   decades = std::clamp((60. - static_cast<double>(c)) / 24, 0., 1.) * 5;
      const double red[] = {1.4 + 0.2 * decades, 0.9, 0.5};
      for (std::size_t k = 0; k < 3; ++k)
        frame(r, c, k) = static_cast<float>(share * 3000 * std::pow(10, -decades) * red[k]);
    }
  return frame;
}

TEST(Developed, EdgeOfTheMoonGoesOverIntoTheSkyItStandsIn) {
  const DiscOutline disc{48.3, 31.8, 1 / 625., 0, 1 / 625.};
  texture::Image frame(96, 64, {"R", "G", "B"});
  for (const double ground : {0., 2., 1e4}) {  // beside the sky's light, of 1
    for (std::size_t r = 0; r < frame.height; ++r)
      for (std::size_t c = 0; c < frame.width; ++c)
        for (std::size_t k = 0; k < 3; ++k)
          frame(r, c, k) =
              static_cast<float>(1 + ground * covered_share(disc, static_cast<double>(c) + 0.5,
                                                            static_cast<double>(r) + 0.5));
    Development development;
    development.time = {ExposureTime::Rule::fixed, 60};
    const auto picture = developed(development, exposures_for(development, frame, space),
                                   {frame, space, {.sky_cd_m2 = 1, .disc = disc}});
    const float sky = picture(0, 0, 0), moon = picture(32, 48, 0);
    EXPECT_GT(sky, 0.1F);
    if (ground == 0) {
      EXPECT_EQ(sky, moon) << "a Moon without light does not show";
    }
    for (const float value : picture.values) {
      EXPECT_GE(value, sky - 1e-6F);
      EXPECT_LE(value, moon + 1e-6F);
    }
    for (const auto rule : {ExposureTime::Rule::composite}) {
      development.time.rule = rule;
      const SeenFrame seen{.pixel_rad = 1e-4, .sky_cd_m2 = 1, .disc = disc};
      const auto both = developed(development, exposures_for(development, frame, space, seen),
                                  {frame, space, seen});
      for (const float value : both.values) EXPECT_GE(value, both(0, 0, 0) - 1e-6F);
    }
  }
}

TEST(Composite, ThroughACameraShowsWhatItShowsWithoutOne) {
  const DiscOutline disc{48.3, 31.8, 1 / 625., 0, 1 / 625.};  // a radius of 25 pixels
  const auto frame = warm_partial_eclipse(disc);
  const SeenFrame seen{.pixel_rad = 1.8e-4, .disc = disc};
  const auto shown = [&](const Development& development) {
    return developed(development, exposures_for(development, frame, space, seen),
                     {frame, space, seen});
  };
  const auto at_limb = [&](std::size_t r, std::size_t c) {
    return std::abs(std::hypot(static_cast<double>(c) + 0.5 - disc.x,
                               static_cast<double>(r) + 0.5 - disc.y) -
                    25) < 2;
  };
  const auto without = shown(two_exposures());
  for (const auto& name : colour::camera_names()) {
    const auto with = shown(through(name, ExposureTime::Rule::composite));
    for (std::size_t r = 0; r < frame.height; ++r)
      for (std::size_t c = 0; c < frame.width; ++c)
        for (std::size_t k = 0; k < 3 && !at_limb(r, c); ++k)
          EXPECT_WITHIN(linear(with(r, c, k)), linear(without(r, c, k)), 0.05,
                        "of white: glow of a twentieth in each, blur of a pixel, noise")
              << name << ": " << r << ", " << c << ", " << k;
  }
}

TEST(Composite, OfASetIsTheSameForAll) {
  const auto early = partial_eclipse(80, 20), late = partial_eclipse(20, 80);
  SharedExposure one(two_exposures()), both(two_exposures());
  one.add(early, space);
  const auto alone = exposures_for(two_exposures(), early, space);
  EXPECT_DOUBLE_EQ(one.exposures().shorter.time_s, alone.shorter.time_s);
  EXPECT_DOUBLE_EQ(*one.exposures().longer_s, *alone.longer_s);
  both.add(early, space);
  both.add(late, space);
  const auto half = exposures_for(two_exposures(), partial_eclipse(100, 100), space);
  EXPECT_WITHIN_RELATIVE(both.exposures().shorter.time_s, half.shorter.time_s, 1e-12,
                         "sums in another order");
  EXPECT_WITHIN_RELATIVE(*both.exposures().longer_s, *half.longer_s, 1e-12,
                         "sums in another order");
}

TEST(Composite, LastsASecondWhenNothingIsLit) {
  const auto exposures =
      exposures_for(two_exposures(), texture::Image(4, 4, {"R", "G", "B"}), space);
  EXPECT_EQ(exposures.shorter.time_s, 1);
  EXPECT_FALSE(exposures.longer_s);
}

TEST(Composite, WritesBothTimes) {
  texture::Attributes header;
  add_exposure(header, {{0.002, 8, 400}, 4});
  EXPECT_EQ(header.at("expTime"), texture::Attribute(0.002F));
  EXPECT_EQ(header.at("coppermoon:longer_exposure_s"), texture::Attribute(4.F));
}

TEST(Composite, IsNoRawFile) {
  auto development = two_exposures();
  development.camera.model = "400mm";
  EXPECT_NO_THROW(require_sound(development, "moon.png"));
  development.camera.raw = "moon.tif";
  EXPECT_THROW(require_sound(development, "moon.png"), algebra::Error);
}

/// A disc of one light, its edge as a renderer averages it.
texture::Image disc_of(const DiscOutline& disc, float light) {
  texture::Image frame(64, 64, {"R", "G", "B"});
  for (std::size_t r = 0; r < 64; ++r)
    for (std::size_t c = 0; c < 64; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        frame(r, c, k) =
            light * static_cast<float>(covered_share(disc, static_cast<double>(c) + 0.5,
                                                     static_cast<double>(r) + 0.5));
  return frame;
}

/// Light that a disc's picture shows, over that of its middle, pixel by pixel.
std::vector<double> edge_shown(const Development& development, const DiscOutline& disc,
                               float light) {
  const auto frame = disc_of(disc, light);
  const auto picture = developed(development, {{1, 8, 100}},
                                 {.light = frame, .space = space, .seen = {.disc = disc}});
  const double middle = linear(picture(32, 32, 1));
  std::vector<double> edge;
  for (std::size_t c = 0; c < 64; ++c) edge.push_back(linear(picture(20, c, 1)) / middle);
  return edge;
}

TEST(Limb, OfClippedLightIsAsSmoothAsOfLightThatIsNot) {
  const DiscOutline disc{32.3, 31.8, 1 / 400., 0, 1 / 400.};
  const float white = 1 / static_cast<float>(scale_of({}, {1, 8, 100}));
  const auto dim = edge_shown({}, disc, white / 2);
  for (const float light : {white, 8 * white, 1000 * white}) {
    const auto edge = edge_shown({}, disc, light);
    for (std::size_t c = 0; c < 64; ++c)
      EXPECT_WITHIN(edge[c], dim[c], 1e-3, "the curve in float, where it is steep");
  }
  EXPECT_GT(std::ranges::count_if(dim, [](double x) { return x > 0.02 && x < 0.98; }), 1)
      << "there is an edge";
}

TEST(Limb, OfAFrameWhoseEdgeIsNotKnownOrThroughACameraStaysAsItIs) {
  const DiscOutline disc{32.3, 31.8, 1 / 400., 0, 1 / 400.};
  const auto frame = disc_of(disc, 1000);
  const auto shown_of = [&](const Development& development,
                            const std::optional<DiscOutline>& edge) {
    return developed(development, {{1, 8, 100}},
                     {.light = frame, .space = space, .seen = {.pixel_rad = 1e-5, .disc = edge}})
        .values;
  };
  Development through_camera;
  through_camera.camera.model = "400mm";
  EXPECT_EQ(shown_of(through_camera, disc), shown_of(through_camera, {}));
  EXPECT_NE(shown_of({}, disc), shown_of({}, {}));
}

/// More rows than are in memory at a time, the dark part without light.
texture::Image of_many_luminances() {
  texture::Image image(40, 150, {"R", "G", "B"});
  for (std::size_t i = 3 * 40 * 20; i < image.values.size(); ++i)
    image.values[i] = std::pow(10.F, -2 + 6 * static_cast<float>(i * 7919 % 9973) / 9973);
  return image;
}

TEST(Textures, AreExposedAndDevelopedAsFramesAre) {
  const auto image = of_many_luminances();
  const LitTexture texture{
      {image.width, image.height, image.channels}, texture::rows_of(image), space};
  using enum ExposureTime::Rule;
  for (const auto rule : {automatic, follow, composite, fixed}) {
    Development development;
    development.time.rule = rule;
    const auto exposures = exposures_for(development, texture);
    const auto of_frame = exposures_for(development, image, space);
    EXPECT_EQ(exposures.shorter.time_s, of_frame.shorter.time_s);
    EXPECT_EQ(exposures.longer_s, of_frame.longer_s);
    const auto whole = developed(development, exposures, {image, space});
    texture::Image by_rows(image.width, image.height, image.channels);
    const auto rows = developed_rows(development, exposures, texture);
    const std::size_t half = 40 * 3 * 75;
    rows(0, std::span(by_rows.values).first(half));
    rows(75, std::span(by_rows.values).subspan(half));
    EXPECT_EQ(by_rows.values, whole.values);
  }
  EXPECT_EQ(
      exposures_for(
          {}, LitTexture{{1, 1, {"R", "G", "B"}}, [](std::size_t, std::span<float>) {}, space})
          .shorter.time_s,
      1)
      << "where nothing is lit";
}

TEST(ExposureSeconds, AreNumbersAndFractions) {
  EXPECT_EQ(exposure_seconds("4"), 4);
  EXPECT_EQ(exposure_seconds("1/8"), 0.125);
  EXPECT_EQ(exposure_seconds("0.3/2"), 0.15);
  for (const char* none : {"1/0", "1/-2", "/2", "1/", "1/2/3", "a/2", ""})
    EXPECT_FALSE(exposure_seconds(none)) << none;
}

}  // namespace coppermoon::uses::development_test
