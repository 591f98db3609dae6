// SPDX-License-Identifier: MIT
#include "uses/picture/picture_parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "algebra/error.h"
#include "algebra/number.h"
#include "atmosphere/sky_luminance.h"
#include "uses/picture/place_text.h"

namespace coppermoon::uses {
namespace {

using request::Affects, request::Parameters, request::choice, request::on_off, request::parameter,
    request::parsed;

constexpr const char *view_heading = "Who looks, and through what",
                     *texture_heading = "The texture";

constexpr const char* whole_moon = "moon";

/// Reads a field of view [degrees]. Nothing for "moon": then the lens settings or the Moon's size determine the field.
std::optional<double> field_from(const std::string& text) {
  if (text == whole_moon) return std::nullopt;
  const auto degrees = algebra::number_in(text);
  if (!degrees)
    throw algebra::Error(
        fmt::format("field of view [degrees] = {}, allowed moon or 1e-8 to 179.9", text));
  algebra::require_within("field of view [degrees]", *degrees, 1e-8, 179.9);
  return degrees;
}

/// Reads "on", "off", or the V magnitude of the faintest star.
StarRequest stars_from(const std::string& text) {
  if (text == "on" || text == "off") return {.shown = text == "on"};
  const auto faintest = algebra::number_in(text);
  if (!faintest)
    throw algebra::Error(fmt::format("stars = {}, allowed on, off or a magnitude, -5 to 20", text));
  algebra::require_within("magnitude of the faintest star", *faintest, -5, 20);
  return {.shown = true, .faintest = faintest};
}

std::string text_of(const StarRequest& stars) {
  if (!stars.shown) return "off";
  return stars.faintest ? fmt::format("{}", *stars.faintest) : "on";
}

/// Reads the sky's brightness [mag/arcsec²] and converts it to luminance; 0 for "off", nothing for "auto".
std::optional<double> sky_luminance_from(const std::string& text) {
  if (text == "auto") return std::nullopt;
  if (text == "off") return 0;
  const auto magnitude = algebra::number_in(text);
  if (!magnitude)
    throw algebra::Error(fmt::format("sky [mag/arcsec2] = {}, allowed auto, off or 0 to 30", text));
  return atmosphere::luminance_of_magnitude_cd_m2(*magnitude);
}

std::string sky_text(const std::optional<double>& luminance_cd_m2) {
  if (!luminance_cd_m2) return "auto";
  if (*luminance_cd_m2 == 0) return "off";
  return fmt::format(
      "{}", -2.5 * std::log10(*luminance_cd_m2 / atmosphere::luminance_of_magnitude_cd_m2(0)));
}

/// Reads the share of light that is spread into a glow around bright ground; nothing for "auto".
std::optional<double> glow_from(const std::string& text) {
  if (text == "auto") return std::nullopt;
  const auto share = algebra::number_in(text);
  if (!share) throw algebra::Error(fmt::format("glow = {}, allowed auto or 0 to 0.5", text));
  algebra::require_within("glow", *share, 0, 0.5);
  return share;
}

std::string text_of(const ExposureTime& time) {
  using enum ExposureTime::Rule;
  if (time.rule == automatic) return "auto";
  if (time.rule == follow) return "follow";
  return time.rule == composite ? "composite" : fmt::format("{}", time.seconds);
}

void describe_optics(Parameters& is, CameraRequest& camera) {
  is.add(parameter("aperture", camera.aperture_mm,
                   "aperture of the telescope or lens [mm], 0.1 to 1e5"))
      .within(0.1, 1e5)
      .not_beside({{"f-number"}});
  is.add(parameter("obstruction", camera.obstruction,
                   "diameter of the secondary mirror over the aperture, 0 to 0.9"))
      .within(0, 0.9);
  is.add(parameter("transmission", camera.transmission,
                   "share of the light that the optics transmit, 0.01 to 1"))
      .within(0.01, 1);
  is.add(on_off("diffraction", camera.diffraction, "blur by diffraction at the aperture"));
  is.add(parameter("seeing", camera.seeing_arcsec,
                   "seeing: full width at half maximum of a star's image [arcsec], 0 to 600"))
      .within(0, 600);
  is.add(parsed(
      "glow", camera.glow,
      [&camera] { return camera.glow ? fmt::format("{}", *camera.glow) : "auto"; },
      [&camera](const std::string& text) { camera.glow = glow_from(text); },
      "glow about bright ground: share of the light that optics and air scatter, 0 to 0.5; auto: "
      "the camera's, 0.02 for lenses and 0.05 for mirrors"));
}

void describe_sensor(Parameters& is, CameraRequest& camera) {
  is.add(parameter("pixel", camera.pixel_um, "side of a pixel of the sensor [um], 0.1 to 1000"))
      .within(0.1, 1000);
  is.add(parameter("quantum-efficiency", camera.quantum_efficiency,
                   "quantum efficiency: electrons per photon of 555 nm, 0.001 to 1"))
      .within(0.001, 1);
  is.add(parameter("full-well", camera.full_well_e,
                   "full-well capacity of a pixel [electrons], 10 to 1e9"))
      .within(10, 1e9);
  is.add(
        parameter("read-noise", camera.read_noise_e, "read noise of a pixel [electrons], 0 to 1e4"))
      .within(0, 1e4)
      .not_beside({{"noise", {"off"}}});
  is.add(parameter("converter-noise", camera.converter_noise_dn,
                   "noise of the converter, behind the gain [DN], 0 to 1e4"))
      .within(0, 1e4)
      .not_beside({{"noise", {"off"}}});
  is.add(parameter("black-level", camera.black_level_dn,
                   "black level of raw numbers [DN], 0 to 32768: to half of what sensor-bits hold"))
      .within(0, 32768);
  is.add(parameter("sensor-bits", camera.sensor_bits, "bits of a raw number, 1 to 16"))
      .within(1, 16);
  is.add(on_off("noise", camera.noise, "noise of photons and sensor"));
  is.add(parameter("noise-seed", camera.noise_seed, "seed of the noise"))
      .not_beside({{"noise", {"off"}}});
}

constexpr const char* time_meaning =
    "exposure time [s], as 2 or 1/30; auto: exposes the lit disc's brightest 1 %, in its brightest "
    "channel, to 80 % of saturation; follow: a weighted mean of the disc is exposed to 25 %, "
    "without a step in a film; "
    "composite: a short one for what is bright and a long one for the shadow, in one picture";

}  // namespace

void describe_map(Parameters& is, MoonRequest& moon) {
  using enum surface::Photometry;
  const request::Conditions own_map{{"albedo-map", {"built-in"}}};
  is.begin({}, "", Affects::ground);
  is.add(
        parameter("albedo-map", moon.albedo_map,
                  "albedo map: an image of 2:1 with longitude 0 in the middle, or built-in: NASA's "
                  "CGI Moon Kit of 2019, 4096 texels wide"))
      .as(request::Kind::file_read);
  is.add(choice("albedo-map-centre", moon.albedo_map_centre_deg, {{"0", 0}, {"180", 180}},
                "longitude in the middle of the albedo map [degrees]: 0, or 180 for a map from 0 "
                "to 360"))
      .not_beside(own_map);
  is.add(choice("photometry", moon.photometry,
                {{"lommel-seeliger-rolo", lommel_seeliger_rolo}, {"yapo-cutler", yapo_cutler}},
                "photometric function of the ground: lommel-seeliger-rolo (as telescopes measured, "
                "with the opposition surge) or yapo-cutler (the paper's, the same at every "
                "phase)"));
  request::Words<AlbedoEncoding> encodings;
  std::string meanings;
  for (const auto& [word, encoding, meaning] : albedo_encoding_words()) {
    encodings.emplace_back(word, encoding);
    meanings += fmt::format("{}{} ({})", meanings.empty() ? "" : ", ", word, meaning);
  }
  is.add(choice("albedo-encoding", moon.albedo_encoding, encodings,
                "how the numbers of a map's file stand for albedo: " + meanings))
      .not_beside(own_map);
  is.add(parameter("albedo-exponent", moon.albedo_exponent,
                   "exponent that undoes a tone curve of the map beyond its encoding, 0.1 to 10"))
      .within(0.1, 10)
      .not_beside(own_map);
  is.add(choice("ground", moon.ground_by_place, {{"by-place", true}, {"mean", false}},
                "colour and opposition surge of the ground: by-place (as a camera in lunar orbit "
                "measured them) or mean (everywhere those of the whole Moon)"));
}

void describe_width(Parameters& is, MoonRequest& moon) {
  is.begin({}, "", Affects::ground);
  is.add(parameter("texture-width", moon.texture_width,
                   "width of the texture [texels], even, 4 to 32768; default: 4096, for a frame as "
                   "many as it can show"))
      .within(4, 32768);
}

void describe_unshadowed(Parameters& is, MoonRequest& moon) {
  is.begin({}, "", Affects::light);
  is.add(request::presence("unshadowed", moon.unshadowed,
                           "lights the Moon as if the Earth were away"));
}

void describe_observer(Parameters& is, ViewRequest& view) {
  is.begin(view_heading, "", Affects::sight);
  is.add(parsed(
      "at", view.observer,
      [&view] { return view.observer ? exact_text(*view.observer) : std::string(); },
      [&view](const std::string& text) { view.observer = observer_from(text); },
      "place of the observer: a city, as Chicago or Springfield/Illinois, or LAT,LON[,ELEV] "
      "[degrees north and east, metres]; default: the Earth's centre"));
  is.add(on_off("reddening", view.reddening, "reddening and dimming by the observer's air"))
      .only_with({{"at"}});
  is.add(parameter("observer-ozone-du", view.observer_ozone_du,
                   "vertical column of ozone above the observer [DU], 0 to 1000"))
      .within(0, 1000)
      .only_with({{"at"}});
  is.add(parameter("observer-aerosol", view.observer_aerosol,
                   "vertical optical depth of the aerosol above the observer at 550 nm, 0 to 10"))
      .within(0, 10)
      .only_with({{"at"}});
}

void describe(Parameters& is, ViewRequest& view) {
  using povray_scenes::Up;
  describe_observer(is, view);
  is.begin(view_heading, "", Affects::frame);
  is.add(on_off("flattening", view.flattening,
                "flattening of a low Moon by refraction in the observer's air"))
      .only_with({{"at"}});
  is.add(parameter("focal-length", view.focal_length_mm,
                   "focal length of the telescope or lens [mm], 1 to 1e6; without camera, lens or "
                   "field the frame holds the whole Moon"))
      .within(1, 1e6)
      .only_with({{"field", {whole_moon}}, {"camera"}});
  is.add(parameter("sensor-width", view.sensor_width_mm,
                   "width of the sensor [mm], 0.1 to 1000; 22.7 unless the camera says another"))
      .within(0.1, 1000)
      .only_with({{"field", {whole_moon}}});
  is.add(parsed(
      "field", view.field_deg,
      [&view] { return view.field_deg ? fmt::format("{}", *view.field_deg) : whole_moon; },
      [&view](const std::string& text) { view.field_deg = field_from(text); },
      "angle across the frame [degrees], in place of a lens; moon: the whole Moon with some "
      "margin, or what the lens shows"));
  is.add(parameter("width", view.width, "width of the frame [pixels], 1 to 65535"))
      .within(1, 65535);
  is.add(parameter("height", view.height, "height of the frame [pixels], 1 to 65535"))
      .within(1, 65535);
  is.add(choice("up", view.up,
                {{"celestial-north", Up::celestial_north},
                 {"zenith", Up::zenith},
                 {"moon-north", Up::moon_north}},
                "direction that is up in the frame"))
      .not_beside({{"mount", {"horizon", "fixed"}}});
  describe_stars(is, view);
  is.add(parsed(
             "sky", view.sky_cd_m2, [&view] { return sky_text(view.sky_cd_m2); },
             [&view](const std::string& text) { view.sky_cd_m2 = sky_luminance_from(text); },
             "sky before and behind the Moon: auto (twilight, moonlight that the air scatters and "
             "airglow, over the observer), off (black), or the brightness of an even, white one "
             "[mag/arcsec2], 0 to 30"))
      .only_with({{"at"}}, {"auto", "off"});
}

void describe_sky_of_frame(Parameters& is, std::optional<double>& sky_cd_m2) {
  is.begin(view_heading, "", Affects::picture);
  is.add(parsed(
      "sky", sky_cd_m2, [&sky_cd_m2] { return sky_text(sky_cd_m2); },
      [&sky_cd_m2](const std::string& text) { sky_cd_m2 = sky_luminance_from(text); },
      "even, white sky that is added to a frame without one [mag/arcsec2], 0 to 30; auto: none, to "
      "a frame of an older version that of its header; off: none"));
}

void describe_stars(Parameters& is, ViewRequest& view) {
  is.begin(view_heading, "", Affects::frame);
  is.add(parsed(
      "stars", view.stars, [&view] { return text_of(view.stars); },
      [&view](const std::string& text) { view.stars = stars_from(text); },
      "stars and planets: on, off, or the V magnitude of the faintest; on: to magnitude 9 "
      "within 10 degrees of the ecliptic, to 6.5 elsewhere"));
}

void describe(Parameters& is, CameraRequest& camera) {
  is.begin(camera_heading, "camera", Affects::frame);
  is.add(parameter("camera", camera.model,
                   fmt::format("camera: {}. Its optics and sensor add blur, noise and clipping; "
                               "default: the scene as it is",
                               fmt::join(colour::camera_names(), ", "))));
  is.begin(camera_heading, "camera", Affects::picture);
  describe_optics(is, camera);
  describe_sensor(is, camera);
  describe_response(is, camera.response);
  // Only the settings below need a rule here. Without a camera, camera_of refuses all the others.
  is.find("glow")->only_with({{"camera"}}, {"auto"});
  is.find("noise-seed")->only_with({{"camera"}});
  is.find("response")->only_with({{"camera"}}, {"colorimetric"});
}

void describe_response(Parameters& is, std::optional<std::string>& response) {
  is.begin(camera_heading, "camera", Affects::ground);
  is.add(
        parameter("response", response,
                  fmt::format("response to colours: {}; from canon-eos-5d-mark-ii on, or a .csv of "
                              "wavelength_nm, r, g, b: the camera's own filters and matrix see all "
                              "light, with no camera too",
                              fmt::join(colour::response_names(), ", "))))
      .as(request::Kind::file_read);
}

void describe_but_time(Parameters& is, Development& development) {
  is.begin(camera_heading, "camera", Affects::picture);
  is.add(parameter(
             "f-number", development.f_number,
             "focal length over aperture, 0.5 to 512; default: the camera's, without one 12.1"))
      .within(0.5, 512);
  is.add(parameter("iso", development.iso, "ISO speed (ISO 12232, saturation-based), 1 to 1e7"))
      .within(1, 1e7);
  is.add(parameter("view", development.view, "view of the OpenColorIO configuration"));
  is.add(parameter("display", development.display, "display of the OpenColorIO configuration"));
  is.add(parameter("config", development.config,
                   "OpenColorIO configuration in place of the built-in one, a file or ocio://…; "
                   "without it $OCIO, for views and displays that the built-in one has not"))
      .as(request::Kind::file_read);
  is.add(parameter(
      "config-space", development.config_space,
      "colour space of the configuration that frames are in; default: found by its roles and "
      "names"));
  is.add(
        choice("bits", development.bits, {{"8", 8}, {"16", 16}}, "bits of a number of the picture"))
      .as(request::Kind::whole);
}

void describe_caption(Parameters& is, bool& caption) {
  is.begin(camera_heading, "camera", Affects::picture);
  is.add(request::presence(
      "caption", caption,
      "writes local time, place and contact into the picture, as the frame's header has them"));
}

void describe_time(Parameters& is, std::string& time) {
  is.begin(camera_heading, "camera", Affects::picture);
  is.add(parameter("time", time, time_meaning));
}

void describe(Parameters& is, Development& development) {
  auto& time = development.time;
  is.begin(camera_heading, "camera", Affects::picture);
  is.add(parsed(
      "time", time, [&time] { return text_of(time); },
      [&time](const std::string& text) { time = exposure_time_from(text); }, time_meaning));
  describe_but_time(is, development);
}

void describe_numbers(Parameters& is, TextureContent& content) {
  is.begin(texture_heading, "", Affects::ground);
  is.add(parsed(
      "space", content.space,
      [&content] { return content.space ? std::string(colour::name(*content.space)) : ""; },
      [&content](const std::string& name) { content.space = colour::working_space(name); },
      "colour space: lin_rec709, acescg or lin_ciexyzd65_scene; default: the one in the file's "
      "name, as moon_acescg.exr, or lin_rec709"));
  is.add(choice("type", content.type,
                {{"half", texture::ExrType::half}, {"float", texture::ExrType::floating}},
                "numbers of a texel: half or float; default: half, float for a spectrum"));
}

void describe(Parameters& is, TextureContent& content) {
  describe_numbers(is, content);
  is.add(parameter("spectral", content.spectral_nm,
                   "width of spectral bands [nm], 1 to 100, a divisor of 400: an .exr gets the "
                   "spectral radiance from 380 to 780 nm too"))
      .within(1, 100);
  describe_passes(is, content.passes);
}

void describe_passes(Parameters& is, bool& passes) {
  is.add(request::presence(
      "passes", passes,
      "adds parts to an .exr: to a texture direct light, refracted light, irradiance, reflectance, "
      "albedo; to a frame alpha, the Moon, stars, positions on the Moon"));
}

ExposureTime exposure_time_from(const std::string& text) {
  using enum ExposureTime::Rule;
  if (text == "auto") return {automatic};
  if (text == "follow") return {follow};
  if (text == "composite") return {composite};
  const auto seconds = exposure_seconds(text);
  if (!seconds)
    throw algebra::Error(fmt::format(
        "exposure time = {}, allowed auto, follow, composite, or 1e-6 to 1e6 s, as 2 or 1/30",
        text));
  algebra::require_within("exposure time [s]", *seconds, 1e-6, 1e6);
  return {fixed, *seconds};
}

std::optional<double> exposure_seconds(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) return algebra::number_in(text);
  const auto over = algebra::number_in(text.substr(0, slash)),
             under = algebra::number_in(text.substr(slash + 1));
  return over && under && *under > 0 ? std::optional(*over / *under) : std::nullopt;
}

}  // namespace coppermoon::uses
