// SPDX-License-Identifier: MIT
#include "uses/picture/photo_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <map>
#include <regex>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "algebra/error.h"
#include "algebra/number.h"
#include "almanac/instant.h"
#include "colour/camera_spectra.h"
#include "colour/exposure.h"
#include "texture/read_image.h"
#include "uses/picture/photo_header.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

using Names = std::initializer_list<std::string_view>;

/// Values that a photograph's header has under the given names. An EXIF tag such as "Exif:ExposureTime" may be in XMP
/// instead, where OpenImageIO would read "1/30" as 1.
std::vector<std::optional<std::string>> all_in_header(const std::string& photo, Names names) {
  auto values = texture::read_attributes(photo, std::span(names.begin(), names.size()));
  const auto header = photo_header(photo);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto name = names.begin()[i];
    if (const auto found = header.find(name.substr(name.find(':') + 1)); found != header.end())
      values[i] = found->second;
  }
  return values;
}

/// The text in a photograph's header under the first of the given names that has one.
std::optional<std::string> text_in_header(const std::string& photo, Names names) {
  for (auto& text : all_in_header(photo, names))
    if (text && !text->empty()) return std::move(text);
  return std::nullopt;
}

/// The number, or first number of a list, in a photograph's header under the first of the given names that has one.
std::optional<double> number_in_header(const std::string& photo, Names names) {
  for (const auto& text : all_in_header(photo, names))
    if (const auto value = first_number(text.value_or(""));
        value && *value > 0 && std::isfinite(*value))
      return value;
  return std::nullopt;
}

/// Reads a clock from the strings for date and offset in a header. Error messages name the photograph.
std::optional<HeaderClock> clock_named(const std::string& photo, const std::string& date,
                                       const std::string& offset = {}) try {
  return clock_in(date, offset);
} catch (const algebra::Error& error) {
  throw algebra::Error(fmt::format("{}: {}", photo, error.what()));
}

/// Whether a string has only blanks and colons, which is how EXIF writes an unknown date or offset.
bool is_unknown(std::string_view text) {
  return text.find_first_not_of(std::string_view(" :\0", 3)) == text.npos;
}

/// An offset from UTC in the form "+03:00"; nothing if the text is not one.
std::optional<std::string> offset_in(const std::string& text) {
  static const std::regex known(
      R"(\s*(?:(Z|UTC|GMT)|([+-])(\d|0\d|1[0-5])(?::?([0-5]\d))?)[\s\0]*)", std::regex::icase);
  std::smatch part;
  constexpr std::size_t longest = 16;
  if (text.size() > longest || !std::regex_match(text, part, known)) return std::nullopt;
  if (part[1].matched) return "+00:00";
  return fmt::format("{}{:0>2}:{}", part[2].str(), part[3].str(),
                     part[4].matched ? part[4].str() : "00");
}

/// Time scale of the date in a FITS file; nothing for other files.
std::optional<std::string> time_scale_of(const std::string& photo) {
  return texture::read_attribute(photo, "TIMESYS");
}

/// Converts a clock's reading from one of FITS's time scales to UTC. A reading on the scale LOCAL is unchanged.
HeaderClock in_utc(const HeaderClock& clock, std::string scale) {
  static const std::map<std::string, double, std::less<>> behind_tt_s{
      {"TT", 0},       {"TDT", 0},      {"ET", 0},      {"TDB", 0},
      {"TAI", 32.184}, {"IAT", 32.184}, {"GPS", 51.184}};
  scale = scale.substr(0, scale.find_first_of(" ("));  // "TT(TAI)" is read as "TT"
  if (scale == "LOCAL") return clock;
  if (scale.starts_with("UT") || scale == "GMT") return {clock.local, "+00:00"};
  const auto found = behind_tt_s.find(scale);
  if (found == behind_tt_s.end())
    throw algebra::Error(fmt::format(
        "its header's TIMESYS = {}, allowed UTC, UT1, GMT, TT, TDB, TAI, GPS, LOCAL", scale));
  const auto shown = almanac::instant_from_utc(clock.local + 'Z');
  auto utc = almanac::utc_text(almanac::later(shown, found->second - almanac::delta_t_s(shown)));
  utc.pop_back();  // drops the final Z
  return {utc, "+00:00"};
}

/// Whether a photograph's numbers are coded as sRGB, according to its file.
bool is_srgb(const std::string& photo) {
  return !texture::is_raw_file(photo) &&
         texture::read_attribute(photo, "oiio:ColorSpace").value_or("") == "sRGB";
}

