// SPDX-License-Identifier: MIT
// Cameras by their spectral sensitivities, against the CIE observer, colour-science and Adobe's matrices.
#include "colour/camera_spectra.h"

#include <glm/matrix.hpp>

#include "baker/texture/scratch_folder.h"
#include "colour/camera.h"
#include "colour/cie_observer.h"
#include "colour/working_space.h"
#include "support/luther_camera.h"
#include "support/testing.h"

namespace coppermoon::colour::camera_spectra_test {

namespace fs = std::filesystem;

std::vector<double> edges(double width_nm) {
  std::vector<double> all;
  for (double edge = 380; edge <= 780; edge += width_nm) all.push_back(edge);
  return all;
}

algebra::Table table_of(const std::string& name) {
  std::ifstream file(fs::path(COPPERMOON_TEST_DATA) / ".." / "colour" / "data" / name);
  return algebra::parse_table(std::string(std::istreambuf_iterator<char>(file), {}), name);
}

class CameraSpectraTest : public ::testing::Test {
 protected:
  ~CameraSpectraTest() override { fs::remove(file_); }

  std::string file(const std::string& text) const {
    std::ofstream(file_) << text;
    return file_;
  }

  /// Error of a file of that text, without the file's name.
  std::string refusal(const std::string& text) const {
    const auto said = refusal_of([&] { camera_spectra(file(text)); });
    return said.starts_with(file_) ? said.substr(file_.size()) : said;
  }

