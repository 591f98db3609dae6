// SPDX-License-Identifier: MIT
// What the program says of air that it was not told. A hundred such photographs are in recovery_test.
#include <fmt/format.h>
#include <bit>
#include <nlohmann/json.hpp>

#include "baker/texture/fits_bytes.h"
#include "end_to_end/made_night.h"
#include "support/program.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace coppermoon::end_to_end::fit_test {

using nlohmann::json;

// In air of one column: of belts a fit takes five times as long.
constexpr const char *deep = "2018-07-27T20:40:00Z", *syria = "36,38";

class Fit : public ProgramTest {
 protected:
  void make(const Words& words) const { expect_done(coppermoon(words)); }

  /// a.png, under a known air.
  void photograph(const std::string& side, const Words& more,
                  const std::string& instant = deep) const {
    make(
        words_of("still {} --at {} --dust-extinction 5e-6 --cloud-cover 0.4 --width {} --height {} "
                 "--field 0.8 --time 2 --iso 800 --camera 400mm --seeing 2 --albedo-map built-in "
                 "--atmosphere undated -o a.png",
                 instant, syria, side, side) +
        more);
  }

  /// Light of a.png as counts, in floating-point FITS.
  void write_counts(const char* name, float of_one) const {
    const auto light = texture::read_light(here("a.png"));
    std::string data;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = k; i < light.values.size(); i += 3) {
        const auto bits = std::bit_cast<std::uint32_t>(light.values[i] * of_one);
        for (int shift = 24; shift >= 0; shift -= 8) data += static_cast<char>(bits >> shift);
      }
    file(
        name,
        fits_bytes(
            fmt::format(
                "SIMPLE  = T\nBITPIX  = -32\nNAXIS   = 3\nNAXIS1  = {}\nNAXIS2  = {}\nNAXIS3  = 3\n"
                "ROWORDER= 'TOP-DOWN'\nEXPTIME = 2.\nGAIN    = 120\n",
                light.width, light.height),
            data));
  }

  json fit(const Words& words) const {
    return json_of(Words{"fit"} + words + "--albedo-map built-in");
  }

  std::string refused(const Words& words) const { return expect_refused(Words{"fit"} + words, ""); }
};

TEST_F(Fit, OfAPhotographFindsItsAir) {
  photograph("440", "--bits 16");
  std::filesystem::copy(here("a.png"), here("cut.png"));
  std::filesystem::resize_file(here("cut.png"), 10000);
  const auto found =
      fit(words_of("a.png cut.png --instants {} --at {} --camera 400mm --times 2 --isos 800 "
                   "--f-number 5.6 --atmosphere undated",
                   deep, syria));
  const auto& dust = found["dust_extinction_per_m"];
  EXPECT_WITHIN_RELATIVE(dust["median"].get<double>(), 5e-6, 0.25,
                         "exposure believed to 10 %; 93 of 100 are within that");
  EXPECT_WITHIN(found["cloud_cover"]["median"].get<double>(), 0.4, 0.15, "the same");
  EXPECT_TRUE(dust["told"]);
  EXPECT_LT(dust["low_68"], dust["median"]);
  EXPECT_GT(dust["high_68"], dust["median"]);
  EXPECT_GT(found["numbers"], 20);
  EXPECT_EQ(found["photographs"][0]["mirrored"], false);
  EXPECT_EQ(found["explained"], true);
  EXPECT_EQ(found["photographs"][0]["exposure_known"], true);
  EXPECT_TRUE(found["photographs"][1]["left_out"].get<std::string>().starts_with("cannot be read"));
  // the same light, as a sensor counts it
  write_counts("counts.fits", 60000);
  const auto counted =
      fit(words_of("counts.fits --instants {} --at {} --atmosphere undated", deep, syria));
  const auto& photograph = counted["photographs"][0];
  EXPECT_GT(photograph["numbers"], 20);
  EXPECT_EQ(photograph["exposure_known"], true) << "EXPTIME, and a gain";
  EXPECT_EQ(photograph["clipped_at"]["source"], "greatest");
  EXPECT_WITHIN(counted["cloud_cover"]["median"].get<double>(), 0.4, 0.15, "as above");
}

