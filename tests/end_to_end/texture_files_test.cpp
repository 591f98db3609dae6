// SPDX-License-Identifier: MIT
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>
#include <nlohmann/json.hpp>
#include <regex>

#include "colour/working_space.h"
#include "end_to_end/parts_of.h"
#include "support/program.h"
#include "texture/image.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::texture_files_test {

using texture::Image;

/// A partial phase: full sunlight, penumbra and umbra on one disc, in air of one column.
const Words partial =
    "2018-07-27T19:20:00Z --albedo-map built-in --atmosphere undated --texture-width 256";
const Words in_the_air_of_a_month = "--atmosphere standard";

class TextureFiles : public ProgramTest {
 protected:
  void bake(const Words& more) const { expect_done(coppermoon(Words{"bake"} + partial + more)); }
};

TEST_F(TextureFiles, OfOneSimulationHaveTheSpaceThatTheirNamesSay) {
  bake("-o moon_acescg.exr -o moon_lin_rec709.tx -o moon_srgb.png");
  EXPECT_EQ(texture::read_attribute(here("moon_acescg.exr"), "coppermoon:colour_space"), "acescg");
  EXPECT_EQ(texture::read_attribute(here("moon_lin_rec709.tx"), "coppermoon:colour_space"),
            "lin_rec709");
  const auto aces = texture::read_image(here("moon_acescg.exr")),
             rec709 = texture::read_image(here("moon_lin_rec709.tx"));
  std::size_t compared = 0;
  for (std::size_t i = 0; i < aces.values.size(); i += 3) {
    const std::array<double, 3> a{aces.values[i], aces.values[i + 1], aces.values[i + 2]};
    const std::array<double, 3> b{rec709.values[i], rec709.values[i + 1], rec709.values[i + 2]};
    const double y = colour::luminance(colour::WorkingSpace::linear_rec709, b);
    if (y < 1e-3) continue;
    EXPECT_WITHIN_RELATIVE(colour::luminance(colour::WorkingSpace::acescg, a), y, 2e-3,
                           "two roundings of 5e-4, doubled where channels differ in size");
    ++compared;
  }
  EXPECT_GT(compared, 8000U);
}

TEST_F(TextureFiles, OfUsdAreTheLinearRec709OneWhereThereIsOne) {
  bake("-o moon_acescg.exr -o moon_lin_rec709.exr -o moon.usda");
  EXPECT_SAYS(text_of(here("moon.usda")), "@./moon_lin_rec709.exr@");
  bake("-o aces_acescg.exr -o aces.usda");
  const auto aces = text_of(here("aces.usda"));
  EXPECT_SAYS(aces, "@./aces_acescg.exr@");
  EXPECT_SAYS(aces,
              "@./aces_lin_rec709.exr@ (\n                    colorSpace = \"lin_rec709_scene\"")
      << "the preview surface takes it for linear Rec.709";
  EXPECT_TRUE(text_of(here("aces_lin_rec709.exr")) == text_of(here("moon_lin_rec709.exr")));
}

/// Space of each part of a file, as OpenImageIO's own program prints it.
Words spaces_said_of(const std::string& said) {
  const std::regex line("colorInteropID: \"(.*)\"");
  Words spaces;
  for (std::sregex_iterator found(said.begin(), said.end(), line), end; found != end; ++found)
    spaces.push_back((*found)[1]);
  return spaces;
}

/// The names are those of the Color Interop Forum's recommendations of July 2026.
TEST_F(TextureFiles, TellOtherProgramsTheirSpace) {
  const std::vector<std::pair<std::string, std::string>> spaces{
      {"acescg", "lin_ap1_scene"},
      {"lin_rec709", "lin_rec709_scene"},
      {"lin_ciexyzd65_scene", "lin_ciexyzd65_scene"}};
  Words words = "--texture-width 64 --passes -o c.png -o a.usda";
  for (const auto& [space, id] : spaces)
    for (const char* ending : {".exr", ".tx"}) words += Words{"-o", "a_" + space + ending};
  bake(words);
  const auto said = [&](const std::string& file) {
    return run(words_of("oiiotool --info -v -a {}", file)).out;
  };
  for (const auto& [space, id] : spaces) {
    EXPECT_EQ(spaces_said_of(said("a_" + space + ".exr")), (Words{id, id, id, id, "data", "data"}));
    EXPECT_EQ(spaces_said_of(said("a_" + space + ".tx")), Words{id});
  }
  EXPECT_EQ(spaces_said_of(said("c.png")), Words{}) << "it is developed";
  EXPECT_SAYS(said("c.png"), "oiio:ColorSpace: \"sRGB\"");
  EXPECT_SAYS(text_of(here("a.usda")),
              "@./a_acescg.exr@ (\n                    colorSpace = "
              "\"lin_ap1_scene\"");
  expect_done(coppermoon(words_of("ring {} --atmosphere undated -o ring.exr", partial.front())));
  EXPECT_EQ(spaces_said_of(said("ring.exr")), Words{"lin_rec709_scene"});
}

