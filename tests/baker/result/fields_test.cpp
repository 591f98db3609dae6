// SPDX-License-Identifier: MIT
#include "result/fields.h"

#include <gtest/gtest.h>

#include "baker/result/lamp.h"

namespace coppermoon::result::fields_test {

TEST(Fields, AreKnownByTheTypeAlone) {
  const auto fields = fields_of<Lamp>();
  EXPECT_EQ(fields.name, "Lamp");
  ASSERT_EQ(fields.all.size(), 10U);
  const std::vector<Kind> kinds{Kind::instant, Kind::number, Kind::word,   Kind::by_name,
                                Kind::number,  Kind::text,   Kind::object, Kind::list,
                                Kind::numbers, Kind::truth};
  for (std::size_t i = 0; i < kinds.size(); ++i)
    EXPECT_EQ(fields.all[i].kind, kinds[i]) << fields.all[i].key;
  EXPECT_EQ(fields.all[2].words, (std::vector<std::string>{"oil", "gas"}));
  EXPECT_EQ(fields.all[7].type, "Wick");
  EXPECT_EQ(fields.all[7].parts[0].unit, "mm");
}

TEST(Fields, SayWhereAValueMayBeMissing) {
  const auto all = fields_of<Lamp>().all;
  EXPECT_FALSE(all[0].may_be_none);
  EXPECT_TRUE(all[4].may_be_none && !all[4].may_be_absent) << "null";
  EXPECT_TRUE(all[5].may_be_none && all[5].may_be_absent) << "left out";
  EXPECT_TRUE(all[6].may_be_absent) << "a part";
}

TEST(Fields, AreDocumentsWithUnitsAndMeanings) {
  const auto json = as_json(fields_of_each<Wick>());
  EXPECT_EQ(json["many"], true);
  EXPECT_EQ(json["fields"][0].dump(),
            R"({"key":"height_mm","kind":"number","unit":"mm","meaning":"its height"})");
  EXPECT_EQ(meaning_of(fields_of<Wick>().all[0]), "its height [mm]");
}

}  // namespace coppermoon::result::fields_test
