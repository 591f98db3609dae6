// SPDX-License-Identifier: MIT
#include "result/as_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "baker/result/lamp.h"
#include "result/columns.h"

namespace coppermoon::result::as_json_test {

TEST(AsJson, HasTheKeysInTheOrderOfTheDescription) {
  Lamp lamp;
  EXPECT_EQ(as_json(lamp).dump(),
            R"({"lit":"1503-07-27T20:21:46Z","tilt_deg":45.0,"kind":"oil",)"
            R"("colours":{"red":1.0,"blue":0.25},"soot":null,)"
            R"("spares":[{"height_mm":1.0,"burnt":0.5},{"height_mm":3.0,"burnt":null}],)"
            R"("flicker":[1.0,2.0],"warm":true})");
  lamp.maker = "Argand";
  lamp.wick = Wick{};
  EXPECT_EQ(as_json(lamp)["maker"], "Argand");
  EXPECT_EQ(as_json(lamp)["wick"]["height_mm"], 2);
}

TEST(AsJson, WritesInstantsInTheCalendarAndDecimalsAskedFor) {
  EXPECT_EQ(as_json(Lamp{}, {.calendar = almanac::Calendar::julian, .decimals = 3})["lit"],
            "1503-07-17T20:21:45.678Z");
}

TEST(AsJson, OfANumberThatIsNotFiniteIsNull) {
  EXPECT_TRUE(json_of(std::numeric_limits<double>::infinity(), {}).is_null());
  EXPECT_TRUE(json_of(std::nan(""), {}).is_null());
}

TEST(AsCsv, HasARowForEachAndLeavesCellsWithoutAValueEmpty) {
  EXPECT_EQ(as_csv(std::vector<Wick>{{1, 0.5}, {3, {}}}), "height_mm,burnt\n1.0,0.5\n3.0,\n");
  EXPECT_EQ(as_csv(Json::array({{{"a", "one, two"}, {"b", true}}})), "a,b\n\"one, two\",true\n");
  EXPECT_EQ(as_csv(Json::array({{{"a", "12\" tube"}, {"b", {"x", "y"}}}})),
            "a,b\n\"12\"\" tube\",\"[\"\"x\"\",\"\"y\"\"]\"\n")
      << "RFC 4180";
}

TEST(AsLines, HaveNumbersInTheFormatAskedFor) {
  EXPECT_EQ(as_lines(as_json(Wick{}), "{:.3f}"),
            "height_mm                     2.000\nburnt                         \n");
}

TEST(ColumnsOf, GatherNumbersAloneAndAnglesInDegrees) {
  Lamp sooty;
  sooty.soot = 0.5;
  const auto columns = columns_of(std::vector<Lamp>{{}, sooty});
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_EQ(columns[0].first, "tilt_deg");
  EXPECT_DOUBLE_EQ(columns[0].second[1], 45);
  EXPECT_EQ(columns[1].first, "soot");
  EXPECT_TRUE(std::isnan(columns[1].second[0]));
  EXPECT_EQ(columns[1].second[1], 0.5);
}

}  // namespace coppermoon::result::as_json_test