TEST_F(TextureFiles, OfUsdComeBesideIt) {
  bake("-o moon.usda");
  EXPECT_EQ(texture::read_attribute(here("moon_lin_rec709.exr"), "coppermoon:colour_space"),
            "lin_rec709");
  EXPECT_SAYS(text_of(here("moon.usda")), "@./moon_lin_rec709.exr@");
  file("moon_lin_rec709.exr", "theirs");
  EXPECT_EQ(coppermoon(words_of("bake {} -o moon.usda", partial.front())).status, 1);
  EXPECT_EQ(text_of(here("moon_lin_rec709.exr")), "theirs");
}

TEST_F(TextureFiles, NameNoFolderOfTheUser) {
  const auto map = here("map.png").string();
  run(words_of("oiiotool --pattern constant:color=0.2,0.2,0.2 64x32 3 -o {}", map));
  bake(words_of("--albedo-map {} -o a.exr -o b.tx -o c.png -o d.glb -o e.usda", map));
  for (const std::string name : {"a.exr", "b.tx", "c.png", "d.glb", "e.usda"}) {
    const auto text = text_of(here(name));
    const bool has_recipe = name < "d";
    EXPECT_EQ(text.find("map.png") != std::string::npos, has_recipe) << name;
    EXPECT_SAYS_NOT(text, here().string()) << name;
  }
}

TEST_F(TextureFiles, AreMadeAgainFromTheirHeaders) {
  bake("-o a_acescg.exr -o b.tx -o c.png --passes --spectral 20 --texture-width 64");
  for (const char* name : {"a_acescg.exr", "b.tx", "c.png"}) {
    const auto again = std::string("again") + std::filesystem::path(name).extension().string();
    expect_done(coppermoon({"bake", name, "-o", again}));
    EXPECT_TRUE(text_of(here(again)) == text_of(here(name))) << name;
  }
}

TEST_F(TextureFiles, OfStellariumStandInItsFolderAndSayWhereItLooks) {
  const Words make = "--at -33.9,18.4 -o moon.stellarium";
  bake(make);
  const auto texture = here("moon.stellarium/textures/moon_4k.jpg");
  const auto before = text_of(texture);
  const auto script = text_of(here("moon.stellarium/scripts/startup.ssc"));
  EXPECT_SAYS(script, "setObserverLocation(18.400000, -33.900000, 0,");
  EXPECT_SAYS(script, "setDate(\"2018-07-27T19:20:00\", \"utc\")");
  bake("--at -33.9,18.4 --bits 8 -o moon.png");
  const auto shown = texture::read_image(texture), picture = texture::read_image(here("moon.png"));
  EXPECT_TRUE(shown.values == picture.values) << "what is developed otherwise too";

  file("moon.stellarium/config.ini", "theirs");
  expect_done(coppermoon(words_of("bake {} -o moon.stellarium", texture)));
  EXPECT_TRUE(text_of(texture) == before) << "its recipe is in it";
  EXPECT_EQ(text_of(here("moon.stellarium/config.ini")), "theirs");
}

TEST_F(TextureFiles, OfStellariumNeedAPlaceAndAFolder) {
  const auto said = [&](const Words& words, int status) {
    const auto outcome = coppermoon(words);
    EXPECT_EQ(outcome.status, status);
    return outcome.err;
  };
  EXPECT_EQ(said(words_of("bake {} -o moon.stellarium", partial.front()), 2),
            "coppermoon: moon.stellarium: Stellarium looks from a place, given with --at\n");
  file("moon.stellarium", "a file");
  EXPECT_EQ(said(words_of("bake {} --at -33.9,18.4 -o moon.stellarium", partial.front()), 1),
            "coppermoon: moon.stellarium: is a file, allowed a folder or a new name\n");
}

