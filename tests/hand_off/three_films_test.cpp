// SPDX-License-Identifier: MIT
// One eclipse as a film three ways: a texture for each frame, Blender's node group, and POV-Ray's clock. Prints lines of a
// table: seconds, bytes, difference.
#include <chrono>
#include <cmath>

#include "hand_off/agreement.h"
#include "hand_off/blender.h"
#include "support/within.h"

namespace coppermoon::hand_off::three_films_test {

using Clock = std::chrono::steady_clock;

constexpr int frames = 5, pixels = 300;
const std::string first = "2018-07-27T18:30:00Z", last = "2018-07-27T20:20:00Z";

class ThreeFilms : public BlenderTest {
 protected:
  struct Film {
    std::vector<texture::Image> frames;
    double seconds = 0, megabytes = 0;
  };

  static double megabytes_in(const std::filesystem::path& folder, const std::string& begin = "") {
    double bytes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && entry.path().filename().string().starts_with(begin))
        bytes += static_cast<double>(entry.file_size());
    return bytes / 1e6;
  }

  static double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  Film by_textures() const {
    const auto start = Clock::now();
    expect_done(coppermoon(
        words_of("animate 2018-07-27 --from {} --to {} --frames {} --make textures,frames "
                 "--texture-width 1024 --field 0.6 --width {} --height {} --stars off -o textures",
                 first, last, frames, pixels, pixels)));
    Film film{{}, since(start), megabytes_in(here("textures"), "moon_")};
    for (int f = 1; f <= frames; ++f)
      film.frames.push_back(
          texture::read_image(here(fmt::format("textures/frame_lin_rec709.{:04}.exr", f))));
    return film;
  }

  Film in_blender() const {
    const auto start = Clock::now();
    const auto outcome = python(
        fmt::format("bpy.ops.coppermoon.add_eclipse(date='2018-07-27', film=True, frames={}, "
                    "begin='{}', end='{}', texture_width=1024, field={:.9f})\n",
                    frames, first, last, in_radians(algebra::degrees(0.6))) +
            square() + "scene.cycles.samples = 64\n",
        {"-o", here("blender.####").string(), "-a"});
    EXPECT_EQ(outcome.status, 0) << outcome.out;
    Film film{{}, since(start), megabytes_in(here("cache/coppermoon"))};
    for (int f = 1; f <= frames; ++f)
      film.frames.push_back(texture::read_image(here(fmt::format("blender.{:04}.exr", f))));
    return film;
  }

  /// The sunlit Moon of three moments, mixed, for its phase changes.
  Film in_povray() const {
    const auto start = Clock::now();
    expect_done(coppermoon("shader 2018-07-27 -o povray"));
    const std::vector<std::pair<std::string, std::string>> sunlit{
        {"a", first}, {"b", "2018-07-27T19:25:00Z"}, {"c", last}};
    for (const auto& [name, when] : sunlit)
      expect_done(coppermoon(words_of("bake {} --unshadowed --texture-width 1024 -o {}", when,
                                      "povray/" + name + ".exr")));
    file("povray/film.pov", R"(#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "eclipse.inc"
Eclipse_At(clock)
camera {
  location Eclipse_Distance*Eclipse_Earth direction z
  right x*image_width/image_height up y sky Eclipse_North angle 0.6 look_at 0
}
#macro Sunlit(Name)
  image_map { exr Name map_type 1 interpolate 2 } rotate y*180
#end
#local Part = (clock + 6705)/6600*2;  // 0 at the first, 2 at the last
Eclipse_Moon(pigment {
  average
  pigment_map {
    [ max(0, 1 - Part) Sunlit("a.exr") ]
    [ 1 - abs(1 - Part) Sunlit("b.exr") ]
    [ max(0, Part - 1) Sunlit("c.exr") ]
  }
})
)");
    Film film;
    for (int f = 1; f <= frames; ++f) {
      const double clock = -6705 + 6600. * (f - 1) / (frames - 1);
      const auto done = run(words_of("povray film.pov {} {} {} +FE {} +A0.0 +AM2 +R2 -J -D",
                                     fmt::format("+K{:.3f}", clock), fmt::format("+W{}", pixels),
                                     fmt::format("+H{}", pixels), fmt::format("+Oframe{}.exr", f)),
                            {.folder = here("povray")});
      EXPECT_EQ(done.status, 0) << done.err.substr(0, 2000);
      film.frames.push_back(texture::read_image(here(fmt::format("povray/frame{}.exr", f))));
    }
    film.seconds = since(start);
    film.megabytes = megabytes_in(here("povray")) - megabytes_in(here("povray"), "frame");
    return film;
  }

  /// Prints and checks a film against that of textures, within the limb.
  static void compare(const char* name, const Film& film, const Film& reference) {
    double worst = 0, squares = 0;
    std::size_t seen = 0;
    for (std::size_t f = 0; f < frames; ++f) {
      const auto ours = luminances(film.frames[f]), theirs = luminances(reference.frames[f]);
      for (std::size_t y = 0; y < pixels; ++y)
        for (std::size_t x = 0; x < pixels; ++x) {
          const double here = theirs(y, x), middle = (pixels - 1) / 2.;
          constexpr double inside = 118;  // of 122 pixels: other rays meet the limb in each
          if (std::hypot(static_cast<double>(x) - middle, static_cast<double>(y) - middle) > inside)
            continue;
          const double off = ours(y, x) / here - 1;
          worst = std::max(worst, std::abs(off));
          squares += off * off, ++seen;
        }
    }
    const double rms = std::sqrt(squares / static_cast<double>(seen));
    std::printf("| %s | %.1f | %.1f | %.2f %% | %.1f %% |\n", name, film.seconds, film.megabytes,
                100 * rms, 100 * worst);
    EXPECT_GT(seen, 200000U);
    EXPECT_WITHIN(rms, 0., 0.01, "1 % of the shader's light, as stated");
  }
};

/// Keeps frames of a film in the folder that COPPERMOON_FRAMES names.
void keep(const char* name, const std::vector<texture::Image>& film) {
  const char* folder = std::getenv("COPPERMOON_FRAMES");
  for (std::size_t f = 0; folder != nullptr && f < film.size(); ++f)
    texture::write_exr(std::filesystem::path(folder) / fmt::format("{}{}.exr", name, f + 1),
                       film[f], {{"coppermoon:colour_space", std::string("lin_rec709")}});
}

TEST_F(ThreeFilms, AreAlike) {
  const auto textures = by_textures();
  std::printf("| a texture for each frame, POV-Ray | %.1f | %.1f | | |\n", textures.seconds,
              textures.megabytes);
  keep("textures", textures.frames);
  const auto blender = in_blender(), povray = in_povray();
  keep("blender", blender.frames);
  keep("povray", povray.frames);
  compare("Blender, node group *Eclipse shadow*", blender, textures);
  compare("POV-Ray, `clock`", povray, textures);
}

}  // namespace coppermoon::hand_off::three_films_test
