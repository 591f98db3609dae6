// SPDX-License-Identifier: MIT
#include "colour/display.h"

#include <sys/stat.h>
#include <cstdlib>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <regex>

#include "support/testing.h"

namespace coppermoon::colour::display_test {

using enum WorkingSpace;

/// IEC 61966-2-1, extended as an odd function's straight part below 0.
double srgb_code(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

Image image_of(const std::vector<Rgb>& colours) {
  Image image(1, colours.size());
  std::ranges::copy(colours, image.values().begin());
  return image;
}

float grey_shown(float grey, const DisplayTransform& development) {
  return developed(image_of({{grey, grey, grey}}), linear_rec709, development)(0, 0)[1];
}

/// XYZ of a display's red, green and blue, one column each: from the chromaticities (x, y) of its
/// primaries and its white, whose Y is 1.
glm::dmat3 xyz_from_primaries(const glm::dvec2 (&primaries)[3], const glm::dvec2& white) {
  const auto xyz = [](const glm::dvec2& c) { return glm::dvec3(c.x, c.y, 1 - c.x - c.y) / c.y; };
  const glm::dmat3 of_unit_luminance(xyz(primaries[0]), xyz(primaries[1]), xyz(primaries[2]));
  const glm::dvec3 luminance = glm::inverse(of_unit_luminance) * xyz(white);
  return {luminance.x * of_unit_luminance[0], luminance.y * of_unit_luminance[1],
          luminance.z * of_unit_luminance[2]};
}

/// Displays of 100 cd/m² or so: those that have the view Filmic.
std::vector<std::string> standard_dynamic_range() {
  auto names = displays();
  std::erase(names, "Rec.2100-PQ");
  return names;
}

const DisplayTransform untoned{.view = "Un-tone-mapped"};

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(Display, CodesSrgbByTheFormulaOfTheStandard) {
  for (const float grey : {0.0f, 0.001f, 0.0031f, 0.0032f, 0.018f, 0.18f, 0.5f, 1.0f})
    EXPECT_WITHIN(grey_shown(grey, untoned), srgb_code(grey), 2e-5,
                  "the standard's two pieces do not meet exactly; OpenColorIO's do");
}

TEST(Display, LeavesColoursWithoutToneMappingAsTheyAre) {
  const auto shown =
      developed(image_of({{0.5f, 0.05f, -0.01f}, {3.0f, 0.2f, 0.7f}}), linear_rec709, untoned);
  const double linear[2][3] = {{0.5, 0.05, -0.01}, {3.0, 0.2, 0.7}};
  for (std::size_t p = 0; p < 2; ++p)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_WITHIN(shown(0, p)[i], srgb_code(linear[p][i]), 5e-5,
                    "OpenColorIO's slope at 0 is 12.923; not clamped at either end");
}

TEST(Display, ShowsMiddleGreyThroughAcesAtATenthOfWhite) {
  // The ACES output transform puts 0.18 at 4.8 of 48 cd/m²; for video's dim surround, to the power
  // 0.9811.
  EXPECT_WITHIN(grey_shown(0.18f, {.view = "ACES 1.0 SDR Video"}), srgb_code(std::pow(0.1, 0.9811)),
                2e-3, "half an 8-bit step");
}

TEST(Display, RollsHighlightsOffThroughAces) {
  const DisplayTransform aces{.view = "ACES 1.0 SDR Video"};
  EXPECT_LT(grey_shown(1.0f, aces), 0.85f);
  EXPECT_LT(grey_shown(8.0f, aces), 1.0f);
  EXPECT_GT(grey_shown(8.0f, aces), grey_shown(4.0f, aces));
}

TEST(Display, ExposesBeforeTheView) {
  // A full Moon of 5000 cd/m² at 1/20000 is a quarter.
  EXPECT_WITHIN(grey_shown(5000.0f, {.scale = 1 / 20000.0}), srgb_code(0.25), 2e-5,
                "as unexposed greys");
}

TEST(Display, ShowsTheSameColourFromEveryWorkingSpace) {
  const glm::dvec3 xyz{0.35, 0.30, 0.12};
  std::vector<Rgb> shown;
  for (const auto space : {linear_rec709, acescg, ciexyz_d65}) {
    const auto c = channels_from_xyz(space) * xyz;
    const Rgb colour{static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z)};
    shown.push_back(developed(image_of({colour}), space)(0, 0));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_WITHIN(shown[1][i], shown[0][i], 1e-5,
                  "the configuration derives its matrices in floats");
    EXPECT_WITHIN(shown[2][i], shown[0][i], 1e-5,
                  "the configuration derives its matrices in floats");
  }
}

TEST(Display, LeavesRawAlone) {
  const auto shown = developed(image_of({{0.1f, 2.0f, 700.0f}}), acescg, {.view = "Raw"});
  EXPECT_EQ(shown(0, 0), (Rgb{0.1f, 2.0f, 700.0f}));
}

TEST(Display, LogIsAcescct) {
  // ACEScct (S-2016-001): (log2(x) + 9.72) / 17.52, so 0.18 is 0.413588.
  EXPECT_WITHIN(grey_shown(0.18f, {.view = "Log"}), 0.413588, 2e-6, "printed to 6 digits");
}

TEST(Display, ShowsAPictureAsItShowsItsPixels) {
  Image image(300, 7);
  for (std::size_t row = 0; row < image.rows(); ++row)
    for (std::size_t column = 0; column < image.columns(); ++column)
      image(row, column) = {0.003f * static_cast<float>(row), 0.1f * static_cast<float>(column),
                            0.4f};
  const DisplayTransform aces{.view = "ACES 1.0 SDR Video"};
  const auto shown = developed(image, linear_rec709, aces);
  for (const auto row : {0u, 8u, 150u, 299u})
    for (const auto column : {0u, 6u})
      EXPECT_EQ(shown(row, column),
                developed(image_of({image(row, column)}), linear_rec709, aces)(0, 0));
}

TEST(Display, HasTheViewsItPromises) {
  EXPECT_EQ(views(), (std::vector<std::string>{"Hue-preserving", "Un-tone-mapped",
                                               "ACES 1.0 SDR Video", "Filmic", "Log", "Raw"}));
  EXPECT_EQ(displays(), (std::vector<std::string>{"sRGB", "Rec.1886 Rec.709", "P3-D65",
                                                  "Display P3", "Rec.2100-PQ"}));
}

TEST(Display, AndViewAreKnownByTheirNamesInAnyCase) {
  EXPECT_EQ(view_named("aces 1.0 sdr video", "srgb"), "ACES 1.0 SDR Video");
  EXPECT_EQ(display_named("display P3"), "Display P3");
  EXPECT_EQ(grey_shown(0.18f, {.view = "filmic", .display = "SRGB"}),
            grey_shown(0.18f, {.view = "Filmic"}));
}

TEST(Display, ShowsEveryViewOfEveryDisplay) {
  for (const auto& display : displays())
    for (const auto& view : views(display)) {
      const float shown = grey_shown(0.5f, {.view = view, .display = display});
      EXPECT_TRUE(shown > 0 && shown < 1) << display << ", " << view << ": " << shown;
    }
}

TEST(Display, CodesPqByTheFormulaOfTheStandard) {
  // SMPTE ST 2084: 1 of the scene is 100 cd/m², coded 0.508078.
  EXPECT_WITHIN(grey_shown(1.0f, {.display = "Rec.2100-PQ"}), 0.508078, 1e-5,
                "the curve is tabulated");
}

TEST(Display, CodesDisplayP3ByItsDefinition) {
  // SMPTE EG 432-1's primaries, D65 as in IEC 61966-2-1, and that standard's curve.
  const auto xyz_from_p3 =
      xyz_from_primaries({{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}}, {0.3127, 0.3290});
  for (const glm::dvec3 p3 : {glm::dvec3(1, 1, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0),
                              glm::dvec3(0, 0, 1), glm::dvec3(0.8, 0.2, 0.002)}) {
    const glm::vec3 xyz(xyz_from_p3 * p3);
    const auto shown = developed(image_of({{xyz.x, xyz.y, xyz.z}}), ciexyz_d65,
                                 {.view = "Un-tone-mapped", .display = "Display P3"})(0, 0);
    for (int i = 0; i < 3; ++i)
      EXPECT_WITHIN(shown[static_cast<std::size_t>(i)], srgb_code(p3[i]), 5e-5,
                    "the configuration's matrices are floats, and a code near 0 is 13 times light");
  }
}

/// CIE 1976 hue angle about D65 of linear Rec.709 [degrees], by the matrix of IEC 61966-2-1.
double hue_deg(double r, double g, double b) {
  const double X = 0.4124 * r + 0.3576 * g + 0.1805 * b, Y = 0.2126 * r + 0.7152 * g + 0.0722 * b,
               Z = 0.0193 * r + 0.1192 * g + 0.9505 * b, sum = X + 15 * Y + 3 * Z;
  return std::atan2(9 * Y / sum - 0.46834, 4 * X / sum - 0.19784) * 180 / std::numbers::pi;
}

double srgb_light(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

TEST(HuePreserving, LeavesColoursUpToFourFifthsAsTheyAre) {
  const Rgb colours[] = {{0.8f, 0.1f, 0}, {0.02f, 0.3f, 0.79f}, {0.8f, 0.8f, 0.8f}, {0, 0, 0}};
  for (const auto& colour : colours) {
    const auto shown = developed(image_of({colour}), linear_rec709)(0, 0);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_WITHIN(shown[i], srgb_code(static_cast<double>(colour[i])), 5e-5,
                    "a code near 0 is 13 times light, and the matrices are floats");
  }
}

TEST(HuePreserving, KeepsTheAngleOfHueAtAnyExposure) {
  // an umbra, a limb near it, a blue hour, a pink one
  for (const auto& [r, g, b] :
       {Rgb{1, 0.12f, 0.02f}, Rgb{1, 0.59f, 0.36f}, Rgb{0.3f, 0.55f, 1}, Rgb{1, 0.6f, 0.7f}})
    for (double light = 0.05; light < 20; light *= 1.5) {
      const auto k = static_cast<float>(light);
      const auto shown = developed(image_of({{k * r, k * g, k * b}}), linear_rec709)(0, 0);
      EXPECT_LE(std::ranges::max(shown), 1 + 1e-5F) << light;
      if (std::ranges::max(shown) - std::ranges::min(shown) < 0.05F) break;  // it is white
      EXPECT_WITHIN(hue_deg(srgb_light(shown[0]), srgb_light(shown[1]), srgb_light(shown[2])),
                    hue_deg(r, g, b), 0.2, "IEC's matrix has four digits")
          << light;
    }
}

TEST(HuePreserving, ShowsMoreLightBrighterUntilItIsWhite) {
  float before = 0;
  for (float light = 0.01f; light < 6.7f; light *= 1.02f) {
    const float code = grey_shown(light, {});
    EXPECT_GT(code, before) << light;
    before = code;
  }
  const auto burnt = developed(image_of({{1000, 600, 300}}), linear_rec709)(0, 0);
  for (const float code : burnt) EXPECT_WITHIN(code, 1, 1e-5, "the display's matrices are floats");
}

TEST(HuePreserving, BringsWhatIsOutsideTheGamutToItsEdge) {
  const auto shown = developed(image_of({{0.5f, 0.1f, -0.02f}}), linear_rec709)(0, 0);
  EXPECT_WITHIN(shown[2], 0, 1e-5, "the display's matrices are floats");
  EXPECT_WITHIN(srgb_light(shown[1]) / srgb_light(shown[0]), 0.12 / 0.52, 1e-3,
                "white is added until no channel is negative: 0.02 to each");
}

TEST(HuePreserving, OfAHighDynamicRangeHasNoShoulder) {
  const DisplayTransform pq{.display = "Rec.2100-PQ"};
  EXPECT_EQ(grey_shown(5, pq), grey_shown(5, {.view = "Un-tone-mapped", .display = pq.display}));
}

constexpr double filmic_brightest = 2, filmic_darkest = 0x1p-16;

TEST(Filmic, ShowsBothEndsOfTheStopsItStates) {
  EXPECT_SAYS(config_text(), "17 stops, from 2 down to 2^-16");
  for (const auto& display : standard_dynamic_range())
    for (const double end : {filmic_brightest, filmic_darkest}) {
      const float code =
          grey_shown(static_cast<float>(end), {.view = "Filmic", .display = display});
      EXPECT_TRUE(code > 0.05f && code < 0.95f) << display << ", " << end << ": " << code;
    }
}

TEST(Filmic, ShowsMoreLightBrighter) {
  std::vector<Rgb> greys;
  for (float light = 0x1p-20f; light < 4; light *= 1.02f) greys.push_back({light, light, light});
  for (const auto& display : standard_dynamic_range()) {
    const auto shown =
        developed(image_of(greys), linear_rec709, {.view = "Filmic", .display = display});
    for (std::size_t i = 1; i < greys.size(); ++i)
      EXPECT_GT(shown(0, i)[1], shown(0, i - 1)[1]) << display << ", " << greys[i][1];
  }
}

TEST(Filmic, EndsInBlackAndWhite) {
  for (const auto& display : standard_dynamic_range()) {
    const DisplayTransform filmic{.view = "Filmic", .display = display};
    EXPECT_WITHIN(grey_shown(0, filmic), 0, 1e-6, "floats");
    for (const float bright : {16.0f, 1000.0f, 65504.0f})
      EXPECT_WITHIN(grey_shown(bright, filmic), 1, 1e-5, "the display's matrices are floats");
  }
}

TEST(Filmic, KeepsEveryColourWithinTheDisplay) {
  std::vector<Rgb> colours;
  for (int stops = -20; stops <= 6; ++stops)
    for (const Rgb& c :
         {Rgb{1, 0.1f, 0.003f}, Rgb{1, 0, 0}, Rgb{0.1f, 0.3f, 1}, Rgb{1, 0.2f, -0.02f}})
      colours.push_back(
          {std::ldexp(c[0], stops), std::ldexp(c[1], stops), std::ldexp(c[2], stops)});
  const auto shown = developed(image_of(colours), linear_rec709, {.view = "Filmic"});
  for (const Rgb& colour : shown.values())
    for (const float code : colour) EXPECT_WITHIN(code, 0.5, 0.5 + 1e-5, "matrices of floats");
}

TEST(Filmic, KeepsTheHueOfTheUmbraAndMostOfItsRed) {
  // Hue, as in HSV: where the middle channel stands between the least and the greatest.
  // Saturation, 1 - least / greatest, is 0.95 of what it was.
  for (int stops = -12; stops <= 0; stops += 3) {
    const float light = std::ldexp(1.0f, stops);
    const Rgb umbra{light, 0.12f * light, 0.02f * light};
    const auto shown = developed(image_of({umbra}), linear_rec709, {.view = "Filmic"})(0, 0);
    const double r = srgb_light(shown[0]), g = srgb_light(shown[1]), b = srgb_light(shown[2]);
    EXPECT_WITHIN((g - b) / (r - b), 0.10 / 0.98, 2e-3, "five digits of codes as low as 0.02");
    EXPECT_WITHIN(1 - b / r, 0.95 * 0.98, 2e-3, "five digits of codes as low as 0.02");
  }
}

TEST(Display, NamesTheViewsWhenItHasNoSuchView) {
  EXPECT_EQ(
      refusal_of([] { grey_shown(1, {.view = "Sepia"}); }),
      "view = Sepia, allowed Hue-preserving, Un-tone-mapped, ACES 1.0 SDR Video, Filmic, Log, "
      "Raw");
  EXPECT_EQ(refusal_of([] { grey_shown(1, {.display = "CRT"}); }),
            "display = CRT, allowed sRGB, Rec.1886 Rec.709, P3-D65, Display P3, Rec.2100-PQ");
  EXPECT_EQ(refusal_of([] { views("CRT"); }),
            refusal_of([] { grey_shown(1, {.display = "CRT"}); }));
}

TEST(Display, RefusesPixelsThatAreNoNumbers) {
  Image image(2, 3);
  image(1, 2)[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusal_of([&] { developed(image, linear_rec709); }),
            "row 1, column 2: nan exposed by 1 is not finite");
  image(1, 2)[0] = std::numeric_limits<float>::infinity();
  EXPECT_NE(refusal_of([&] { developed(image, linear_rec709); }), "");
  EXPECT_NE(refusal_of([] { grey_shown(1e30f, {.scale = 1e20}); }), "");
}

TEST(Display, RefusesAnExposureThatShowsNothing) {
  for (const double scale : {0.0, -1.0, std::nan("")})
    EXPECT_NE(refusal_of([&] { grey_shown(1, {.scale = scale}); }), "");
}

TEST(Display, DevelopsNothingIntoNothing) { EXPECT_TRUE(developed({}, acescg).empty()); }

TEST(Display, TakesAConfigurationOfTheUsers) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("coppermoon_display_test_" + std::to_string(std::random_device{}()) + ".ocio");
  auto text = std::string(config_text());
  for (auto at = text.find("ACES 1.0 SDR Video"); at != text.npos;
       at = text.find("ACES 1.0 SDR Video"))
    text.replace(at, 18, "My own view");
  std::ofstream(path) << text;
  EXPECT_EQ(views("sRGB", path)[2], "My own view");
  EXPECT_EQ(grey_shown(0.3f, {.view = "My own view", .config = path}),
            grey_shown(0.3f, {.view = "ACES 1.0 SDR Video"}));
  std::filesystem::remove(path);
}

TEST(Display, RefusesAConfigurationThatIsNone) {
  EXPECT_TRUE(refusal_of([] { views("sRGB", "/no/such.ocio"); }).starts_with("/no/such.ocio: "));
}

TEST(Display, HasBuiltInTheConfigurationThatIsInstalled) {
  const auto installed = text_of(COPPERMOON_TEST_DATA "/../colour/config.ocio");
  ASSERT_FALSE(installed.empty());
  EXPECT_EQ(config_text(), installed);
}

/// Its colours are compared with OpenColorIO's own where a newer one is (tests/hand_off/colour).
TEST(Display, HasTheViewsOfAces2ForNewerOpenColorIo) {
  const auto text = config_text_of_aces2();
  EXPECT_SAYS(text, "\nocio_profile_version: 2.4\n");
  EXPECT_SAYS_NOT(text, "\n#2.4");
  EXPECT_SAYS(text, "\n      ACES 2.0 SDR 100 nits (Rec.709),\n      Filmic, Log, Raw]");
  EXPECT_EQ(std::regex_replace(text, std::regex("\n#2\\.5"), "\n"),
            text_of(COPPERMOON_BUILT "/colour/config_aces2.ocio"));
}

/// A configuration of one view, by a table, in a folder of its own.
class LookUpTable : public testing::Test {
 protected:
  LookUpTable() {
    auto name = (std::filesystem::temp_directory_path() / "coppermoon_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    std::ofstream(config()) << "ocio_profile_version: 2\nroles: {default: lin_rec709_scene}\n"
                               "displays:\n  sRGB:\n"
                               "    - !<View> {name: Un-tone-mapped, colorspace: graded}\n"
                               "    - !<View> {name: Raw, colorspace: lin_rec709_scene}\n"
                               "colorspaces:\n"
                               "  - !<ColorSpace> {name: lin_rec709_scene}\n"
                               "  - !<ColorSpace>\n    name: graded\n    from_scene_reference: "
                               "!<FileTransform> {src: a.cube}\n";
  }
  ~LookUpTable() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path config() const { return folder_ / "config.ocio"; }
  std::filesystem::path table() const { return folder_ / "a.cube"; }

  std::string refusal() const {
    return refusal_of([&] { grey_shown(0.5F, {.config = config()}); });
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(LookUpTable, ThatIsAPipeIsRefused) {
  ASSERT_EQ(::mkfifo(table().c_str(), 0666), 0);
  EXPECT_EQ(refusal(), config().string() + ": " + table().string() +
                           ": cannot be read: it is no regular file");
}

/// OpenColorIO would read a pipe or a device that it names for ever.
TEST_F(LookUpTable, ThatNamesAnotherFileIsRefused) {
  for (const char* element : {"<Reference path=\"a.cube\"", "<reference\n alias=\"a\""}) {
    std::ofstream(table()) << "<?xml version=\"1.0\"?>\n<ProcessList id=\"a\" version=\"1.5\">\n"
                           << element << " /></ProcessList>\n";
    EXPECT_EQ(refusal(), config().string() + ": " + table().string() +
                             ": a look-up table that names another file, allowed one without");
  }
}

/// A configuration of roles and colour spaces whose one view shows the space `shown` as it is.
class OtherConfiguration : public testing::Test {
 protected:
  OtherConfiguration() {
    auto name = (std::filesystem::temp_directory_path() / "coppermoon_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~OtherConfiguration() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path config() const { return folder_ / "config.ocio"; }
  void write(const std::string& roles, const std::string& shown, const std::string& spaces,
             int version = 2) const {
    std::ofstream(config()) << "ocio_profile_version: " << version << "\nroles: {default: " << shown
                            << ", " << roles
                            << "}\ndisplays:\n  sRGB:\n    - !<View> {name: Plain, "
                            << "colorspace: " << shown << "}\ncolorspaces:\n"
                            << spaces;
  }
  Rgb shown(WorkingSpace space, const Rgb& colour, const std::string& config_space = {}) const {
    return developed(image_of({colour}), space,
                     {.view = "Plain", .config = config(), .config_space = config_space})(0, 0);
  }

 private:
  std::filesystem::path folder_;
};

void expect_rgb(const Rgb& found, const Rgb& published) {
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_WITHIN(found[i], published[i], 1e-4, "published with four digits");
}

// AP1's red and Rec.709's in AP0, Rec.709's in AP1: SMPTE S-2014-004, ACES' aces-dev 1.3 with Bradford's adaptation.
const Rgb red{1, 0, 0}, ap1_red_in_ap0{0.69545F, 0.04479F, -0.00553F},
    rec709_red_in_ap0{0.43959F, 0.08978F, 0.01754F},
    rec709_red_in_ap1{0.61310F, 0.07019F, 0.02062F};

const std::string ap0_from_ap1 = "!<BuiltinTransform> {style: ACEScg_to_ACES2065-1}";

TEST_F(OtherConfiguration, IsMetAtItsInterchangeRole) {
  write("aces_interchange: a, scene_linear: Linear", "a",
        "  - !<ColorSpace> {name: a}\n  - !<ColorSpace> {name: Linear}\n");
  expect_rgb(shown(linear_rec709, red), rec709_red_in_ap0);
  expect_rgb(shown(acescg, red), ap1_red_in_ap0);
}

TEST_F(OtherConfiguration, OfDisplaysAloneIsNotMetThere) {
  const std::string spaces = "  - !<ColorSpace> {name: a}\n";
  write("cie_xyz_d65_interchange: x", "a",
        spaces +
            "display_colorspaces:\n  - !<ColorSpace> {name: x}\n"
            "view_transforms:\n  - !<ViewTransform> {name: v, from_scene_reference: "
            "!<ExponentTransform> {value: 2}}\n");
  EXPECT_NE(refusal_of([&] { shown(linear_rec709, red); }), "");
  write("cie_xyz_d65_interchange: a", "a", spaces);
  expect_rgb(shown(linear_rec709, red), {0.4124F, 0.2126F, 0.0193F});  // IEC 61966-2-1
}

TEST_F(OtherConfiguration, IsMetAtItsSceneLinearWhereThatIsKnown) {
  write("scene_linear: ACES - ACEScg", "ACES - ACEScg",  // ACES 1.2
        "  - !<ColorSpace> {name: ACES - ACES2065-1}\n"
        "  - !<ColorSpace> {name: ACES - ACEScg, to_reference: !<MatrixTransform> {matrix: "
        "[0.695452, 0.140679, 0.163869, 0, 0.0447946, 0.859671, 0.0955343, 0, -0.00552588, "
        "0.00402521, 1.0015, 0, 0, 0, 0, 1]}}\n",
        1);
  expect_rgb(shown(acescg, red), red);
  expect_rgb(shown(linear_rec709, red), rec709_red_in_ap1);
}

TEST_F(OtherConfiguration, IsMetAtASpaceOfAKnownName) {
  for (const std::string name : {"Linear", "Linear Rec.709", "Linear BT.709", "lin_rec709_scene"})
    for (const std::string roles : {"scene_linear: b", "data: b"}) {  // Blender's, sobotka/AgX's
      write(roles, "b", "  - !<ColorSpace> {name: b, aliases: [" + name + "]}\n");
      EXPECT_EQ(shown(linear_rec709, red), red) << name;
      const auto shown_red = shown(acescg, red);
      EXPECT_WITHIN(shown_red[0], 1.70505, 1e-4, "aces-dev, five digits: the reverse matrix");
    }
}

TEST_F(OtherConfiguration, ThatCallsAnotherSpaceLinearIsMetByClearerNames) {
  write("scene_linear: Linear", "Linear",
        "  - !<ColorSpace> {name: Linear, aliases: [acescg], to_scene_reference: " + ap0_from_ap1 +
            "}\n");
  expect_rgb(shown(linear_rec709, red), rec709_red_in_ap1);
  write("scene_linear: Linear", "ACES2065-1",
        "  - !<ColorSpace> {name: ACES2065-1}\n  - !<ColorSpace> {name: Linear, "
        "to_scene_reference: " +
            ap0_from_ap1 + "}\n");
  expect_rgb(shown(linear_rec709, red), rec709_red_in_ap0);
}

TEST_F(OtherConfiguration, OfNoKnownSpaceSaysHowItIsNamed) {
  write("scene_linear: Studio", "Studio", "  - !<ColorSpace> {name: Studio}\n");
  EXPECT_EQ(
      refusal_of([&] { shown(acescg, red); }),
      "neither roles nor names say which colour space is acescg, allowed as config-space Studio");
  EXPECT_EQ(shown(acescg, red, "studio"), red);
  EXPECT_EQ(refusal_of([&] { shown(acescg, red, "Stage"); }),
            "config-space = Stage, allowed Studio");
}

TEST_F(OtherConfiguration, OfTheSurroundingsIsForViewsThatTheBuiltInOneHasNot) {
  write("scene_linear: lin_srgb", "lin_srgb", "  - !<ColorSpace> {name: lin_srgb}\n");
  ::setenv("OCIO", config().c_str(), 1);
  EXPECT_EQ(config_for("Plain", "sRGB", {}), config());
  EXPECT_EQ(config_for("filmic", "sRGB", {}), "");
  EXPECT_EQ(config_for("Plain", "sRGB", "other.ocio"), "other.ocio");
  ::unsetenv("OCIO");
  EXPECT_EQ(config_for("Plain", "sRGB", {}), "");
}

TEST(Configuration, OfOpenColorIosOwnNeedsANewerOne) {
  const auto refusal = refusal_of([] { views("sRGB - Display", "ocio://default"); });
  const std::regex of_2_1(
      "ocio://default: OpenColorIO 2\\.1\\.\\d+ has no configurations of its own, allowed a file");
  EXPECT_TRUE(refusal.empty() || std::regex_match(refusal, of_2_1)) << refusal;
}

/// Error message for a configuration of some colour spaces and looks.
std::string fault_of(const std::string& spaces, const std::string& more = "",
                     const std::string& views = "- !<View> {name: Un-tone-mapped, colorspace: a}") {
  const auto path = std::filesystem::temp_directory_path() /
                    ("coppermoon_loop_" + std::to_string(std::random_device{}()) + ".ocio");
  std::ofstream(path) << "ocio_profile_version: 2\nroles: {default: lin_rec709_scene}\n"
                         "displays:\n  sRGB:\n    " +
                             views + "\n" + more +
                             "colorspaces:\n  - !<ColorSpace> {name: lin_rec709_scene}\n" + spaces;
  const auto fault = refusal_of([&] { grey_shown(0.5F, {.config = path}); });
  std::filesystem::remove(path);
  return fault.substr(std::min(fault.size(), fault.find(": ") + 2));
}

std::string space(const std::string& name, const std::string& transform) {
  return "  - !<ColorSpace> {name: " + name + ", from_scene_reference: " + transform + "}\n";
}

const std::string to_a = "!<ColorSpaceTransform> {src: lin_rec709_scene, dst: a}",
                  nothing = "!<ExponentTransform> {value: 2}";

TEST(Configuration, ThatLeadsBackToItselfIsRefused) {
  EXPECT_EQ(fault_of(space("a", nothing)), "");
  EXPECT_EQ(fault_of(space("a", to_a)), "colour space \"a\" is made of itself");
  EXPECT_EQ(fault_of(space("a", "!<GroupTransform> {children: [" + nothing +
                                    ", !<ColorSpaceTransform> {src: b, dst: b}]}") +
                     space("b", to_a)),
            "colour space \"a\" is made of itself");
  EXPECT_EQ(fault_of(space("a", "!<LookTransform> {src: a, dst: lin_rec709_scene, looks: +l}"),
                     "looks:\n  - !<Look> {name: l, process_space: lin_rec709_scene, transform: " +
                         nothing + "}\n"),
            "colour space \"a\" is made of itself");
  EXPECT_EQ(fault_of(space("a", nothing),
                     "looks:\n  - !<Look> {name: l, process_space: lin_rec709_scene, transform: "
                     "!<LookTransform> {src: a, dst: a, looks: \"x, -L\"}}\n",
                     "- !<View> {name: Un-tone-mapped, colorspace: a, looks: l}"),
            "look \"l\" is made of itself");
  EXPECT_EQ(fault_of(space("a",
                           "!<DisplayViewTransform> {src: lin_rec709_scene, display: sRGB, "
                           "view: Un-tone-mapped}")),
            "colour space \"a\" is made of itself");
  const std::string display = "display_colorspaces:\n  - !<ColorSpace> {name: d}\n";
  EXPECT_EQ(fault_of(space("a", nothing),
                     "view_transforms:\n  - !<ViewTransform> {name: v, from_scene_reference: "
                     "!<ColorSpaceTransform> {src: lin_rec709_scene, dst: d}}\n" +
                         display),
            "view transform \"v\" is made of itself")
      << "it is the one between scene and display";
}

TEST(Configuration, WithoutAReasonableEndIsRefused) {
  std::string chain = space("a", nothing), doubled = space("s0", nothing);
  for (int i = 0; i < 30; ++i) {
    const auto twice = fmt::format("!<ColorSpaceTransform> {{src: s{0}, dst: s{0}}}", i);
    doubled += space(fmt::format("s{}", i + 1), twice);
  }
  EXPECT_EQ(fault_of(chain + doubled),
            "colour space \"s12\" is made of 8191 transforms, allowed to 4096");
  for (int i = 100; i > 0; --i)
    chain +=
        space(fmt::format("c{}", i),
              fmt::format("!<ColorSpaceTransform> {{src: lin_rec709_scene, dst: c{}}}", i - 1));
  EXPECT_EQ(fault_of(chain + space("c0", nothing)),
            "colour space \"c36\" is made of more than 64 others, allowed to 64");
}

/// Twenty-five lines would be 33 million transforms.
TEST(Configuration, ThatRepeatsItselfWithoutEndIsRefused) {
  std::string bomb = "!<GroupTransform>\n      children:\n        - &t0 " + nothing + "\n";
  for (int i = 1; i <= 25; ++i)
    bomb += fmt::format("        - &t{} !<GroupTransform> {{children: [*t{}, *t{}]}}\n", i, i - 1,
                        i - 1);
  EXPECT_EQ(fault_of("  - !<ColorSpace>\n    name: a\n    from_scene_reference: " + bomb),
            "50 aliases of YAML, allowed to 16");
  EXPECT_EQ(fault_of(space("a", nothing) + "# *no *alias\n"), "");
}

TEST_F(LookUpTable, OfAConfigurationThatIsAPipeIsRefused) {
  std::filesystem::remove(config());
  ASSERT_EQ(::mkfifo(config().c_str(), 0666), 0);
  EXPECT_EQ(refusal(), config().string() + ": cannot be read: it is no regular file");
}

TEST_F(LookUpTable, OfAUsersConfigurationHasTheActiveViewsAlone) {
  const auto all = views(), shown = displays();
  ::setenv("OCIO_ACTIVE_VIEWS", "Raw", 1);
  ::setenv("OCIO_ACTIVE_DISPLAYS", "P3-D65", 1);
  EXPECT_EQ(views(), all) << "of the built-in configuration: nobody's settings count";
  EXPECT_EQ(displays(), shown);
  EXPECT_GT(grey_shown(0.5F, {}), 0);
  EXPECT_EQ(views("sRGB", config()), std::vector<std::string>{"Raw"});
  ::unsetenv("OCIO_ACTIVE_VIEWS");
  ::unsetenv("OCIO_ACTIVE_DISPLAYS");
}

}  // namespace coppermoon::colour::display_test