TEST_F(Fit, SaysWhichEclipseADateMisses) {
  photograph("100", {});
  texture::write_png(here("b.png"), texture::read_image(here("a.png")), 16,
                     {{"capDate", "2018:07:25 10:00:00"}});
  expect_refused("fit b.png --instants from-header",
                 "b.png: dated 2018-07-25T10:00, which no time zone puts into the eclipse of "
                 "2018-07-27: its clock was wrong");
}

TEST_F(Fit, ExplainsAStillInTheAirOfItsMonth) {
  constexpr const char* instant = "2018-07-27T19:40:17Z";
  make(words_of("still {} --at Nairobi --width 600 --height 400 -o st.png", instant));
  const auto found = fit(words_of("st.png --instants {} --at Nairobi", instant));
  EXPECT_EQ(found["explained"], true);
  EXPECT_TRUE(found["misfit"].is_null());
  for (const char* factor : {"stratospheric_factor", "cloud_chance", "ozone_factor"}) {
    const double low = found[factor]["low_68"], high = found[factor]["high_68"];
    EXPECT_WITHIN(found[factor]["median"].get<double>(), 1, 2 * (high - low),
                  "the usual air, within four standard errors");
  }
}

using FitThoroughly = Fit;

TEST_F(FitThoroughly, ExplainsTheUmbraBesideABurntCrescent) {
  constexpr const char* instant = "2018-07-27T19:04:28Z";
  make(words_of("still {} --at Nairobi --width 900 --height 600 --time 1 -o st.png", instant));
  const auto found = fit(words_of("st.png --instants {} --at Nairobi", instant));
  EXPECT_EQ(found["explained"], true);
  EXPECT_LT(found["chi_squared"], found["numbers"]) << "compressed highlights are not light";
  for (const char* factor : {"stratospheric_factor", "cloud_chance", "ozone_factor"}) {
    const double low = found[factor]["low_68"], high = found[factor]["high_68"];
    EXPECT_WITHIN(found[factor]["median"].get<double>(), 1, 2 * (high - low),
                  "the usual air, within four standard errors");
  }
}

TEST_F(FitThoroughly, SeesThroughTheFiltersOfThePhotographsCamera) {
  photograph("300", "--bits 16 --response canon-eos-600d");
  const auto of_photograph = words_of(
      "a.png --instants {} --at {} --camera 400mm --times 2 --isos 800 --f-number 5.6 --atmosphere "
      "undated",
      deep, syria);
  const auto found = fit(of_photograph + "--response canon-eos-600d");
  EXPECT_WITHIN_RELATIVE(found["dust_extinction_per_m"]["median"].get<double>(), 5e-6, 0.25,
                         "as above");
  EXPECT_WITHIN(found["cloud_cover"]["median"].get<double>(), 0.4, 0.15, "as above");
  EXPECT_LT(found["chi_squared"], found["numbers"]);
  const auto refusal = coppermoon(Words{"fit"} + of_photograph + "--albedo-map built-in");
  EXPECT_EQ(refusal.status, could_not);
  EXPECT_SAYS(refusal.err, "no air explains this") << "its colours are not the observer's";
  EXPECT_SAYS(refusal.err, "worst: a.png in ");
}

