// SPDX-License-Identifier: MIT
#include "uses/picture/avif_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "algebra/error.h"
#include "files/child_process.h"
#include "files/temporary_folder.h"
#include "files/whole_file.h"
#include "texture/write_image.h"

namespace coppermoon::uses {
namespace {

constexpr double m1 = 2610. / 16384, m2 = 2523. / 4096 * 128, c1 = 3424. / 4096,
                 c2 = 2413. / 4096 * 32, c3 = 2392. / 4096 * 32;

/// Marks the beginning of XMP in any file (ISO 16684-1).
constexpr std::string_view packet_id = "W5M0MpCehiHzreSzNTczkc9d", packet_end = "<?xpacket end",
                           own = "coppermoon:";

constexpr std::array escapes{std::pair{'&', "&amp;"}, std::pair{'<', "&lt;"},
                             std::pair{'>', "&gt;"}, std::pair{'\r', "&#13;"}};

std::string escaped(std::string_view text) {
  std::string all;
  for (const char c : text) {
    const auto* const escape = std::ranges::find(escapes, c, &std::pair<char, const char*>::first);
    if (escape == escapes.end())
      all += c;
    else
      all += escape->second;
  }
  return all;
}

std::string unescaped(std::string_view text) {
  std::string all;
  while (!text.empty()) {
    const auto* const escape = std::ranges::find_if(
        escapes, [&](const auto& known) { return text.starts_with(known.second); });
    const bool plain = escape == escapes.end();
    all += plain ? text.front() : escape->first;
    text.remove_prefix(plain ? 1 : std::string_view(escape->second).size());
  }
  return all;
}

/// Empty for a value that is no text and no number.
std::string text_of(const texture::Attribute& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* number = std::get_if<float>(&value)) return fmt::format("{}", *number);
  if (const auto* whole = std::get_if<int>(&value)) return fmt::format("{}", *whole);
  return {};
}

/// A header as XMP, each attribute an element of our own.
std::string xmp_of(const texture::Attributes& attributes) {
  std::string elements;
  for (const auto& [name, value] : attributes) {
    const auto element = name.starts_with(own) ? name : std::string(own) + name;
    elements += fmt::format("<{0}>{1}</{0}>\n", element, escaped(text_of(value)));
  }
  return fmt::format(
      "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"{}\"?>\n"
      "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
      "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
      "<rdf:Description rdf:about=\"\" xmlns:coppermoon=\"urn:coppermoon:\">\n"
      "{}</rdf:Description>\n</rdf:RDF>\n</x:xmpmeta>\n{}=\"r\"?>",
      packet_id, elements, packet_end);
}

/// What stands between two marks; empty without either.
std::string_view between(std::string_view text, std::string_view first, std::string_view last) {
  const auto begin = text.find(first);
  if (begin == std::string_view::npos) return {};
  text.remove_prefix(begin + first.size());
  const auto end = text.find(last);
  return end == std::string_view::npos ? std::string_view{} : text.substr(0, end);
}

}  // namespace

double light_of_pq(double code) {
  const double p = std::pow(std::clamp(code, 0., 1.), 1 / m2);
  return std::pow(std::max(p - c1, 0.) / (c2 - c3 * p), 1 / m1);
}

double pq_of_light(double light) {
  const double p = std::pow(std::clamp(light, 0., 1.), m1);
  return std::pow((c1 + c2 * p) / (1 + c3 * p), m2);
}

void write_avif(const std::filesystem::path& file, const texture::Image& picture,
                const texture::Attributes& attributes) {
  const files::TemporaryFolder folder;
  files::write_whole(folder.path() / "header.xmp", xmp_of(attributes));
  texture::write_png(folder.path() / "picture.png", picture, 16);
  files::run_program({.words = {"avifenc",
                                "--cicp",
                                "9/16/9",
                                "--depth",
                                "12",
                                "--yuv",
                                "444",
                                "--range",
                                "full",
                                "--min",
                                "0",
                                "--max",
                                "2",
                                "--speed",
                                "6",
                                "--jobs",
                                "all",
                                "--ignore-exif",
                                "--ignore-icc",
                                "--xmp",
                                "header.xmp",
                                "picture.png",
                                "picture.avif"},
                      .package = "libavif-bin",
                      .folder = folder.path()});
  const auto made = folder.path() / "picture.avif";
  std::error_code none;
  if (std::filesystem::file_size(made, none) == 0 || none)
    throw algebra::Error("avifenc: ended without a result");
  files::write_whole(file, files::bytes_of(made));
}

std::optional<std::string> recipe_in_avif(const std::filesystem::path& path) {
  constexpr std::size_t most_bytes = 4 << 20;  // the header stands before the pixels
  const auto bytes = files::beginning_of(path, most_bytes);
  const std::string_view all = bytes;
  if (all.size() < 12 || all.substr(4, 8) != "ftypavif")
    throw algebra::Error(path.string() + ": is no AVIF");
  const auto recipe =
      between(between(all, packet_id, packet_end), "<coppermoon:recipe>", "</coppermoon:recipe>");
  if (recipe.empty()) return std::nullopt;
  return unescaped(recipe);
}

}  // namespace coppermoon::uses