/// The program that made or changed a picture according to its header, if it is one of the given programs (lower case).
std::optional<std::string> program_of(const std::string& photo,
                                      std::span<const std::string_view> programs) {
  for (const auto& text :
       all_in_header(photo, {"Software", "ProcessingSoftware", "CreatorTool", "softwareAgent"})) {
    auto small = text.value_or("");
    std::ranges::transform(small, small.begin(), [](unsigned char letter) {
      return static_cast<char>(std::tolower(letter));
    });
    if (std::ranges::any_of(
            programs, [&](std::string_view program) { return small.find(program) != small.npos; }))
      return text;
  }
  return std::nullopt;
}

/// Programs that develop raw files.
constexpr std::array<std::string_view, 18> developers{
    "acdsee",      "adobe",     "affinity",   "astro pixel processor",
    "capture one", "darktable", "digikam",    "dxo",
    "gimp",        "iridient",  "lightroom",  "luminar",
    "on1 ",        "photoshop", "pixinsight", "rawtherapee",
    "siril",       "ufraw"};

/// Programs that edit pictures, or at least save them again.
constexpr std::array<std::string_view, 18> editors{
    "autostakkert", "corel",      "faststone",  "imagemagick", "irfanview",     "paint shop",
    "paint.net",    "photomatix", "photoscape", "picasa",      "pixelmator",    "polarr",
    "registax",     "sequator",   "snapseed",   "startools",   "windows photo", "xnview"};

/// Whether a photograph's size differs from the one that its header states, upright or turned. Its camera wrote both, so
/// another program has cropped or scaled the photograph.
bool is_resized(const std::string& photo) {
  const auto numbers = [&](std::string_view width, std::string_view height) {
    const auto told = all_in_header(photo, {width, height});
    return std::minmax({first_number(told[0].value_or("")), first_number(told[1].value_or(""))});
  };
  const auto stated = numbers("PixelXDimension", "PixelYDimension");
  return stated.first && stated != numbers("FileWidth", "FileHeight");
}

/// ISO speed. The usual EXIF tag has only 16 bits. If it holds 65535, the true, higher speed is in another tag.
std::optional<double> iso_of(const std::string& photo) {
  constexpr double most = 65535;
  const auto iso =
      number_in_header(photo, {"isoSpeed", "Exif:PhotographicSensitivity", "Exif:ISOSpeedRatings"});
  if (!iso || *iso != most) return iso;
  const auto faster = number_in_header(photo, {"Exif:RecommendedExposureIndex", "Exif:ISOSpeed"});
  return faster ? faster : iso;
}

/// The APEX value under the given name in a photograph's header.
std::optional<double> apex_of(const std::string& photo, std::string_view name) {
  const auto stops = first_number(text_in_header(photo, {name}).value_or(""));
  constexpr double most = 40;  // [stops]; cameras without a lens write 2³¹
  return stops && std::abs(*stops) < most ? stops : std::nullopt;
}

/// The real exposure time. It follows from the header's APEX value if that agrees with the nominal time, otherwise from
/// the nominal time alone. In APEX values, Canon writes a third of a stop as 3/8, and two thirds as 5/8.
///
/// Source  ExifTool, lib/Image/ExifTool/Canon.pm: CanonEv
double real_time_s(const std::string& photo, double shown_s) {
  constexpr double alike_stops = 0.2, of_eighths = 1e-3;
  const auto apex = apex_of(photo, "Exif:ShutterSpeedValue");
  if (!apex || !(std::abs(*apex + std::log2(shown_s)) < alike_stops))
    return colour::real_time_s(shown_s);
  double stops = *apex;
  const double part = stops - std::floor(stops);
  for (const auto& [written, meant] : {std::pair{3. / 8, 1. / 3}, {5. / 8, 2. / 3}})
    if (std::abs(part - written) < of_eighths) stops += meant - written;
  return colour::real_time_s(std::exp2(-stops));
}

double number_of(const std::string& file, const char* attribute) {
  const double number =
      algebra::number_in(texture::read_attribute(file, attribute).value_or("")).value_or(0);
  if (!(number > 0))
    throw algebra::Error(fmt::format(
        "{}: its header has no {}, allowed are photographs that coppermoon took", file, attribute));
  return number;
}

void require_sound(const std::string& file, const texture::Image& image) {
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    const float value = image.values[i];
    const auto channel = i % image.channels.size();
    const bool valid = channel == 3;
    if (valid ? value >= 0 && value <= 1 : std::isfinite(value)) continue;
    const auto pixel = i / image.channels.size();
    throw algebra::Error(fmt::format(
        "{}: {} at row {}, column {} = {:g}, allowed {}", file, image.channels[channel],
        pixel / image.width, pixel % image.width, value, valid ? "0 to 1" : "what is finite"));
  }
}

}  // namespace

