// SPDX-License-Identifier: MIT
// Pictures beside photographs: the hue of what is shown, and that of the light a camera of measured response records.
#include <iostream>

#include "colour/srgb.h"
#include "end_to_end/luminance.h"
#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::hue_test {

struct Moment {
  const char *when, *at;
};

using Colour = std::array<double, 3>;

/// CIE 1976 hue angle about D65 of linear Rec.709 [degrees], by the matrix of IEC 61966-2-1.
double hue_deg(const Colour& c) {
  const double X = 0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2],
               Y = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2],
               Z = 0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2], sum = X + 15 * Y + 3 * Z;
  return std::atan2(9 * Y / sum - 0.46834, 4 * X / sum - 0.19784) * 180 / std::numbers::pi;
}

/// Mean colours of the disc's brightest and darkest tenths, but for its outermost tenth, which glow and seeing blur.
struct Tenths {
  Colour brightest{}, darkest{};
};

Tenths tenths_of(const texture::Image& image) {
  constexpr double radius_deg = 0.22, field_deg = 0.7;
  const double middle = static_cast<double>(image.width) / 2,
               radius = middle * radius_deg / (field_deg / 2);
  std::vector<std::pair<double, Colour>> disc;
  for (std::size_t r = 0; r < image.height; ++r)
    for (std::size_t c = 0; c < image.width; ++c)
      if (std::hypot(static_cast<double>(c) + 0.5 - middle, static_cast<double>(r) + 0.5 - middle) <
          radius)
        disc.push_back(
            {luminance(image, r, c), Colour{image(r, c, 0), image(r, c, 1), image(r, c, 2)}});
  std::ranges::sort(disc, {}, &std::pair<double, Colour>::first);
  const std::size_t tenth = disc.size() / 10;
  Tenths tenths;
  for (std::size_t i = 0; i < tenth; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      tenths.darkest[k] += disc[i].second[k] / static_cast<double>(tenth);
      tenths.brightest[k] += disc[disc.size() - 1 - i].second[k] / static_cast<double>(tenth);
    }
  return tenths;
}

class Hue : public ProgramTest {
 protected:
  Tenths shown(const Moment& moment) const {
    run(moment, "--bits 16");
    auto picture = texture::read_image(here("moon.png"));
    for (float& value : picture.values) value = static_cast<float>(colour::srgb_light(value));
    return tenths_of(picture);
  }

  Tenths photographed(const Moment& moment) const {
    run(moment,
        "--camera 400mm --response canon-eos-5d-mark-ii --noise off --photograph photograph.exr");
    return tenths_of(texture::read_image(here("photograph.exr")));
  }

  void expect_alike(const Moment& moment) const {
    const auto picture = shown(moment), photograph = photographed(moment);
    std::cout << moment.when << ": hue beside the photograph's "
              << hue_deg(picture.brightest) - hue_deg(photograph.brightest) << " and "
              << hue_deg(picture.darkest) - hue_deg(photograph.darkest) << " degrees\n";
    EXPECT_WITHIN(hue_deg(picture.brightest), hue_deg(photograph.brightest), 8, "asked for")
        << moment.when;
    if (std::ranges::max(picture.darkest) < black) return;
    EXPECT_WITHIN(hue_deg(picture.darkest), hue_deg(photograph.darkest), 8, "asked for")
        << moment.when;
  }

 private:
  static constexpr double black = 1 / 255. / 12.92;  ///< the first step of 8 bits

  void run(const Moment& moment, const Words& more) const {
    const auto made = coppermoon(
        words_of("still {} --at {} --width 48 --height 48 --field 0.7 --texture-width 64 "
                 "--sky off --stars off --quality draft -o moon.png",
                 moment.when, moment.at) +
        more);
    EXPECT_EQ(made.status, 0) << made.err;  // which names the moment of a contact
  }
};

TEST_F(Hue, IsThatOfAPhotograph) { expect_alike({"2025-09-07T18:11Z", "Berlin"}); }

class HueThoroughly : public Hue {};

TEST_F(HueThoroughly, IsThatOfPhotographsOfSixEclipses) {
  for (const auto& moment : {Moment{"2015-09-28 U2+3min", "Nantes"},
                             {"2015-09-28", "Nantes"},
                             {"2018-07-27 U1+50min", "Nairobi"},
                             {"2018-07-27 U3-5min", "Nairobi"},
                             {"2022-05-16 U2+10min", "Miami"},
                             {"2022-05-16", "Miami"},
                             {"2025-03-14", "Chicago"},
                             {"2025-03-14 U3+20min", "Chicago"},
                             {"2025-09-07T18:30Z", "Berlin"},
                             {"2025-09-07 U2+5min", "Delhi"},
                             {"2026-03-03", "Honolulu"},
                             {"2026-03-03 U1+30min", "Honolulu"}})
    expect_alike(moment);
}

}  // namespace coppermoon::end_to_end::hue_test