TEST_F(Fit, RefusesErrorsOutsideTheirRanges) {
  run("oiiotool --create 64x64 3 -o dot.png");
  for (const auto& [flag, value, allowed] :
       std::vector<std::array<std::string, 3>>{{"--weather-error", "1.01", "0 to 1"},
                                               {"--weather-error", "-0.01", "0 to 1"},
                                               {"--shutter-error", "11", "0.001 to 10"},
                                               {"--exposure-error", "0", "0.001 to 10"},
                                               {"--white-balance-error", "11", "0.001 to 10"},
                                               {"--clock-error", "61", "0 to 60"}}) {
    const auto outcome = coppermoon(
        words_of("fit dot.png --instants {} --at {} {}", deep, syria, flag + "=" + value));
    EXPECT_NE(outcome.status, 0);
    EXPECT_SAYS(outcome.err, "allowed " + allowed);
  }
}

TEST_F(FitThoroughly, NamesThePhotographAndTheChannelThatMisfit) {
  const std::vector<std::string> minutes{"20:05", "20:20", "20:35", "20:50"};
  const auto moments = [](const std::vector<std::string>& all) {
    std::string list;
    for (const auto& minute : all)
      list += fmt::format("{}2018-07-27T{}:00Z", list.empty() ? "" : ",", minute);
    return list;
  };
  Words photographs, pale;
  for (const auto& minute : minutes) {
    photographs.push_back(minute.substr(3) + ".png");
    pale.push_back("pale" + photographs.back());
    photograph("300", "--bits 16", "2018-07-27T" + minute + ":00Z");
    std::filesystem::rename(here("a.png"), here(photographs.back()));
    run(words_of("oiiotool {} --mulc 0.7,1,1 -o {}", photographs.back(), pale.back()));
  }
  run("oiiotool 35.png --flop -o mirrored.png");
  const auto taken = words_of(
      "--at {} --camera 400mm --isos 800 --f-number 5.6 --atmosphere undated --despite-misfit",
      syria);
  const auto found = [&](const Words& files, const std::string& instants, const char* times) {
    const auto outcome = coppermoon(
        Words{"fit"} + files + taken +
        words_of("--instants {} --times {} --albedo-map built-in --json", instants, times));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return json::parse(outcome.out);
  };
  const auto sound = found({photographs[0], photographs[1], "mirrored.png", photographs[3]},
                           moments(minutes), "2");
  EXPECT_TRUE(sound["misfit"].is_null());
  EXPECT_EQ(sound["photographs"][2]["mirrored"], true);
  EXPECT_GE(sound["nights"][0]["misfits"].size(), 8) << "four photographs, red and green at least";
  const auto by_a_stop = found(photographs, moments(minutes), "2,2,4,2")["misfit"];
  EXPECT_EQ(by_a_stop["file"], "35.png");
  EXPECT_EQ(by_a_stop["suspect"], "exposure");
  const auto late = found(photographs, moments({"20:05", "20:40", "20:35", "20:50"}), "2");
  EXPECT_EQ(late["explained"], false);
  EXPECT_EQ(late["misfit"]["file"], "20.png");
  EXPECT_EQ(late["misfit"]["suspect"], "instant");
  const auto all_late = found(photographs, moments({"20:15", "20:30", "20:45", "21:00"}), "2");
  EXPECT_EQ(all_late["misfit"]["suspect"], "clock");
  const auto of_a_pale_red = found(pale, moments(minutes), "2")["misfit"];
  EXPECT_EQ(of_a_pale_red["channel"], "red");
  EXPECT_EQ(of_a_pale_red["suspect"], "colours");
}