CameraSettings settings_of(const std::string& photo) {
  CameraSettings settings{number_in_header(photo, {"expTime", "Exif:ExposureTime"}),
                          number_in_header(photo, {"aperture", "Exif:FNumber"}), iso_of(photo),
                          text_in_header(photo, {"GAIN"})};
  if (!settings.time_s)
    if (const auto stops = apex_of(photo, "Exif:ShutterSpeedValue"))
      settings.time_s = std::exp2(-*stops);
  if (!settings.f_number)
    if (const auto stops = apex_of(photo, "Exif:ApertureValue"))
      settings.f_number = std::exp2(*stops / 2);
  const auto camera = camera_of(photo);
  if (!camera || camera->starts_with("coppermoon") || time_scale_of(photo)) return settings;
  if (settings.time_s) settings.time_s = real_time_s(photo, *settings.time_s);
  if (settings.f_number) settings.f_number = colour::real_f_number(*settings.f_number);
  if (settings.iso) settings.iso = colour::real_iso(*settings.iso);
  return settings;
}

std::optional<std::string> camera_of(const std::string& photo) {
  std::vector<std::string> names;
  for (const auto& attribute : all_in_header(photo, {"Make", "Model"})) {
    names.push_back(attribute.value_or(""));
    names.back().erase(names.back().find_last_not_of(std::string_view(" \0", 2)) + 1);
  }
  const auto& make = names[0];
  const auto& model = names[1];
  const auto name = model.starts_with(make) ? model : model.empty() ? make : make + ' ' + model;
  return name.empty() ? text_in_header(photo, {"INSTRUME"}) : std::optional(name);
}

double seconds_at(const HeaderClock& clock) {
  const auto when = almanac::instant_from_utc(clock.local + clock.offset.value_or("Z"));
  return (when.tt_day + when.tt_fraction) * 86400;
}

bool white_balance_is_fixed(const std::string& photo) {
  return text_in_header(photo, {"Exif:WhiteBalance"}) == "1";
}

std::optional<HeaderClock> clock_in(const std::string& date, const std::string& offset) {
  static const std::regex known(
      R"(\s*(\d{4})[:/-](\d{1,2})[:/-](\d{1,2})[ T]+(\d{1,2}):(\d{2})(?::(\d{2})(?:[.,]\d*)?)?\s*)"
      R"((Z|[+-]\d{1,2}:?\d{2})?[\s\0]*)");
  constexpr std::size_t longest = 40;
  if (date.find_first_not_of(std::string_view(" :0-/T\0", 7)) == date.npos) return std::nullopt;
  std::smatch part;
  const auto unknown = [&] {
    return algebra::Error(fmt::format("its header's date = {}, allowed YYYY:MM:DD HH:MM:SS", date));
  };
  if (date.size() > longest || !std::regex_match(date, part, known)) throw unknown();
  const auto hour = part[4] == "24" ? "00" : part[4].str();
  HeaderClock clock{
      fmt::format("{}-{:0>2}-{:0>2}T{:0>2}:{}:{}", part[1].str(), part[2].str(), part[3].str(),
                  hour, part[5].str(), part[6].matched ? part[6].str() : "00"),
      {}};
  for (const auto& text : {offset, part[7].str()}) {
    if (!clock.offset) clock.offset = offset_in(text);
    if (clock.unread.empty() && !is_unknown(text)) clock.unread = text;
  }
  if (clock.offset) clock.unread.clear();
  try {
    seconds_at(clock);
  } catch (const algebra::Error&) {
    throw unknown();
  }
  return clock;
}

HeaderClock clock_of(const std::string& photo) {
  std::string offset;
  for (const auto& text : all_in_header(
           photo, {"Exif:OffsetTimeOriginal", "Exif:OffsetTimeDigitized", "Exif:OffsetTime"}))
    if (text && offset.empty() && !is_unknown(*text)) offset = *text;
  if (text_in_header(photo, {"coppermoon:version"})) offset = "Z";
  for (const auto& date : all_in_header(
           photo, {"Exif:DateTimeOriginal", "Exif:DateTimeDigitized", "DateCreated", "capDate"}))
    if (const auto clock = clock_named(photo, date.value_or(""), offset)) {
      const auto scale = time_scale_of(photo);
      return scale ? in_utc(*clock, *scale) : *clock;
    }
  throw algebra::Error(fmt::format("{}: its header does not say when it was taken", photo));
}

std::optional<HeaderClock> gps_clock_of(const std::string& photo) try {
  const auto told = all_in_header(photo, {"GPSDateStamp", "GPSTimeStamp"});
  std::array<std::string, 3> parts;
  std::istringstream text(told[1].value_or(""));
  text >> parts[0] >> parts[1] >> parts[2];
  const auto hour = first_number(parts[0]), minute = first_number(parts[1]),
             second = first_number(parts[2]);
  // XMP has date and time in one string.
  if (!hour || !minute || !second) return clock_in(told[1].value_or(""), "Z");
  return clock_in(fmt::format("{} {:02.0f}:{:02.0f}:{:02.0f}", told[0].value_or(""), *hour, *minute,
                              std::floor(*second)),
                  "Z");
} catch (const algebra::Error&) {
  return std::nullopt;
}

