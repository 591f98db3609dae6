// SPDX-License-Identifier: MIT
#include "uses/light/photon_file.h"

#include <unistd.h>
#include <nlohmann/json.hpp>

#include "shadow/by_photons.h"
#include "support/testing.h"

namespace coppermoon::uses::photon_file_test {

using nlohmann::json;

class PhotonSumsFile : public testing::Test {
 protected:
  PhotonSumsFile() {
    shadow::PhotonSettings settings;
    settings.ring_width_m = 500e3;
    settings.key = "air = \"a\nb\"";
    settings.blocks = shadow::BlockRange{3, 12};
    const std::vector<double> waves{450, 650};
    sums = shadow::traced({}, {1.479e11, {3.81e8, 3.83e8}}, waves, settings);
    write_sums(path, sums);
  }
  ~PhotonSumsFile() override { std::filesystem::remove(path); }

  json document() const {
    std::ifstream file(path);
    return json::parse(file);
  }

  /// Expects one line with the path in it.
  void expect_refused(const std::string& text) const {
    std::ofstream(path) << text;
    try {
      read_sums(path);
      ADD_FAILURE() << text.substr(0, 300);
    } catch (const algebra::Error& error) {
      const std::string line = error.what();
      EXPECT_SAYS(line, path.string());
      EXPECT_SAYS_NOT(line, '\n');
    }
  }

  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("photon_sums_" + std::to_string(getpid()));
  shadow::PhotonSums sums;
};

TEST_F(PhotonSumsFile, HoldsWhatWasWrittenToTheLastBit) {
  const auto again = read_sums(path);
  EXPECT_EQ(again.key, sums.key);
  EXPECT_EQ(again.done, sums.done);
  EXPECT_EQ(again.arrangement.depths_m, sums.arrangement.depths_m);
  ASSERT_EQ(again.sum.size(), sums.sum.size());
  for (std::size_t g = 0; g < sums.sum.size(); ++g)
    for (std::size_t i = 0; i < sums.sum[g].values().size(); ++i) {
      EXPECT_EQ(again.sum[g].values()[i], sums.sum[g].values()[i]);
      EXPECT_EQ(again.sum_of_squares[g].values()[i], sums.sum_of_squares[g].values()[i]);
    }
}

TEST_F(PhotonSumsFile, ThatIsNoneIsRefused) {
  expect_refused("");
  expect_refused("{");
  expect_refused("[]");
  expect_refused("{\"kind\": \"another\"}");
  expect_refused("{\"kind\": 5}");
  std::filesystem::remove(path);
  EXPECT_THROW(read_sums(path), algebra::Error);
  EXPECT_THROW(read_sums("/no/such/file"), algebra::Error);
}

TEST_F(PhotonSumsFile, ThatIsCutShortIsRefused) {
  const auto text = document().dump();
  for (const std::size_t length : {text.size() - 1, text.size() / 2, std::size_t{10}})
    expect_refused(text.substr(0, length));
}

TEST_F(PhotonSumsFile, ThatLacksAnythingIsRefused) {
  const auto whole = document();
  for (const auto& [name, value] : whole.items()) {
    auto lacking = whole;
    lacking.erase(name);
    expect_refused(lacking.dump());
    lacking[name] = nullptr;
    expect_refused(lacking.dump());
  }
}

TEST_F(PhotonSumsFile, ThatHoldsWhatSumsCannotIsRefused) {
  const auto whole = document();
  const std::vector<std::pair<std::string, json>> faults{
      {"/version", 2},
      {"/sectors", 2},
      {"/sectors", 0},
      {"/rings", -1},
      {"/rings", 1e30},
      {"/blocks", {{5, 3}}},
      {"/blocks", {{3, 8}, {7, 9}}},
      {"/blocks", {{-3, 8}}},
      {"/wavelengths_nm", {450}},
      {"/sun_distance_m", 1},
      {"/sum_m2/0/0", -1},
      {"/sum_m2/0/0", "text"},
      {"/sum_of_squares_m4/1", json::array()},
  };
  for (const auto& [place, value] : faults) {
    auto wrong = whole;
    wrong[json::json_pointer(place)] = value;
    expect_refused(wrong.dump());
  }
}

}  // namespace coppermoon::uses::photon_file_test