TEST_F(FitThoroughly, NamesBlueInTheUmbraWhereItAloneIsScaledThere) {
  Words photographs;
  std::string moments;
  const auto take = [&](const std::string& name, const std::string& moment, const Words& more) {
    photograph("300", Words("--bits 16") + more, moment);
    std::filesystem::rename(here("a.png"), here(name));
    photographs.push_back(name);
    moments += (moments.empty() ? "" : ",") + moment;
  };
  const Words clear = "--dust-extinction 1e-6 --cloud-cover 0.1";  // blue is seen in it
  take("sunlit.png", "2018-07-27T18:50:00Z", clear + "--time 1/500");
  for (const char* minute : {"05", "20", "35", "50"}) {
    const auto name = std::string(minute) + ".png";
    take(name, fmt::format("2018-07-27T20:{}:00Z", minute), clear + "--time 1");
    run(words_of("oiiotool {} --mulc 1,1,1.6 -o {}", name, name));
  }
  const auto outcome = coppermoon(
      Words{"fit"} + photographs +
      words_of(
          "--instants {} --times 0.002,1,1,1,1 --isos 800 --f-number 5.6 --at {} --camera 400mm "
          "--atmosphere undated --despite-misfit --albedo-map built-in --json",
          moments, syria));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto misfit = json::parse(outcome.out)["misfit"];
  EXPECT_EQ(misfit["channel"], "blue");
  EXPECT_EQ(misfit["place"], "umbra");
  EXPECT_EQ(misfit["suspect"], "colours");
  EXPECT_NE(misfit["file"], "sunlit.png");
}

TEST_F(FitThoroughly, OfARawPhotographFindsItsAirByItsOwnHeader) {
  photograph("880", "--raw a.dng");
  const Words words =
      words_of("a.dng --instants {} --at {} --camera 400mm --atmosphere undated", deep, syria);
  const auto found = fit(words);
  const auto chi_squared_at = [&](const char* weather) {
    return fit(words + Words{"--weather-error", weather})["chi_squared"].get<double>();
  };
  EXPECT_EQ(chi_squared_at("0.2"), found["chi_squared"]) << "the default";
  EXPECT_NE(chi_squared_at("0"), found["chi_squared"]);
  EXPECT_EQ(found["photographs"][0]["exposure_known"], true);
  EXPECT_EQ(found["explained"], true);
  EXPECT_WITHIN_RELATIVE(found["dust_extinction_per_m"]["median"].get<double>(), 5e-6, 0.25,
                         "exposure believed to 10 %; 93 of 100 are within that");
  EXPECT_WITHIN(found["cloud_cover"]["median"].get<double>(), 0.4, 0.15, "the same");
}

TEST_F(FitThoroughly, OfANightOfJpegsFindsAirCurveAndAClockThatIsHoursWrong) {
  NightTruth truth;
  truth.clock_s = 130 - 3600;  // an hour of summer time, and some minutes
  truth.exposed = 1.3;
  const auto occasion = night_occasions().front();
  Words words;
  for (const auto& photograph : MadeNight(occasion, truth).request(here()).photographs)
    words.push_back(photograph.file);
  // one photograph without a date ends no night
  texture::write_png(here("undated.png"), texture::Image(8, 8, {"R", "G", "B"}), 8);
  words.push_back("undated.png");
  // as the clocks of the place, three hours before UTC, say; made cameras see as the CIE observer does, in even air
  const auto found =
      fit(words + Words{"--instants", "from-header", "--at",
                        fmt::format("{},{}", occasion.latitude_deg, occasion.longitude_deg),
                        "--reddening", "off", "--atmosphere", "undated", "--response",
                        "colorimetric", "--weather-error", "0", "-o", "light.csv"});
  EXPECT_WITHIN_RELATIVE(found["dust_extinction_per_m"]["median"].get<double>(), truth.dust_per_m,
                         0.25, "what was asked for, of 95 nights in a hundred");
  EXPECT_WITHIN(found["cloud_cover"]["median"].get<double>(), truth.cloud_cover, 0.15, "the same");
  const auto& night = found["nights"][0];
  EXPECT_WITHIN(night["clock"]["add_s"].get<double>(), truth.clock_s + 3 * 3600, 30, "the same");
  EXPECT_TRUE(night["tone_curve"].is_array());
  const auto light = text_of(here("light.csv"));
  EXPECT_TRUE(light.starts_with("night,distance_km,channel,light,error,model\n1,"));
  EXPECT_GT(std::ranges::count(light, '\n'), 50);
}