 private:
  std::string file_ =
      fs::path(::testing::TempDir()) /
      fmt::format("camera_{}.csv", ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(CameraSpectraTest, OfCombinationsOfTheObserverSeesAsTheObserver) {
  const auto camera = camera_spectra(file(luther_camera()));
  EXPECT_WITHIN(camera.most_delta_e, 0, 1e-6, "rounding");
  for (const double width : {1., 5., 20.}) {
    const auto seen = xyz_weights(edges(width), camera), by_cie = xyz_weights(edges(width));
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t b = 0; b < seen.columns(); ++b)
        EXPECT_WITHIN(seen(k, b), by_cie(k, b), 1e-7 * 683 * width, "rounding")
            << k << ", band " << b << " of " << width << " nm";
  }
}

TEST_F(CameraSpectraTest, KeepsDaylightWhiteAndAsBright) {
  const auto daylight = table_of("colour_checker.csv");
  const std::array<std::string, 1> d65{"d65"};
  const auto bands = edges(1);
  const auto light = band_integrals(daylight, d65, bands);
  const auto by_cie = xyz_weights(bands);
  const auto xyz_of = [&](const algebra::Grid<double>& weights) {
    glm::dvec3 xyz(0);
    for (int k = 0; k < 3; ++k)
      for (std::size_t b = 0; b < weights.columns(); ++b)
        xyz[k] += weights(static_cast<std::size_t>(k), b) * light(0, b);
    return xyz;
  };
  const auto white = xyz_of(by_cie);
  EXPECT_WITHIN(white.x / (white.x + white.y + white.z), 0.3127, 1e-4, "CIE 15; 1 nm bands");
  EXPECT_WITHIN(white.y / (white.x + white.y + white.z), 0.3290, 1e-4, "CIE 15; 1 nm bands");
  for (const auto& name : camera_spectra_names()) {
    const auto seen = xyz_of(xyz_weights(bands, camera_spectra(name)));
    for (int k = 0; k < 3; ++k) EXPECT_WITHIN_RELATIVE(seen[k], white[k], 1e-6, "rounding") << name;
  }
}

// mean and largest CIEDE2000 by the Python package colour-science 0.4.7, from the files that the table is rounded from,
// every 5 nm
TEST_F(CameraSpectraTest, HaveTheColourErrorsOfAnotherProgram) {
  const std::vector<std::tuple<std::string, double, double>> published{
      {"canon-eos-5d-mark-ii", 0.72, 1.95}, {"canon-eos-5d-mark-iii", 0.65, 2.05},
      {"canon-eos-600d", 0.69, 2.00},       {"canon-eos-200d", 0.89, 2.53},
      {"canon-eos-r6", 0.79, 2.09},         {"nikon-d5100", 0.88, 3.31},
      {"nikon-d5300", 0.84, 3.14},          {"nikon-d810", 0.84, 3.02},
      {"nikon-d850", 0.87, 2.91},           {"sony-ilce-7m3", 0.71, 2.19},
      {"sony-ilce-7sm2", 0.85, 2.53},       {"fujifilm-x-t3", 1.33, 4.28},
  };
  ASSERT_EQ(camera_spectra_names().size(), published.size());
  for (const auto& [name, mean, most] : published) {
    const auto camera = camera_spectra(name);
    EXPECT_WITHIN(camera.mean_delta_e, mean, 0.03, "spectra of three digits, patches every 10 nm")
        << name;
    EXPECT_WITHIN(camera.most_delta_e, most, 0.1, "spectra of three digits, patches every 10 nm")
        << name;
    EXPECT_GT(camera.mean_delta_e, 0.6);  // as camera_spectra.h says
    EXPECT_LT(camera.mean_delta_e, 1.4);
    EXPECT_LT(camera.most_delta_e, 4.3);
  }
}

TEST_F(CameraSpectraTest, HaveTheMatrixThatAdobePublishes) {
  const auto here = response_named("canon-eos-5d-mark-iii"), there = response_named("canon-5d3");
  for (int k = 0; k < 3; ++k) {
    EXPECT_WITHIN(here.sensitivity[k], there.sensitivity[k], 0.05, "two specimens, another lens");
    for (int c = 0; c < 3; ++c)
      EXPECT_WITHIN(here.from_xyz[c][k], there.from_xyz[c][k], 0.12, "another set of colours")
          << c << k;
  }
}

TEST_F(CameraSpectraTest, ChannelsAreThoseOfTheSensor) {
  for (const auto& name : camera_spectra_names()) {
    const auto camera = camera_spectra(name);
    const auto sensor = response_named(name);
    // what a narrow line gives each channel, by way of XYZ, is what the curves themselves say
    const std::array line{589., 590.};
    const auto weights = xyz_weights(line, camera);
    const auto channels = sensor.from_xyz * glm::dvec3(weights(0, 0), weights(1, 0), weights(2, 0));
    const std::array<std::string, 3> names{"r", "g", "b"};
    const auto curves = band_integrals(camera.table, names, line);
    const double scale = channels.g / (curves(1, 0) / camera.daylight.g);
    for (int k = 0; k < 3; ++k)
      EXPECT_WITHIN(channels[k],
                    scale * curves(static_cast<std::size_t>(k), 0) / camera.daylight[k],
                    2e-3 * channels.g, "D65 by 400 bands, and by its chromaticity")
          << name;
  }
}

TEST_F(CameraSpectraTest, DeepRedIsSeenByTheRedChannelAlone) {
  for (const auto& name : camera_spectra_names()) {
    const std::array deep{650., 660.};
    const auto rgb = channel_weights(WorkingSpace::linear_rec709, deep, name),
               cie = channel_weights(WorkingSpace::linear_rec709, deep);
    EXPECT_GT(rgb(0, 0), 3 * std::abs(rgb(1, 0))) << name;
    EXPECT_GT(cie(0, 0), 3 * std::abs(cie(1, 0)));
  }
}

TEST_F(CameraSpectraTest, AreFoundByTheNamesInHeaders) {
  EXPECT_EQ(spectral_camera_of("Canon EOS 600D"), "canon-eos-600d");
  EXPECT_EQ(spectral_camera_of("NIKON CORPORATION NIKON D810"), "nikon-d810");
  EXPECT_EQ(spectral_camera_of("ILCE-7M3"), "sony-ilce-7m3");
  EXPECT_EQ(spectral_camera_of("FUJIFILM X-T30"), std::nullopt);
  EXPECT_EQ(spectral_camera_of(""), std::nullopt);
}

TEST_F(CameraSpectraTest, ResponsesOfMatricesAloneLeaveTheObserver) {
  const auto bands = edges(20);
  for (const char* name : {"", "colorimetric", "luminance", "canon-6d"})
    EXPECT_TRUE(std::ranges::equal(channel_weights(WorkingSpace::acescg, bands, name).values(),
                                   channel_weights(WorkingSpace::acescg, bands).values()))
        << name;
}

std::string rows_of(const std::string& header, int rows, double from = 400, double step = 30) {
  std::string text = header;
  for (int i = 0; i < rows; ++i)
    text += fmt::format("{},{},{},{}\n", from + step * i, 1 + i, 20 - i, i % 3);
  return text;
}

TEST_F(CameraSpectraTest, AreRefusedInOneLine) {
  const std::string header = "wavelength_nm,r,g,b\n";
  EXPECT_EQ(refusal(rows_of(header, 12)), "");
  EXPECT_EQ(refusal(""), ": empty table");
  EXPECT_EQ(refusal(header), ": no column wavelength_nm, allowed wavelength_nm, r, g, b");
  EXPECT_EQ(refusal(rows_of("nm,r,g,b\n", 12)),
            ": no column wavelength_nm, allowed wavelength_nm, r, g, b");
  EXPECT_EQ(refusal(rows_of("", 12)), ": no column wavelength_nm, allowed wavelength_nm, r, g, b");
  EXPECT_EQ(refusal(rows_of(header, 9)), ": 9 rows of numbers, allowed 10 to 100000");
  EXPECT_EQ(refusal(rows_of(header, 12) + "500,1,1,1\n"),
            ": wavelength [nm] = 500 in row 13, allowed above that of the row before");
  EXPECT_EQ(refusal(rows_of(header, 12) + "900,1,-0.5,1\n"),
            ": g = -0.5 at 900 nm, allowed 0 to 1e6");
  for (const char* no_number : {"nan", "inf", "", "x", "1e400"})
    EXPECT_NE(refusal(rows_of(header, 12) + fmt::format("900,1,{},1\n", no_number)), "");
  EXPECT_EQ(refusal(rows_of(header, 12) + "900,1,1\n"), ":14: 3 cells, expected 4");
  EXPECT_EQ(refusal(rows_of(header, 12, 800)),
            ": column r is 0 from 380 to 780 nm, allowed a channel that sees light");
  std::string grey = header;
  for (int i = 0; i < 12; ++i) grey += fmt::format("{},1,1,1\n", 400 + 30 * i);
  EXPECT_EQ(refusal(grey),
            ": columns r, g and b tell no colours, allowed three curves that differ");
  EXPECT_ERROR(camera_spectra("lost.csv"), "lost.csv: no such file");
  EXPECT_ERROR(camera_spectra("eye"), "response = eye, allowed colorimetric, canon-eos-5d-mark-ii");
  EXPECT_ERROR(response_named("eye"),
               "sony-ilce-7m3, sony-ilce-7sm2, fujifilm-x-t3, or a .csv file");
  EXPECT_ERROR(require_spectral("canon-6d"), "response = canon-6d, allowed colorimetric");
  EXPECT_NO_THROW(require_spectral("colorimetric"));
}

}  // namespace coppermoon::colour::camera_spectra_test