TEST_F(TextureFiles, RefuseWhatTheyCannotHold) {
  const auto instant = partial.front();
  expect_refusal(words_of("bake {} --space acescg -o moon_lin_rec709.exr", instant),
                 "moon_lin_rec709.exr: space = acescg, allowed lin_rec709 as its name says, or no "
                 "--space");
  expect_refusal(words_of("bake {} --spectral 7 -o moon.exr", instant),
                 "spectral band [nm] = 7, allowed whole numbers that go into 400 evenly, as 10");
  expect_refusal(words_of("bake {} --spectral nan -o moon.exr", instant),
                 "spectral [nm] = nan, allowed 1 to 100");
  expect_refusal(words_of("bake {} --passes -o moon.tx", instant),
                 "passes and spectra need an output that ends in .exr");
  expect_refusal(
      words_of("bake {} -o moon.exr -o moon.tiff", instant),
      "moon.tiff: a texture ends in .exr (scene-linear), .tx (scene-linear, tiled and "
      "mip-mapped), .png (developed), .jpg (developed, 8 bits, without its recipe), .glb "
      "(developed, on a sphere; moon_lin_rec709.glb in cd/m²), .usda (a sphere, with its "
      "moon_lin_rec709.exr beside it), .usdz (developed, on a sphere, for telephones), "
      ".stellarium (a folder for Stellarium, needs --at)");
  expect_refusal({"bake", instant, "-o", "st\\b.usda"},
                 R"(file of a USD layer = "st\\b.usda", allowed a name in its folder without )"
                 R"(control characters, \ and :SDF_FORMAT_ARGS:, which USD does not find)");
  expect_refusal(words_of("bake {} --texture-width 8194 -o moon.glb", instant),
                 "moon.glb: texture width [texels] = 8194, allowed to 8192");
  expect_refusal("animate 2018-07-27 --make scenes --space acescg -o film",
                 "space = acescg, allowed lin_rec709 with scenes");
  expect_refusal("animate 2018-07-27 --make textures,frames --space acescg -o film",
                 "space = acescg, allowed lin_rec709 with textures beside frames");
  expect_refusal("animate 2018-07-27 --passes -o film",
                 "passes need a film of textures alone, or of frames");
}

using TextureFilesThoroughly = TextureFiles;

/// A developed picture of 400 MB of light is made of rows too.
TEST_F(TextureFilesThoroughly, TakeNoMoreMemoryWhereTheyAreLarge) {
  const auto outcome = coppermoon(
      words_of("bake {} --unshadowed --texture-width 8192 -o moon.png", partial.front()));
  expect_done(outcome);
  EXPECT_LT(outcome.most_memory_mb, 450) << "it was 1786; without any texels 187";
}

TEST_F(TextureFiles, PassesMakeUpTheWhole) {
  bake(in_the_air_of_a_month + "-o moon.exr --passes --type float");
  const auto parts = parts_of(here("moon.exr"));
  ASSERT_EQ(parts.size(), 6U);
  const auto &lit = parts.at("lit"), &direct = parts.at("direct"),
             &refracted = parts.at("refracted"), &irradiance = parts.at("irradiance"),
             &reflectance = parts.at("reflectance");
  EXPECT_EQ(parts.at("albedo").channels, std::vector<std::string>{"Y"});
  double brightest_refracted = 0, dark = 0;
  for (std::size_t i = 0; i < lit.values.size(); ++i) {
    const auto texel = lit.values.begin() + static_cast<std::ptrdiff_t>(i / 3 * 3);
    const double brightest = *std::max_element(texel, texel + 3);
    EXPECT_WITHIN(
        irradiance.values[i] * reflectance.values[i], lit.values[i], 5e-5 * lit.values[i],
        "one light and one ground; the Sun's distance is the Moon's centre's in the first");
    EXPECT_WITHIN(direct.values[i] + refracted.values[i], lit.values[i], 1e-2 * brightest,
                  "the 1 % asked for; straight lines err most where direct light begins, and "
                  "colours are brought into Rec.709 one by one");
    brightest_refracted = std::max<double>(brightest_refracted, refracted.values[i]);
    if (direct.values[i] == 0 && lit.values[i] > 0) ++dark;
  }
  EXPECT_GT(brightest_refracted, 0.01);
  EXPECT_GT(dark, 10000) << "the umbra covers half of the disc: refracted light alone";
}