std::optional<std::string> developer_of(const std::string& photo) {
  if (!uses::camera_of(photo) || !is_srgb(photo)) return std::nullopt;
  if (text_in_header(photo, {"AlreadyApplied"}) == "True") return "Adobe Camera Raw";
  return program_of(photo, developers);
}

std::optional<std::string> editor_of(const std::string& photo) try {
  constexpr double floating_bits = 32;
  const auto bits = first_number(texture::read_attribute(photo, "oiio:BitsPerSample").value_or(""));
  const bool whole_tiff = bits && *bits < floating_bits && !texture::is_raw_file(photo);
  if (auto developer = developer_of(photo); developer || !(is_srgb(photo) || whole_tiff))
    return developer;
  auto program = program_of(photo, developers);
  if (!program) program = program_of(photo, editors);
  if (!program && is_resized(photo)) program = "a program that the header does not name";
  return program;
} catch (const algebra::Error&) {
  return std::nullopt;
}

texture::Coding coding_of(const std::string& photo, texture::Coding told) {
  const bool by_camera =
      told == texture::Coding::as_file_says && camera_of(photo) && is_srgb(photo);
  return by_camera && !developer_of(photo) ? texture::Coding::camera : told;
}

bool is_display_coded(const std::string& photo, texture::Coding told) {
  return coding_of(photo, told) == texture::Coding::srgb ||
         (coding_of(photo, told) == texture::Coding::as_file_says && is_srgb(photo));
}

std::optional<colour::Exposure> exif_of(const std::string& photo) {
  const auto [time_s, f_number, iso, gain] = settings_of(photo);
  if (!time_s || !f_number || !iso) return std::nullopt;
  return colour::Exposure{*time_s, *f_number, *iso};
}

std::optional<ClippedAt> clipped_at(const std::string& photo, const texture::Image& light) {
  const auto number = number_in_header(photo, {"DATAMAX"}),
             as_light = number_in_header(photo, {"coppermoon:clipped_at"});
  if (number && as_light) return ClippedAt{*number, *as_light, true};
  const double most = time_scale_of(photo) ? double{std::ranges::max(light.values)} : 1;
  return most > 1 ? std::optional(ClippedAt{most, most}) : std::nullopt;
}

texture::Image photo_light(const std::string& photo, texture::Coding coding,
                           const std::optional<std::string>& response) {
  std::optional<glm::dmat3> rec709_from_raw;
  if (response && colour::is_spectral(*response))
    rec709_from_raw = channels_from_xyz(colour::WorkingSpace::linear_rec709) *
                      colour::camera_spectra(*response).xyz_from_balanced;
  return texture::read_light(photo, coding, rec709_from_raw);
}

texture::Image raw_light(const std::string& photo, colour::WorkingSpace space,
                         const std::optional<std::string>& response) {
  const auto exposure = exif_of(photo);
  if (!exposure)
    throw algebra::Error(
        fmt::format("{}: its header has not all of exposure time, f-number and ISO speed", photo));
  auto light = photo_light(photo, texture::Coding::as_file_says, response);
  const auto saturation_cd_m2 = static_cast<float>(1 / colour::exposure_scale(*exposure));
  for (float& value : light.values) value *= saturation_cd_m2;
  return in_space(light, colour::WorkingSpace::linear_rec709, space);
}

texture::Attributes scene_attributes(const std::string& file) {
  texture::Attributes attributes;
  for (const char* name : {"coppermoon:recipe", "coppermoon:version", "coppermoon:colour_space",
                           "coppermoon:unit", "capDate", "colorInteropID"})
    if (const auto text = texture::read_attribute(file, name)) attributes[name] = *text;
  for (const char* name : {"latitude", "longitude"})
    if (const auto text = texture::read_attribute(file, name))
      if (const auto number = algebra::number_in(*text))
        attributes[name] = static_cast<float>(*number);
  return attributes;
}

std::optional<double> taken_at_s(const std::string& photo) {
  const auto date = text_in_header(photo, {"Exif:DateTimeOriginal", "capDate"});
  const auto clock = date ? clock_named(photo, *date) : std::nullopt;
  return clock ? std::optional(seconds_at(*clock)) : std::nullopt;
}

colour::Bracketed bracketed(const std::string& file) {
  const auto image = texture::read_channels(file, {"R", "G", "B", "valid"});
  require_sound(file, image);
  colour::Bracketed one{pixels_of(image), channel_of(image, 3), 0};
  const double f_number = number_of(file, "aperture"), time_s = number_of(file, "expTime");
  colour::exposure_scale({time_s, f_number});  // throws if either is outside its range
  one.light = time_s / (f_number * f_number);
  return one;
}

}  // namespace coppermoon::uses
