// SPDX-License-Identifier: MIT
// Exposures of whole films, from dusk to dawn, over the Earth: pictures are neither white nor plain.
#include <iostream>

#include "support/exposed.h"
#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::sky_exposure_test {

namespace fs = std::filesystem;

class SkyExposure : public ProgramTest {
 protected:
  /// Whether a place sees a film; each of its pictures is looked at, from moonrise or P1 to moonset or P4.
  bool is_well_exposed(const std::string& date, const std::string& place, const Words& more = {}) {
    fs::remove_all(here("film"));
    const auto made = coppermoon(
        words_of(
            "animate {} --at {} --from moonrise --to moonset --frames 8 --width 48 --height 36 "
            "--quality draft --texture-width 64 --stars off --make frames,pictures -o film",
            date, place) +
        more);
    if (made.status != 0) return false;
    said_ = made.err;
    for (const auto& entry : fs::directory_iterator(here("film"))) {
      if (entry.path().extension() != ".png") continue;
      const auto number = entry.path().stem().extension().string();  // ".0001"
      const auto picture = texture::read_image(entry.path()),
                 frame = texture::read_image(here("film/frame_lin_rec709" + number + ".exr"));
      const double white = testing_support::white_share(picture),
                   allowed = testing_support::contrast_allowed(frame);
      EXPECT_LE(white, 0.02) << place << ", " << entry.path();
      whitest_ = std::max(whitest_, white);
      if (allowed < 0.02) continue;  // a Moon that the sky outshines fiftyfold
      const double contrast = testing_support::contrast(picture);
      EXPECT_GT(contrast, 0.2 * allowed) << place << ", " << entry.path();
      plainest_ = std::min(plainest_, contrast / allowed);
    }
    std::cout << place << ": so far " << 100 * whitest_ << " % white at most; contrast at least "
              << plainest_ << " of what the light allows\n";
    return true;
  }

  std::string said_;  ///< about the last film, on standard error

 private:
  double whitest_ = 0, plainest_ = 1;
};

TEST_F(SkyExposure, OfFilmsFromDuskAndToDawnIsTheirSkysToo) {
  EXPECT_TRUE(is_well_exposed("2025-09-07", "Sydney", "--camera 400mm"));
  EXPECT_TRUE(is_well_exposed("2025-09-07", "Berlin"));
  EXPECT_SAYS(said_, "the Moon cannot be seen in its sky; it can from 2025-09-07T18:");
}

class SkyExposureThoroughly : public SkyExposure {};

TEST_F(SkyExposureThoroughly, OfFilmsFromAllOverTheEarth) {
  EXPECT_TRUE(is_well_exposed("2025-09-07", "Sydney", "--time composite"));
  EXPECT_TRUE(is_well_exposed("2025-09-07", "Berlin", "--camera 400mm"));
  EXPECT_TRUE(is_well_exposed("2026-03-03", "Tokyo", "--time auto"));
  std::mt19937 random(65);
  const char* dates[] = {"2018-07-27", "2022-05-16", "2025-03-14",
                         "2025-09-07", "2026-03-03", "2028-12-31"};
  int places = 0;
  for (int drawn = 0; places < 24 && drawn < 100; ++drawn) {
    const auto part = [&] { return static_cast<double>(random()) / 4294967296.; };
    const double latitude = std::asin(1.8 * part() - 0.9) * 180 / std::numbers::pi,
                 longitude = 360 * part() - 180;
    places += is_well_exposed(dates[drawn % 6],
                              std::to_string(latitude) + "," + std::to_string(longitude));
  }
  EXPECT_EQ(places, 24);
}

}  // namespace coppermoon::end_to_end::sky_exposure_test
