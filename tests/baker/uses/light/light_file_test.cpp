// SPDX-License-Identifier: MIT
#include "uses/light/light_file.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <nlohmann/json.hpp>

#include "almanac/instant.h"
#include "files/fingerprint.h"
#include "support/testing.h"

namespace coppermoon::uses::light_file_test {

namespace fs = std::filesystem;
using nlohmann::json;

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class LightFile : public testing::Test {
 protected:
  LightFile() {
    auto name = (fs::temp_directory_path() / "coppermoon-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    LightRequest request;
    request.wish.tolerance = 0.1;
    light_ = light_on_the_moon(request,
                               almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z")));
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
  const auto kept = read_light(path());
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->key, key);
  const auto* read = &kept->light;
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

TEST_F(LightFile, ThatIsNotThereIsNotTaken) { EXPECT_FALSE(read_light(folder_ / "none")); }

TEST_F(LightFile, WithAnyBitSpoiltIsNotTaken) {
  const auto whole = bytes_of(path());
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 200) {
    auto bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    spoil(bytes);
    EXPECT_FALSE(read_light(path())) << "byte " << at;
  }
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{15}, std::size_t{16}, whole.size() / 2, whole.size() - 1}) {
    spoil(whole.substr(0, length));
    EXPECT_FALSE(read_light(path())) << length << " bytes";
  }
  spoil(whole + "x");
  EXPECT_FALSE(read_light(path()));
  spoil(whole);
  EXPECT_TRUE(read_light(path()));
}

/// A file with a fingerprint that is right, and a header that somebody wrote.
std::string forged(const std::string& whole, const std::string& pointer, const json& value) {
  const auto line = whole.find('\n');
  auto header = json::parse(whole.substr(0, line));
  header[json::json_pointer(pointer)] = value;
  const auto bytes = header.dump() + whole.substr(line, whole.size() - line - 16);
  return bytes + fmt::format("{:016x}", files::fingerprint(bytes));
}

TEST_F(LightFile, ThatNoLightIsLikeIsNotTaken) {
  const auto whole = bytes_of(path());
  spoil(forged(whole, "/key", key));
  EXPECT_TRUE(read_light(path())) << "the forger's own work is sound";
  const auto two = json::array({1e6, 1e6});
  for (const auto& [pointer, value] :
       std::vector<std::pair<std::string, json>>{{"/sun_distance_m", 1.},
                                                 {"/sun_distance_m", "far"},
                                                 {"/depths_m", json::array()},
                                                 {"/depths_m", json::array({4.1e8, 4.0e8})},
                                                 {"/wavelengths_nm", json::array()},
                                                 {"/wavelengths_nm/0", 1e9},
                                                 {"/axis_distances_m", json::array()},
                                                 {"/axis_distances_m", two},
                                                 {"/axis_distances_m/1", -1.},
                                                 {"/sectors", 0},
                                                 {"/sectors", std::uint64_t{1} << 62},
                                                 {"/sectors", -1},
                                                 {"/range", json::array({0, 0, 1e-3})},
                                                 {"/range", json::array({0, 1e7})},
                                                 {"/range", json::array({-1e9, 1e7, 1e-3})},
                                                 {"/range", json::array({0, 1e300, 1e-3})},
                                                 {"/range", json::array({0, 1e7, 0})},
                                                 {"/range_sectors", json::array({1000, 1})},
                                                 {"/range_sectors", json::array({0, 0})},
                                                 {"/error_found", -1},
                                                 {"/plan/method", 17},
                                                 {"/plan/photons", -5},
                                                 {"/plan/knobs", json::array({0, 300, 3, 2})},
                                                 {"/plan/knobs", json::array({20, 1, 3, 2})},
                                                 {"/plan/knobs", json::array({20, 300, 7, 2})},
                                                 {"/plan/knobs", json::array({20, 300, 3, 0})},
                                                 {"/plan/place_error", 0},
                                                 {"/plan/tolerance", -1},
                                                 {"/plan", json::object()}}) {
    spoil(forged(whole, pointer, value));
    EXPECT_FALSE(read_light(path())) << pointer << " = " << value;
  }
}

TEST_F(LightFile, OfNumbersThatNoLightHasIsNotTaken) {
  const auto set_all = [&](double value) {
    auto light = light_;
    for (auto& grid : light.refracted->ratio) std::ranges::fill(grid.values(), value);
    write_light(path(), key, light);
  };
  set_all(0.5);
  EXPECT_TRUE(read_light(path()));
  for (const double value : {-1e-9, 1.1, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    set_all(value);
    EXPECT_FALSE(read_light(path())) << value;
  }
}

TEST_F(LightFile, IsARegularOne) {
  fs::create_directory(folder_ / "a folder");
  EXPECT_THROW(read_light(folder_ / "a folder"), algebra::Error);
  ASSERT_EQ(::mkfifo((folder_ / "a pipe").c_str(), 0666), 0);
  EXPECT_THROW(read_light(folder_ / "a pipe"), algebra::Error);
}

}  // namespace coppermoon::uses::light_file_test