// Light is not linear over so many minutes: the clock is looked for.
TEST_F(FitThoroughly, FindsAClockThatIsSevenMinutesFromTheMomentsTold) {
  const auto truth = night_truth(4);
  auto request = MadeNight(night_occasions()[4], truth).request(here());
  request.moon.response = "colorimetric";
  request.weather_error = 0;
  const auto answer = uses::fitted_air(request);
  EXPECT_WITHIN(answer.nights.front().clock->seconds, truth.clock_s, 30,
                "what is asked for, of 90 nights in a hundred");
  EXPECT_EQ(answer.nights.front().turns,
            (std::vector{uses::Again::in_its_air, uses::Again::by_its_curve}));
}

TEST_F(FitThoroughly, OfAStrangersNightFindsTheClock) {
  auto night = strangers_night(3);
  night.truth.month->weather = 0;  // light of many regions takes half a minute
  for (auto* minutes : {&night.occasion.short_min, &night.occasion.long_min}) {
    std::vector<double> half;
    for (std::size_t i = 0; i < minutes->size(); i += 2) half.push_back((*minutes)[i]);
    *minutes = half;
  }
  MadeNight made(night.occasion, night.truth);
  const auto request = made.request(here());
  Words words{"fit"};
  for (const auto& photograph : request.photographs) words.push_back(photograph.file);
  const auto outcome =
      coppermoon(words + night.told() + Words{"--albedo-map", request.moon.albedo_map, "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto found = json::parse(outcome.out);
  EXPECT_WITHIN(found["nights"][0]["clock"]["add_s"].get<double>(), night.zone_error_s, 30,
                "what was asked for");
}

TEST_F(Fit, ReadsAnInstantForEachPhotograph) {
  run("oiiotool --create 20x16 3 -o dot.png");
  std::filesystem::copy(here("dot.png"), here("other.png"));
  EXPECT_SAYS(refused("dot.png other.png --instants 2018-07-20T20:40:00Z,2018-07-27T20:40:00Z "
                      "--albedo-map built-in"),
              "no lunar eclipse at 2018-07-20");
  const auto told = coppermoon(
      "fit dot.png --instants '2018-07-27 U1+40min' --albedo-map built-in --atmosphere undated");
  EXPECT_SAYS(told.err, "2018-07-27 U1+40min is 2018-07-27 19:04:28 UTC");
  EXPECT_SAYS(told.err, "no Moon found");
}

TEST_F(FitThoroughly, TakesTheGlowOfALitCrescentOffItsUmbra) {
  constexpr const char* partial = "2018-07-27T19:20:00Z";
  for (const auto& [time, file] : {std::pair{"1/500", "short.png"}, std::pair{"1/2", "long.png"}})
    make(words_of(
        "still {} --at {} --dust-extinction 5e-6 --cloud-cover 0.4 --width 440 --height 440 "
        "--field 0.8 --time {} --iso 800 --camera 400mm --glow 0.06 --albedo-map built-in "
        "--atmosphere undated --bits 16 -o {}",
        partial, syria, time, file));
  const auto found = fit(
      words_of("short.png long.png --instants {} --at {} --camera 400mm --times 0.002,0.5 --isos "
               "800 --f-number 5.6 --atmosphere undated",
               partial, syria));
  const auto& cover = found["cloud_cover"];
  EXPECT_TRUE(cover["told"]);
  EXPECT_WITHIN(cover["median"].get<double>(), 0.4, 0.15, "what was asked for of one photograph");
  EXPECT_LT(cover["high_68"].get<double>() - cover["low_68"].get<double>(), 0.2);
  EXPECT_WITHIN_RELATIVE(found["dust_extinction_per_m"]["median"].get<double>(), 5e-6, 0.25,
                         "the same");
}

TEST_F(FitThoroughly, OfMagnitudesFindsTheCloudAndSaysWhatItCannotTell) {
  std::string list = "# of air with half of its limb under cloud\ninstant,band,magnitude,error\n";
  const auto outcome =
      coppermoon(words_of("brightness {} --dust-extinction 2e-6 --cloud-cover 0.5 --atmosphere "
                          "undated --albedo-map built-in --json",
                          deep));
  expect_done(outcome);
  const auto magnitudes = json::parse(outcome.out)["magnitudes"];
  for (const char* band : {"B", "V", "R"})
    list += fmt::format("{},{},{:.4f},0.02\n", deep, band, magnitudes[band].get<double>());
  file("list.csv", list);
  const auto found = fit("--magnitudes list.csv --atmosphere undated");
  EXPECT_LT(found["chi_squared"], 1) << "the same computation: 1 % of light, 0.03 mag allowed";
  EXPECT_LT(found["cloud_cover"]["low_68"], 0.55);
  EXPECT_GT(found["cloud_cover"]["high_68"], 0.45);
  // three numbers, three unknowns that are alike: dust hides behind cloud
  EXPECT_LT(found["correlation"]["aerosol_cloud"], -0.5);
}

TEST_F(FitThoroughly, SaysThatNoAirExplainsWhatNoneDoes) {
  file("list.csv", std::string("instant,band,magnitude\n") + deep + ",V,-11\n" + deep + ",B,-2\n");
  const Words words = "fit --magnitudes list.csv --albedo-map built-in";
  const auto refused = coppermoon(words);
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.out, "");
  EXPECT_TRUE(refused.err.starts_with("coppermoon: no air explains this: chi squared = "))
      << refused.err;
  EXPECT_SAYS(refused.err, " of 2 numbers, allowed up to 10.0; likely: a list of another eclipse");
  auto despite = words;
  despite += "--despite-misfit --json";
  const auto answered = coppermoon(despite);
  EXPECT_EQ(answered.status, 0);
  EXPECT_TRUE(answered.err.starts_with("coppermoon: no air explains this")) << answered.err;
  EXPECT_EQ(json::parse(answered.out)["explained"], false);
}

TEST_F(FitThoroughly, RefusesWhatItCannotExplain) {
  EXPECT_EQ(refused({}),
            "coppermoon: photographs or --magnitudes are missing: there is nothing to explain\n");
  EXPECT_EQ(refused({"a.png"}),
            "coppermoon: --instants is missing: photographs need the moments when they were taken "
            "(UTC)\n");
  EXPECT_EQ(refused("a.png b.png c.png --instants 2018-07-27T20:40:00Z,x"),
            "coppermoon: 2 instants, allowed one for all or 3, one for each photograph\n");
  EXPECT_EQ(refused("--magnitudes no.csv"), "coppermoon: no.csv: cannot be read: no such file\n");
  file("a.csv", "when,band,magnitude\n");
  EXPECT_EQ(refused("--magnitudes a.csv"),
            "coppermoon: a.csv:1: columns = when,band,magnitude, allowed instant, band, magnitude "
            "and, if "
            "you like, error, each once, with commas between\n");
  file("b.csv", "instant,band,magnitude\n2018-07-27T20:40:00Z,K,3\n");
  EXPECT_EQ(refused("--magnitudes b.csv"), "coppermoon: b.csv:2: band = K, allowed B, V or R\n");
  file("c.csv", "instant,band,magnitude\n2018-07-27T20:40:00Z,V\n");
  EXPECT_EQ(refused("--magnitudes c.csv"),
            "coppermoon: c.csv:2: a line of fewer columns than the first\n");
  file("d.csv", "instant,band,magnitude\n2018-07-28T20:40:00Z,V,3\n");
  EXPECT_SAYS(refused("--magnitudes d.csv"), "no lunar eclipse");
  run("oiiotool --create 20x10 3 -o dot.png");
  EXPECT_EQ(refused("dot.png --instants 2018-07-27T20:40:00Z --albedo-map built-in"),
            "coppermoon: dot.png: height of a picture [pixels] = 10, allowed 16 to 65535\n");
}

}  // namespace coppermoon::end_to_end::fit_test
