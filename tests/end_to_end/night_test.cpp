// SPDX-License-Identifier: MIT
// Nights under an eclipse, as `night` plans them and `almanac` lists them.
#include <nlohmann/json.hpp>

#include "support/csv_rows.h"
#include "support/program.h"

namespace coppermoon::end_to_end::night_test {

class Night : public ProgramTest {
 protected:
  static Words night(const Words& more) {
    return Words(
               "night 2018-07-27 --atmosphere undated --albedo-map built-in --danjon-spread off") +
           more;
  }

  /// Each moment of a document is a row of the table.
  static void expect_rows_of(const nlohmann::json& moments,
                             const std::vector<std::map<std::string, std::string>>& rows) {
    ASSERT_EQ(rows.size(), moments.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto& moment = moments[i];
      const auto& row = rows[i];
      EXPECT_EQ(row.at("name"), moment["name"].get<std::string>());
      for (const char* text : {"utc", "local", "zone"})
        EXPECT_EQ(row.at(text), moment[text].get<std::string>());
      for (const char* what : {"up", "seen"})
        EXPECT_EQ(row.at(what) == "true", moment[what].get<bool>());
      EXPECT_EQ(row.at("twilight"), moment["twilight"].get<std::string>());
      for (const char* angle : {"altitude_deg", "azimuth_deg", "sun_altitude_deg"})
        EXPECT_WITHIN(std::stod(row.at(angle)), moment[angle].get<double>(), 6e-4,
                      "three decimals");
      for (const char* light : {"V_magnitude", "mean_luminance_cd_m2", "faintest_star"}) {
        const auto told = moment.value(light, nlohmann::json());
        EXPECT_EQ(row.at(light).empty(), told.is_null()) << light << " of " << moment;
        if (told.is_null()) continue;
        const double number = told;
        EXPECT_WITHIN(std::stod(row.at(light)), number, 6e-3 + 1e-5 * std::abs(number),
                      "two decimals, or six digits");
      }
    }
  }
};

TEST_F(Night, IsToldInATableADocumentAndFiles) {
  const auto table = coppermoon(night("--at London --focal-length 600 -o night.ics"));
  expect_done(table);
  EXPECT_SAYS(table.out, "Total eclipse of the Moon, 2018-07-27\nLondon: The Moon rises");
  EXPECT_SAYS(table.out, "Exposure times at f/12.1, ISO 800");
  EXPECT_TRUE(
      table.out.ends_with("\n\nWithout a mount that follows it, the Moon trails by two pixels in "
                          "1/4.9 s.\n\nnight.ics\n"))
      << "below the table, what was written";
  const auto files =
      coppermoon(night("--at 51.5,-0.1 --f-number 8 --csv -o a.ics -o a.csv -o a.json"));
  expect_done(files);
  EXPECT_TRUE(text_of(here("a.ics")).starts_with("BEGIN:VCALENDAR\r\n"));
  // as a reader of calendars that is not ours has it: python3-icalendar
  const auto events = run(
      {"/usr/bin/python3", "-c",
       "import datetime, icalendar\n"
       "now = datetime.datetime.now(datetime.timezone.utc)\n"
       "for e in icalendar.Calendar.from_ical(open('a.ics', 'rb').read()).walk('VEVENT'):\n"
       "  assert e.errors == [] and abs(now - e['DTSTAMP'].dt) < datetime.timedelta(minutes=9)\n"
       "  end = e['DTEND'].dt.strftime('%H:%M') if 'DTEND' in e else '-'\n"
       "  print(e['UID'], e['DTSTART'].dt.strftime('%d %H:%M'), end)"});
  expect_done(events);
  EXPECT_EQ(events.out,
            "2018-07-27-eclipse+51.5000-0.1000@coppermoon 27 19:49 23:28\n"
            "2018-07-27-first+51.5000-0.1000@coppermoon 27 20:33 -\n"
            "2018-07-27-U3+51.5000-0.1000@coppermoon 27 21:13 -\n"
            "2018-07-27-U4+51.5000-0.1000@coppermoon 27 22:19 -\n"
            "2018-07-27-P4+51.5000-0.1000@coppermoon 27 23:28 -\n");
  const auto csv = text_of(here("a.csv"));
  EXPECT_TRUE(csv.starts_with("name,utc,local,"));
  EXPECT_EQ(files.out, csv) << "--csv prints it, and nothing beside";
  const auto document = nlohmann::json::parse(text_of(here("a.json")));
  EXPECT_EQ(document["time_zone"], "Europe/London") << "of the nearest city";
  EXPECT_EQ(document["f_number"], 8);
  EXPECT_EQ(document["moments"][0]["zone"], "BST");
  ASSERT_EQ(document["moments"].size(), 10U) << "seven contacts, moonrise, moonset, first seen";
  for (const auto& moment : document["moments"])
    EXPECT_EQ(moment["up"].get<bool>(), moment["utc"] >= "2018-07-27T19:49") << moment;
  expect_rows_of(document["moments"], csv_rows(csv));
  EXPECT_TRUE(document["moments"][0]["faintest_star"].is_null()) << "P1: before sunset";
  EXPECT_GT(document["moments"][8]["faintest_star"], 2);
  EXPECT_EQ(document["moments"][5]["name"], "first seen");
  EXPECT_NEAR(document["durations_s"]["total"].get<double>(), 6180, 60) << "Espenak: 103 min";
}

TEST_F(Night, BeforeTheFirstYearIsATableButNoCalendar) {
  const Words ancient =
      "night -0567-07-04 --calendar julian --at Baghdad --danjon-spread off --rays 30 --bands 6 "
      "--atmosphere undated -o b.csv";
  EXPECT_EQ(coppermoon(ancient + "-o b.ics").err,
            "coppermoon: eclipse of -0567-07-04: iCalendar has no years before 1, allowed .csv or "
            ".json\n");
  EXPECT_EQ(listing(), std::set<std::string>{}) << "refused before anything is written";
  expect_done(coppermoon(ancient));
  for (const auto& row : csv_rows(text_of(here("b.csv"))))
    for (const char* time : {"utc", "local"})
      EXPECT_TRUE(row.at(time).starts_with("-0567-07-04T")) << row.at(time);
}

TEST_F(Night, OfAPlaceThatSeesNothingIsShortAndNoEvent) {
  const auto table = coppermoon(night("--at Chicago"));
  expect_done(table);
  EXPECT_SAYS(table.out, "Nothing of the eclipse is seen");
  EXPECT_SAYS_NOT(table.out, "Exposure times");
  EXPECT_EQ(coppermoon(night("--at Chicago -o a.ics")).err,
            "coppermoon: Chicago sees nothing of the eclipse: no event for a calendar\n");
  EXPECT_EQ(listing(), std::set<std::string>{});
}

TEST_F(Night, HasTheAltitudeOfSky) {
  const auto document = coppermoon(night("--at London --json"));
  expect_done(document);
  const auto u4 = nlohmann::json::parse(document.out)["moments"][7];
  ASSERT_EQ(u4["name"], "U4");
  const auto sky = coppermoon(words_of("sky {} --at London --json", u4["utc"]));
  expect_done(sky);
  EXPECT_NEAR(nlohmann::json::parse(sky.out)["altitude_deg"].get<double>(),
              u4["altitude_deg"].get<double>(), 0.003)
      << "both apparent; half a second of the sky's turn, as times are printed to one";
}

TEST_F(Night, OfNoPlaceOrOfAnotherFileIsRefused) {
  EXPECT_EQ(coppermoon("night 2018-07-27").err,
            "coppermoon: --at: missing; a place is needed, as Honolulu\n");
  EXPECT_EQ(
      coppermoon("night 2018-07-27 --at London -o a.gif").err,
      "coppermoon: a.gif: a night ends in .ics (calendar), .csv (moments), .json (moments and "
      "exposures), .png (map of where the eclipse is seen), .svg (the same), .pdf (the same)\n");
  EXPECT_SAYS(coppermoon("night 2018-07-27 --at London --zone Moon/Tycho").err,
              "time zone = Moon/Tycho: not in this system's zoneinfo");
  EXPECT_EQ(listing(), std::set<std::string>{});
}

TEST_F(Night, OfTheAlmanacSaysWhichContactsAreSeen) {
  const auto seen = [&](const char* place) {
    const auto list =
        coppermoon(words_of("almanac --from 2018-07-01 --to 2018-08-01 --at {} --json", place));
    expect_done(list);
    return nlohmann::json::parse(list.out)[0]["seen"].get<std::string>();
  };
  // the Moon stood over Madagascar; America saw nothing
  EXPECT_EQ(seen("Nairobi"), "all");
  EXPECT_EQ(seen("London"), "U3 to P4")
      << "it rose 19 min into totality, and stood out after greatest";
  EXPECT_EQ(seen("Chicago"), "none");
  EXPECT_EQ(coppermoon({"almanac"}).status, 0) << "from today, for ten years";
  const auto columbus =
      coppermoon("almanac --from 1504-01-01 --to 1504-06-01 --calendar julian --json");
  expect_done(columbus);
  const auto listed = nlohmann::json::parse(columbus.out);
  EXPECT_EQ(listed[0]["calendar"], "julian");
  EXPECT_EQ(listed[0]["contacts"]["P1"].get<std::string>().substr(0, 10), "1504-02-29");
  EXPECT_EQ(listed[0]["contacts"]["U2"].get<std::string>().substr(0, 10), "1504-03-01");
}

using AlmanacFiles = ProgramTest;

TEST_F(AlmanacFiles, HoldWhatIsPrinted) {
  const Words almanac = "almanac 2018 --at London";
  const auto table = coppermoon(almanac + "-o a.csv -o a.json -o a.ics");
  expect_done(table);
  EXPECT_SAYS(table.out, "2018-07-27T20:21:45Z total");
  EXPECT_TRUE(table.out.ends_with(
      "\n\na.csv\na.json\na.ics\nThe calendar leaves out 1 of 2 eclipses, of which nothing is seen "
      "there.\n"));
  EXPECT_EQ(coppermoon(almanac + Words{"--csv"}).out, text_of(here("a.csv")));
  EXPECT_EQ(coppermoon("almanac --year 2018 --at London --json").out, text_of(here("a.json")));
  EXPECT_EQ(csv_rows(text_of(here("a.csv"))).size(), 2U) << "31 January and 27 July";
  const auto calendar = text_of(here("a.ics"));
  EXPECT_SAYS(calendar, "UID:2018-07-27-eclipse+51.5");
  EXPECT_SAYS(calendar, "LOCATION:London\r\n");
}

TEST_F(AlmanacFiles, AreRefusedWhereTheyCannotBe) {
  EXPECT_EQ(coppermoon("almanac 2018 -o a.txt").err,
            "coppermoon: a.txt: an almanac ends in .ics (calendar), .csv (table), .json (JSON "
            "document)\n");
  EXPECT_SAYS(coppermoon("almanac -600 -o a.csv -o a.ics").err, "iCalendar has no years before 1");
  EXPECT_EQ(coppermoon("almanac 3001").err, "coppermoon: year = 3001, allowed -1999 to 3000\n");
  EXPECT_EQ(coppermoon("almanac 2018 --from 2018-01-01").status, 2);
  EXPECT_EQ(listing(), std::set<std::string>{});
}

TEST_F(AlmanacFiles, KeepTheirColumnsApartInYearsWithASign) {
  const auto list = coppermoon("almanac --year -600 --calendar julian");
  expect_done(list);
  std::istringstream lines(list.out);
  std::string line;
  std::getline(lines, line);
  const auto type = line.find("type");
  for (int rows = 0; rows < 2; ++rows) {
    std::getline(lines, line);
    EXPECT_TRUE(line.starts_with("-0600-")) << line;
    EXPECT_EQ(line[type - 1], ' ') << line;
    EXPECT_EQ(line.substr(type, 1), "p") << line;
  }
}

}  // namespace coppermoon::end_to_end::night_test