TEST_F(TextureFiles, IrradianceIsTheSunsWhereNoShadowIs) {
  expect_done(coppermoon(
      words_of("bake {} --unshadowed --texture-width 64 --albedo-map built-in --passes -o moon.exr",
               partial.front())));
  const auto parts = parts_of(here("moon.exr"));
  const auto& irradiance = parts.at("irradiance");
  const std::array<double, 3> rgb{irradiance(16, 32, 0), irradiance(16, 32, 1),
                                  irradiance(16, 32, 2)};
  const double lux = M_PI * colour::luminance(colour::WorkingSpace::linear_rec709, rgb);
  EXPECT_WITHIN_RELATIVE(lux, 133.1e3 / (1.0181 * 1.0181), 0.01,
                         "133.1 klx at 1 au (IES); late in July the Moon is 1.018 au from the Sun; "
                         "spectra of the Sun differ by 1 %");
  for (const float value : parts.at("refracted").values) ASSERT_EQ(value, 0);
  EXPECT_GT(parts.at("reflectance")(16, 32, 0), parts.at("reflectance")(16, 32, 2))
      << "the Moon is redder than grey";
  const auto input = OIIO::ImageInput::open(here("moon.exr"));
  for (int i = 0; input->seek_subimage(i, 0); ++i) {
    const auto& spec = input->spec();
    const auto name = spec.get_string_attribute("oiio:subimagename");
    const bool light = name != "reflectance" && name != "albedo";
    EXPECT_EQ(spec.get_string_attribute("coppermoon:unit"), light ? "cd/m^2" : "") << name;
    EXPECT_EQ(spec.get_float_attribute("whiteLuminance"), light ? 1 : 0) << name;
    EXPECT_NE(spec.get_string_attribute("coppermoon:version"), "") << name;
  }
}

/// The channels that the reader of Fichet, Pacanowski & Wilkie (2021) takes, by their names: each
/// one's place, and the middle of its band.
std::vector<std::pair<std::size_t, double>> bands_of(const Image& image) {
  const std::regex form(
      R"(^((S([0-3]))|T)\.(\d*,?\d*([Ee][+-]?\d+)?)(Y|Z|E|P|T|G|M|k|h|da|d|c|m|u|n|p)?(m|Hz)$)");
  std::vector<std::pair<std::size_t, double>> bands;
  for (std::size_t c = 0; c < image.channels.size(); ++c) {
    std::smatch parts;
    if (!std::regex_match(image.channels[c], parts, form)) continue;
    EXPECT_EQ(parts[1].str() + parts[6].str() + parts[7].str(), "S0nm");
    auto number = parts[4].str();
    number[number.find(',')] = '.';
    bands.emplace_back(c, std::stod(number));
  }
  return bands;
}

/// Bands so wide [nm], of light at so many wavelengths, and how nearly they are the colours.
using SpectrumOf = std::tuple<int, int, double>;

class Spectra : public TextureFiles, public testing::WithParamInterface<SpectrumOf> {};

TEST_P(Spectra, AddUpToTheColours) {
  const auto [width_nm, wavelengths, tolerance] = GetParam();
  const std::string name = "moon_lin_ciexyzd65_scene.exr";
  bake(in_the_air_of_a_month +
       words_of("-o {} --spectral {} --bands {}", name, width_nm, wavelengths));
  const auto image = texture::read_image(here(name));
  EXPECT_EQ(texture::read_attribute(here(name), "emissiveUnits"), "W.m^-2.sr^-1");
  EXPECT_EQ(texture::read_attribute(here(name), "spectralLayoutVersion"), "1.0");
  const auto bands = bands_of(image);
  ASSERT_EQ(bands.size(), 400U / static_cast<unsigned>(width_nm));
  std::vector<double> edges{380};
  for (const auto& [channel, middle] : bands) edges.push_back(middle + width_nm / 2.);
  EXPECT_EQ(edges.back(), 780);
  const auto weights = colour::channel_weights(colour::WorkingSpace::ciexyz_d65, edges);
  std::size_t compared = 0;
  for (std::size_t texel = 0; texel < image.width * image.height; ++texel) {
    const float* values = &image.values[texel * image.channels.size()];
    const double luminance = values[1];
    if (luminance < 1e-3) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      double sum = 0;
      for (std::size_t b = 0; b < bands.size(); ++b) sum += weights(c, b) * values[bands[b].first];
      EXPECT_WITHIN(sum, values[c], tolerance * luminance,
                    "of the luminance: within a band light and the eye's response change "
                    "together, by the square of its width; measured: 0.61 % for 10 nm");
    }
    ++compared;
  }
  EXPECT_GT(compared, 8000U);
}

