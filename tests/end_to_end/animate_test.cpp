// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "end_to_end/luminance.h"
#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::animate_test {

namespace fs = std::filesystem;

const Words small = "--albedo-map built-in --texture-width 128 --width 48 --height 32 --field 0.9";

class Animate : public ProgramTest {
 protected:
  static Words dated_film(const Words& more) {
    return Words("animate 2018-07-27 -o film") + small + more;
  }

  /// In air that takes a third of the time.
  static Words film(const Words& more) { return dated_film(more + "--atmosphere undated"); }

  auto files() const { return contents(here("film")); }

  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& [name, bytes] : files()) all.insert(name);
    return all;
  }

  std::size_t kept(const Words& words) const {
    const auto outcome = coppermoon(words + Words{"--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const auto last = outcome.out.rfind('\n', outcome.out.size() - 2);
    return nlohmann::json::parse(outcome.out.substr(last + 1)).at("kept");
  }

  void expect_shown_by_stills(const Words& air) const;
  void expect_same_again() const;
};

TEST_F(Animate, MakesPictures) {
  expect_done(coppermoon(dated_film("--frames 3 --from U1 --to U2")));
  EXPECT_EQ(names(), (std::set<std::string>{"eclipse.light", "frame.0001.png", "frame.0002.png",
                                            "frame.0003.png"}));
  EXPECT_EQ(texture::read_image(here("film/frame.0002.png")).width, 48U);
}

TEST_F(Animate, MakesWhatItIsToldTo) {
  expect_done(coppermoon(film("--frames 2 --make textures")));
  EXPECT_EQ(names(), (std::set<std::string>{"eclipse.light", "moon_lin_rec709.0001.exr",
                                            "moon_lin_rec709.0002.exr"}));
  expect_done(coppermoon(film("--frames 2 --make scenes,frames,pictures")));
  EXPECT_EQ(names(), (std::set<std::string>{
                         "eclipse.light", "eclipse.pov", "eclipse.ini", "moon_lin_rec709.0001.exr",
                         "moon_lin_rec709.0002.exr", "frame_lin_rec709.0001.exr",
                         "frame_lin_rec709.0002.exr", "frame.0001.png", "frame.0002.png"}));
}

TEST_F(Animate, MakesTheSameTexturesWhateverElseIsMade) {
  const Words at = "--at -21.1,55.5 --frames 1 --from U1 --make";
  expect_done(coppermoon(dated_film(at + Words{"textures"})));
  const auto alone = text_of(here("film/moon_lin_rec709.0001.exr"));
  fs::remove(here("film/moon_lin_rec709.0001.exr"));
  expect_done(coppermoon(dated_film(at + Words{"scenes,pictures"})));
  EXPECT_TRUE(text_of(here("film/moon_lin_rec709.0001.exr")) == alone)
      << "reddened by the same air: a later run keeps it";
}

/// The film's light is computed once for all of its moments, a still's for its own.
void Animate::expect_shown_by_stills(const Words& air) const {
  const auto at = Words("--at -21.1,55.5 --tolerance 0.2% --stars off") + air;
  expect_done(coppermoon(dated_film(at + "--frames 3 --from U1 --to greatest --make frames")));
  const auto found = texture::read_image(here("film/frame_lin_rec709.0002.exr"));
  const auto when = texture::read_attribute(here("film/frame_lin_rec709.0002.exr"), "capDate");
  ASSERT_TRUE(when);
  auto instant = when->substr(0, 10) + "T" + when->substr(11) + "Z";  // "2018:07:27 19:23:06"
  instant[4] = instant[7] = '-';
  expect_done(
      coppermoon(words_of("still {} -o alone.png --frame alone.exr", instant) + small + at));
  const auto alone = texture::read_image(here("alone.exr"));
  double worst = 0, sum = 0;
  for (std::size_t r = 0; r < 32; ++r)
    for (std::size_t c = 0; c < 48; ++c) {
      const double a = luminance(found, r, c), b = luminance(alone, r, c);
      sum += b;
      if (b > 0) worst = std::max(worst, std::abs(a / b - 1));
    }
  EXPECT_GT(sum, 0);
  EXPECT_WITHIN(worst, 0, 0.012,
                "both within 0.2 % of the light; half a second of the shadow's way, 0.4 km, where "
                "light falls to a tenth in 100 km: 1 %");
  expect_same_again();
  const auto again = texture::read_image(here("again.exr"));
  for (std::size_t i = 0; i < found.values.size(); ++i)
    EXPECT_WITHIN(again.values[i], found.values[i], 0.004 * found.values[i] + 1e-7,
                  "the light of all frames, and that of one, are within 0.2 % each; half floats "
                  "below 6e-5 are in steps of 6e-8");
}

/// X, Y or Z of a pixel of linear Rec. 709, by the matrix of IEC 61966-2-1.
double tristimulus(const texture::Image& image, std::size_t r, std::size_t c, std::size_t k) {
  constexpr double weights[3][3] = {
      {0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};
  double sum = 0;
  for (std::size_t channel = 0; channel < 3; ++channel)
    sum += weights[k][channel] * double{image(r, c, channel)};
  return sum;
}

/// A still made again of the film's second frame, again.exr, shows it.
void Animate::expect_same_again() const {
  expect_done(coppermoon("still film/frame_lin_rec709.0002.exr -o again.png --frame again.exr"));
  const auto found = texture::read_image(here("film/frame_lin_rec709.0002.exr")),
             again = texture::read_image(here("again.exr"));
  for (std::size_t r = 0; r < 32; ++r)
    for (std::size_t c = 0; c < 48; ++c)
      for (std::size_t k = 0; k < 3; ++k) {
        const double value = tristimulus(found, r, c, k);
        EXPECT_WITHIN(
            tristimulus(again, r, c, k), value, 0.004 * value + 1e-7,
            "the light of all frames, and that of one, are within 0.2 % each; 0.08 % measured in "
            "undated air; half floats");
      }
}

TEST_F(Animate, ShowsWhatStillsShow) { expect_shown_by_stills("--atmosphere paper"); }

/// The umbra's red is on the edge of Rec. 709 in this air: of light of 0.24 cd/m² the blue channel is the 2e-6 that
/// terms of 0.01 leave of one another, in this frame a third more or less than in the still. X, Y and Z do not cancel.
TEST_F(Animate, ShowsAgainTheColoursAtTheEdgeOfRec709) {
  expect_done(
      coppermoon(film("--at -21.1,55.5 --tolerance 0.2% --stars off --frames 3 --from U1 --to "
                      "greatest --make frames")));
  expect_same_again();
}

using AnimateThoroughly = Animate;

TEST_F(AnimateThoroughly, ShowsWhatStillsShowInDatedAir) { expect_shown_by_stills({}); }

TEST_F(AnimateThoroughly, ExposesWithoutAStep) {
  const auto outcome = coppermoon(
      dated_film("--frames 40 --from U2-10min --to U2+10min --time follow --json --make frames"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::map<std::size_t, double> stops;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    const auto event = nlohmann::json::parse(line);
    if (event["event"] == "frame")
      stops[event["frame"]] = std::log2(event["exposure_time_s"].get<double>());
  }
  ASSERT_EQ(stops.size(), 40U);
  for (std::size_t i = 3; i <= 40; ++i)
    EXPECT_WITHIN(
        stops[i] - stops[i - 1], stops[i - 1] - stops[i - 2], 0.1,
        "stops: a tenth is hardly seen, and second contact changes it by 2.6 in 20 minutes");
}

/// Second contact takes three stops of a composite's shorter exposure in five minutes: its pictures
/// change evenly all the same.
TEST_F(AnimateThoroughly, LaysTwoExposuresInOnePictureWithoutAStep) {
  expect_done(coppermoon(
      dated_film("--frames 40 --from U2-10min --to U2+10min --time composite --make pictures")));
  std::vector<double> means;
  for (int frame = 1; frame <= 40; ++frame) {
    const auto picture = texture::read_image(here(fmt::format("film/frame.{:04}.png", frame)));
    means.push_back(std::accumulate(picture.values.begin(), picture.values.end(), 0.) /
                    static_cast<double>(picture.values.size()));
  }
  for (std::size_t i = 1; i < means.size(); ++i)
    EXPECT_WITHIN(means[i], means[i - 1], 0.01,
                  "of white, coded: less than a change that is seen at once, 2.5 steps of 8 bits");
}

TEST_F(Animate, LaysTwoExposuresInOnePicture) {
  const auto outcome =
      coppermoon(film("--frames 2 --from U1 --to U2-20min --range 2 --time composite --json"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto picture = here("film/frame.0002.png");
  const auto told = [&](const char* name) {
    return std::stod(texture::read_attribute(picture, name).value_or("0"));
  };
  EXPECT_GT(told("coppermoon:longer_exposure_s") / told("expTime"), 30) << "five stops and more";
  EXPECT_SAYS(outcome.out, "\"longer_exposure_time_s\":");
  const auto image = texture::read_image(picture);
  const auto clipped = std::ranges::count_if(image.values, [](float v) { return v > 0.999F; });
  const auto seen = std::ranges::count_if(image.values, [](float v) { return v > 0.1F; });
  EXPECT_EQ(clipped, 0);
  expect_done(
      coppermoon(film("--frames 2 --from U1 --to U2-20min --range 2 --time auto --replace")));
  const auto once = texture::read_image(picture);
  EXPECT_GT(seen, 1.3 * static_cast<double>(
                            std::ranges::count_if(once.values, [](float v) { return v > 0.1F; })))
      << "the shadow is seen too";
  EXPECT_FALSE(texture::read_attribute(picture, "coppermoon:longer_exposure_s"));
}

TEST_F(Animate, TakesExposuresFromKeys) {
  const auto outcome = coppermoon(film("--frames 3 --from U1 --to U2 --time U1:0.01,U2:1 --json"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const auto& [frame, time] : {std::pair{1, 0.01}, {2, 0.1}, {3, 1.}}) {
    const auto text =
        texture::read_attribute(here(fmt::format("film/frame.{:04}.png", frame)), "expTime");
    ASSERT_TRUE(text);
    EXPECT_WITHIN(std::stod(*text) / time, 1, 1e-3, "half way in time is half way in stops");
  }
}

TEST_F(Animate, MakesFramesInTheSpaceAskedFor) {
  const Words made = "--frames 1 --from U2 --make frames,pictures --bits 16";
  expect_done(coppermoon(film(made)));
  const auto rec709 = texture::read_image(here("film/frame_lin_rec709.0001.exr")),
             picture = texture::read_image(here("film/frame.0001.png"));
  fs::remove_all(here("film"));
  expect_done(coppermoon(film(made + "--space acescg")));
  const auto file = here("film/frame_acescg.0001.exr");
  EXPECT_EQ(texture::read_attribute(file, "coppermoon:colour_space").value_or(""), "acescg");
  const auto acescg = texture::read_image(file),
             again = texture::read_image(here("film/frame.0001.png"));
  ASSERT_EQ(acescg.values.size(), rec709.values.size());
  double reds[2] = {}, blues[2] = {};
  for (std::size_t i = 0; i < rec709.values.size(); i += 3) {
    reds[0] += rec709.values[i], blues[0] += rec709.values[i + 2];
    reds[1] += acescg.values[i], blues[1] += acescg.values[i + 2];
  }
  EXPECT_LT(reds[1] / blues[1], 0.9 * reds[0] / blues[0]) << "its red is redder";
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    EXPECT_WITHIN(again.values[i], picture.values[i], 2e-3,
                  "frames of half precision, where the curve is steep");
  expect_done(coppermoon(
      "animate film/frame_acescg.0001.exr --make frames,pictures --time 2 -o film --replace"));
  EXPECT_EQ(texture::read_image(file).values, acescg.values) << "developed again from what is kept";
}

TEST_F(Animate, RefusesABracketBeyondAllExposureTimesAtOnce) {
  for (const char* time : {"1e6", "U1:1e6,U2:1", "1e-6"}) {
    const auto refused =
        coppermoon(film(words_of("--frames 1 --from U1 --bracket 1 --time {}", time)));
    EXPECT_EQ(refused.status, 1) << time;
    EXPECT_SAYS(refused.err, "exposure time of the bracket [s]");
    EXPECT_FALSE(std::filesystem::exists(here("film"))) << "before any work";
  }
}

TEST_F(Animate, BracketsByStops) {
  expect_done(coppermoon(film("--frames 1 --from U1 --bracket 2")));
  const auto time = [&](const char* name) {
    return std::stod(texture::read_attribute(here("film") / name, "expTime").value_or("0"));
  };
  EXPECT_WITHIN(time("frame_under.0001.png") / time("frame.0001.png"), 0.25, 1e-3, "two stops");
  EXPECT_WITHIN(time("frame_over.0001.png") / time("frame.0001.png"), 4, 4e-3, "two stops");
}

TEST_F(Animate, KeepsWhatVerifiesAndMakesTheRestAgain) {
  const auto words = film("--frames 4 --from U1 --make frames,pictures");
  expect_done(coppermoon(words));
  const auto whole = files();
  EXPECT_EQ(kept(words), 4U);
  fs::remove(here("film/frame.0001.png"));
  fs::resize_file(here("film/frame.0002.png"), 900);
  fs::copy_file(here("film/frame_lin_rec709.0004.exr"), here("film/frame_lin_rec709.0003.exr"),
                fs::copy_options::overwrite_existing);
  EXPECT_EQ(kept(words), 1U);
  EXPECT_TRUE(files() == whole);
}

TEST_F(AnimateThoroughly, GivesTheSameBytesInShardsAndAtOnce) {
  const auto words = film("--frames 5 --make frames,pictures");
  expect_done(coppermoon(words));
  const auto at_once = files();
  fs::remove_all(here("film"));
  for (const char* shard : {"3/3", "1/3", "2/3"})
    expect_done(coppermoon(words + words_of("--shard {} --threads 1", shard)));
  EXPECT_TRUE(files() == at_once);
  EXPECT_EQ(kept(words + "--range 1-5x2"), 3U);
}

TEST_F(Animate, GoesOnFromAnyOfItsFrames) {
  expect_done(coppermoon(film("--frames 3 --make frames")));
  EXPECT_EQ(kept("animate film/frame_lin_rec709.0002.exr --make frames -o film"), 3U);
}

TEST_F(Animate, IsSeenByPlainPovray) {
  expect_done(coppermoon(film("--frames 3 --from U1 --make scenes --start-frame 1001")));
  const auto outcome = run("povray eclipse.ini +SF1002 +EF1003 -GA", {.folder = here("film")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_FALSE(fs::exists(here("film/frame.1001.exr")));
  for (const char* name : {"film/frame.1002.exr", "film/frame.1003.exr"})
    EXPECT_EQ(texture::read_image(here(name)).width, 48U);
}

/// As far as the Moon goes in a day, it goes through the picture's middle half way.
TEST_F(Animate, OnATripodLetsTheMoonGoThroughThePicture) {
  const auto words = film(
      "--frames 3 --from greatest-1h --to greatest+1h --at 0,50 --mount fixed --field 60 --width "
      "480 --height 320 --make frames --stars off --sky off");
  expect_done(coppermoon(words));
  std::vector<double> from_middle;
  for (const char* name : {"film/frame_lin_rec709.0001.exr", "film/frame_lin_rec709.0002.exr",
                           "film/frame_lin_rec709.0003.exr"}) {
    const auto image = texture::read_image(here(name));
    double light = 0, sum = 0, rows = 0;
    for (std::size_t r = 0; r < image.height; ++r)
      for (std::size_t c = 0; c < image.width; ++c) {
        light += luminance(image, r, c);
        sum += luminance(image, r, c) * (static_cast<double>(c) + 0.5);
        rows += luminance(image, r, c) * (static_cast<double>(r) + 0.5);
      }
    from_middle.push_back(std::hypot(sum / light - 240, rows / light - 160));
  }
  // 240 pixels are 30 degrees; in an hour the sky turns by 15.04 degrees and the Moon goes back by 0.5
  // (1 of parallax near the zenith); it stands 19 degrees south, where that is less
  constexpr double degree = std::numbers::pi / 180;
  const double away = 240 / std::tan(30 * degree) * std::tan(14.6 * std::cos(19 * degree) * degree);
  EXPECT_WITHIN(from_middle[1], 0, 1, "pixels: the Moon is four, brighter on one side");
  EXPECT_WITHIN(from_middle[0], away, 4, "pixels: half a degree of parallax");
  EXPECT_WITHIN(from_middle[2], away, 4, "pixels: half a degree of parallax");
}

TEST_F(AnimateThoroughly, MergesShardsOfPhotons) {
  const Words photons =
      "--solver photons --photons 40000 --frames 2 --from U2 --to U3 --quality draft";
  expect_done(coppermoon(dated_film(photons + "--make frames")));
  const auto at_once = texture::read_image(here("film/frame_lin_rec709.0002.exr"));
  fs::remove_all(here("film"));
  for (int part = 1; part <= 8; ++part)
    expect_done(coppermoon(
        dated_film(photons + words_of("--make light --shard {}", fmt::format("{}/8", part)))));
  EXPECT_EQ(names().size(), 8U) << "eclipse.1-of-8.sums and on";
  expect_done(coppermoon(dated_film(photons + "--make frames")));
  const auto merged = texture::read_image(here("film/frame_lin_rec709.0002.exr"));
  for (std::size_t i = 0; i < merged.values.size(); ++i)
    EXPECT_WITHIN(
        merged.values[i], at_once.values[i], 1e-3 * at_once.values[i],
        "sums differ by rounding, 1e-12; half floats by a step, 1e-3, where that tips one");
}

TEST_F(Animate, TellsEventsAsJson) {
  const auto outcome = coppermoon(film("--frames 2 --make textures --json"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::vector<std::string> events;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);)
    events.push_back(nlohmann::json::parse(line).at("event"));
  EXPECT_EQ(events, (Words("light frame frame done")));
}

TEST_F(Animate, RefusesWhatItCannotMake) {
  expect_refusal(
      film("--make films"),
      "make = films, allowed light, textures, tx, scenes, frames and pictures, with commas "
      "between");
  expect_refusal(film("--range 1-500"),
                 "range = 1-500, allowed frames of 1-240, as 1-240, 1-240x2 or 7,9,20-30");
  expect_refusal(film("--time U1:0.01,U1:2"),
                 "exposure time = U1:0.01,U1:2, allowed keys in order of time");
  for (const char* from : {"P1+nanmin", "P1-infh", "P1+1e300s"}) {
    const auto outcome = coppermoon(film({"--from", from}));
    EXPECT_EQ(outcome.status, 1);
    EXPECT_SAYS(outcome.err, from);
  }
  expect_refusal(film("--mount fixed"), "mount = fixed: needs --at");
  expect_refusal(film("--at -21,55 --aim 30,20"), "mount = tracking: --aim needs a fixed one");
  expect_refusal("animate 2018-07-27 -o no/such/film", "no/such: no such directory");
  expect_refusal(film("--at 40,-100"),
                 "the Moon is below the horizon of 40,-100 from 2018-07-27T17:14:48Z to "
                 "2018-07-27T23:28:41Z");
  expect_refusal(film("--at 40,-100 --from P1 --to P4"),
                 "the Moon is below the horizon of 40,-100 in all frames");
}

TEST_F(Animate, SaysWhenTheMoonIsUp) {
  const auto outcome = coppermoon(film("--at 42.3,13.4 --frames 10 --from P1"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.err.find("it is up from frame 3 (2018-07-27T") != std::string::npos)
      << outcome.err;
  // 700 m high, where the horizon is a degree lower
  const auto rising = coppermoon(film("--at Ohrid --frames 1 --make frames --stars off"));
  EXPECT_TRUE(rising.err.starts_with("coppermoon: from moonrise, 1")) << rising.err;
  const auto first = texture::read_image(here("film/frame_lin_rec709.0001.exr"));
  EXPECT_GT(std::ranges::max(first.values), 0) << "some of the Moon is in the first frame";
}

}  // namespace coppermoon::end_to_end::animate_test
