// SPDX-License-Identifier: MIT
#include "verbs/light_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "almanac/instant.h"

namespace coppermoon::verbs {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class LightFile : public testing::Test {
 protected:
  LightFile() {
    auto name = (fs::temp_directory_path() / "coppermoon-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    LightOptions options;
    options.plan.tolerance = "0.1";
    light_ = light_on_the_moon(
        options, almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z")), false);
    write_light(path(), key, light_);
  }
  ~LightFile() override { fs::remove_all(folder_); }

  fs::path path() const { return folder_ / "eclipse.light"; }

  void spoil(const std::string& bytes) const { std::ofstream(path(), std::ios::binary) << bytes; }

  static constexpr const char* key = "air and Sun\nof one film";
  fs::path folder_;
  Moonlight light_;
};

TEST_F(LightFile, GivesTheVeryLightThatWasWritten) {
  const auto read = read_light(path(), key);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->refracted->wavelengths_nm, light_.refracted->wavelengths_nm);
  EXPECT_EQ(read->refracted->axis_distances_m, light_.refracted->axis_distances_m);
  EXPECT_EQ(read->refracted->arrangement.depths_m, light_.refracted->arrangement.depths_m);
  ASSERT_EQ(read->refracted->ratio.size(), light_.refracted->ratio.size());
  for (std::size_t g = 0; g < read->refracted->ratio.size(); ++g)
    EXPECT_TRUE(std::ranges::equal(read->refracted->ratio[g].values(),
                                   light_.refracted->ratio[g].values()));
  EXPECT_EQ(read->range.from_m, light_.range.from_m);
  EXPECT_EQ(read->range.to_m, light_.range.to_m);
  EXPECT_EQ(read->range.sectors, light_.range.sectors);
  EXPECT_EQ(read->error_found, light_.error_found);
  EXPECT_EQ(read->plan.work.bands, light_.plan.work.bands);
  EXPECT_EQ(read->plan.work.place_error, light_.plan.work.place_error);
  EXPECT_EQ(read->plan.work.scattered_light, light_.plan.work.scattered_light);
  EXPECT_EQ(read->plan.left_out.size(), light_.plan.left_out.size());
}

TEST_F(LightFile, OfAnotherKeyIsNotTaken) {
  EXPECT_FALSE(read_light(path(), "air and Sun\nof another"));
}

TEST_F(LightFile, ThatIsNotThereIsNotTaken) { EXPECT_FALSE(read_light(folder_ / "none", key)); }

TEST_F(LightFile, WithAnyBitSpoiltIsNotTaken) {
  const auto whole = bytes_of(path());
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 200) {
    auto bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    spoil(bytes);
    EXPECT_FALSE(read_light(path(), key)) << "byte " << at;
  }
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{15}, std::size_t{16}, whole.size() / 2, whole.size() - 1}) {
    spoil(whole.substr(0, length));
    EXPECT_FALSE(read_light(path(), key)) << length << " bytes";
  }
  spoil(whole + "x");
  EXPECT_FALSE(read_light(path(), key));
  spoil(whole);
  EXPECT_TRUE(read_light(path(), key));
}

}  // namespace
}  // namespace coppermoon::verbs