INSTANTIATE_TEST_SUITE_P(ByWidth, Spectra,
                         testing::Values(SpectrumOf{10, 20, 8e-3}, SpectrumOf{10, 100, 8e-3},
                                         SpectrumOf{2, 20, 3e-4}));

TEST_F(TextureFiles, MipmapsAreReadByATextureSystem) {
  bake("-o moon.tx -o moon.exr");
  const auto flat = texture::read_image(here("moon.exr"));
  auto* textures = OIIO::TextureSystem::create(false);
  const auto at = [&](float s, float t, float width) {
    OIIO::TextureOpt options;
    std::array<float, 3> colour{};
    EXPECT_TRUE(textures->texture(OIIO::ustring(here("moon.tx").string()), options, s, t, width, 0,
                                  0, width, 3, colour.data()))
        << textures->geterror();
    return colour;
  };
  double mean = 0;
  for (std::size_t i = 0; i < flat.values.size(); i += 3) mean += flat.values[i];
  mean /= static_cast<double>(flat.width * flat.height);
  EXPECT_WITHIN_RELATIVE(at(0.5F, 0.5F, 2)[0], mean, 2e-3,
                         "the last level is the mean of all; halves, rounded level by level");
  const auto sunlit = at(179.5F / 256, 44.5F / 128, 0);
  EXPECT_WITHIN_RELATIVE(sunlit[0], flat(44, 179, 0), 0.05,
                         "a bicubic look between a few texels of uneven ground");
  EXPECT_GT(at(0.5F, 0.5F, 0)[0], 0);
  OIIO::TextureSystem::destroy(textures);
}

TEST_F(TextureFiles, SayHowTheGlobeIsTurned) {
  bake("-o moon.exr");
  const auto outcome = coppermoon({"sky", partial.front(), "--json"});
  const auto sky = nlohmann::json::parse(outcome.out);
  const auto header = [&](const std::string& file, const std::string& name) {
    return std::stod(texture::read_attribute(here(file), "coppermoon:" + name).value());
  };
  const std::array names{std::pair{"sub_observer_latitude", "sub_earth_latitude_deg"},
                         std::pair{"sub_observer_longitude", "sub_earth_longitude_deg"},
                         std::pair{"axis_position_angle", "axis_position_angle_deg"},
                         std::pair{"distance_km", "moon_distance_km"}};
  for (const auto& [ours, theirs] : names)
    EXPECT_WITHIN_RELATIVE(header("moon.exr", ours), sky.at(theirs).get<double>(), 1e-5,
                           "six figures, as text has them");
  EXPECT_FALSE(texture::read_attribute(here("moon.exr"), "coppermoon:parallactic_angle"));
  expect_done(
      coppermoon(words_of("scene {} --at -21.1,55.5 --albedo-map built-in --atmosphere undated "
                          "--texture-width 64 -o scene",
                          partial.front())));
  const std::string seen = "scene/moon_lin_rec709.exr";
  const double nearer = header("moon.exr", "distance_km") - header(seen, "distance_km");
  EXPECT_GT(nearer, 1000) << "the Moon is high over La Réunion: most of the Earth's radius nearer";
  EXPECT_LT(nearer, 6378);
  EXPECT_WITHIN(header(seen, "sub_observer_latitude"), header("moon.exr", "sub_observer_latitude"),
                1.1, "the Earth's radius seen from the Moon, at most");
  EXPECT_TRUE(texture::read_attribute(here(seen), "coppermoon:parallactic_angle"));
}

TEST_F(TextureFiles, OfAFilmAreInTheSpaceAsked) {
  const Words film =
      "animate 2018-07-27 --frames 2 --make textures --space acescg --passes --texture-width 64 "
      "--albedo-map built-in --atmosphere undated -o film";
  EXPECT_EQ(coppermoon(film).status, 0);
  EXPECT_EQ(parts_of(here("film/moon_acescg.0001.exr")).size(), 6U);
  EXPECT_EQ(texture::read_attribute(here("film/moon_acescg.0002.exr"), "coppermoon:colour_space"),
            "acescg");
}

}  // namespace coppermoon::end_to_end::texture_files_test
