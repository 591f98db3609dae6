// SPDX-License-Identifier: MIT
#include "colour/camera_spectra.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/matrix.hpp>
#include <iterator>
#include <map>
#include <numeric>

#include "algebra/error.h"
#include "colour/cie_observer.h"
#include "colour/difference.h"
#include "colour/tables.h"
#include "colour/working_space.h"

namespace coppermoon::colour {
namespace {

constexpr const char* ending = ".csv";
constexpr std::string_view of_red = "_r";
const std::array<std::string, 3> channel_columns{"r", "g", "b"};

/// Edges of the 400 bands, each 1 nm wide, over which products of spectra are summed.
std::vector<double> edges_nm() {
  std::vector<double> edges(401);
  std::iota(edges.begin(), edges.end(), 380.);
  return edges;
}

double product(std::span<const double> one, std::span<const double> other) {
  return std::inner_product(one.begin(), one.end(), other.begin(), 0.);
}

/// Signals of three channels, given their sensitivity curves and the spectrum of the light, all in 1 nm bands.
glm::dvec3 signals(const algebra::Grid<double>& curves, std::span<const double> spectrum) {
  return {product(curves.row(0), spectrum), product(curves.row(1), spectrum),
          product(curves.row(2), spectrum)};
}

/// Spectra of the ColorChecker's patches under D65, in 1 nm bands. The first is a perfect white.
algebra::Grid<double> lit_patches() {
  static const auto table = algebra::parse_table(tables::colour_checker(), "colour_checker.csv");
  std::vector<std::string> names;
  for (const auto& [name, column] : table.columns)
    if (name != "wavelength_nm" && name != "d65") names.push_back(name);
  names.insert(names.begin(), "d65");
  auto lit = band_integrals(table, names, edges_nm());
  for (std::size_t patch = 1; patch < lit.rows(); ++patch)
    // FAULT patches in light of equal energy: lit(0, band); => lit(0, 0);
    for (std::size_t band = 0; band < lit.columns(); ++band) lit(patch, band) *= lit(0, band);
  return lit;
}

/// Colours of the patches: for the CIE observer, XYZ / Y of white; for the camera, white-balanced signals.
struct Seen {
  std::vector<glm::dvec3> xyz, balanced;  ///< the first patch is white
};

/// One row of the colour matrix, fitted to the patches by least squares. Its sum is fixed so that white stays white.
glm::dvec3 fitted_row(const Seen& seen, int row) {
  const double white = seen.xyz.front()[row];
  double rr = 0, rg = 0, gg = 0, rt = 0, gt = 0;
  for (std::size_t i = 1; i < seen.xyz.size(); ++i) {
    const auto& c = seen.balanced[i];
    const double r = c.r - c.b, g = c.g - c.b, t = seen.xyz[i][row] - white * c.b;
    // FAULT least squares that mix up red and green: rt += r * t => rt += g * t
    rr += r * r, rg += r * g, gg += g * g, rt += r * t, gt += g * t;
  }
  const double determinant = rr * gg - rg * rg;
  const double red = (rt * gg - gt * rg) / determinant, green = (gt * rr - rt * rg) / determinant;
  // FAULT daylight that is no longer white: white - red - green => 1 - red - green
  return {red, green, white - red - green};
}

void fit(CameraSpectra& camera, const std::string& name) {
  const auto patches = lit_patches();
  const auto edges = edges_nm();
  const auto curves = band_integrals(camera.table, channel_columns, edges);
  const auto observer = xyz_weights(edges);
  camera.daylight = signals(curves, patches.row(0));
  for (std::size_t k = 0; k < 3; ++k)
    if (camera.daylight[static_cast<int>(k)] <= 0)
      throw algebra::Error(
          fmt::format("{}: column {} is 0 from 380 to 780 nm, allowed a channel "
                      "that sees light",
                      name, channel_columns[k]));
  Seen seen;
  const double white = signals(observer, patches.row(0)).y;
  for (std::size_t i = 0; i < patches.rows(); ++i) {
    seen.xyz.push_back(signals(observer, patches.row(i)) / white);
    seen.balanced.push_back(signals(curves, patches.row(i)) / camera.daylight);
  }
  glm::dmat3 rows;
  for (int row = 0; row < 3; ++row) rows[row] = fitted_row(seen, row);
  camera.xyz_from_balanced = glm::transpose(rows);
  constexpr double alike = 1e-4;  // the matrices of real cameras have determinants of 0.3 to 0.6
  const double determinant = glm::determinant(camera.xyz_from_balanced);
  double most = 0;
  for (int i = 0; i < 9; ++i)
    most = std::max(most, std::abs(camera.xyz_from_balanced[i / 3][i % 3]));
  if (!(std::abs(determinant) > alike) || !(most < 1 / alike))
    throw algebra::Error(fmt::format(
        "{}: columns r, g and b tell no colours, allowed three curves that differ", name));
  const auto to_d65 =
      (glm::inverse(channels_from_xyz(WorkingSpace::linear_rec709)) * glm::dvec3(1)) /
      seen.xyz.front();  // each component of the quotient is within 2e-4 of 1
  for (std::size_t i = 1; i < seen.xyz.size(); ++i) {
    const double error =
        delta_e_2000(lab_from_xyz(to_d65 * seen.xyz[i]),
                     lab_from_xyz(to_d65 * (camera.xyz_from_balanced * seen.balanced[i])));
    camera.mean_delta_e += error / static_cast<double>(seen.xyz.size() - 1);
    camera.most_delta_e = std::max(camera.most_delta_e, error);
  }
}

/// Refuses a table whose columns cannot be spectral sensitivities.
void require_sound(const algebra::Table& table, const std::string& file) {
  for (const auto* column : {"wavelength_nm", "r", "g", "b"})
    if (!table.columns.contains(column))
      throw algebra::Error(
          fmt::format("{}: no column {}, allowed wavelength_nm, r, g, b", file, column));
  const auto& at_nm = table["wavelength_nm"];
  if (at_nm.size() < 10 || at_nm.size() > 100000)
    throw algebra::Error(
        fmt::format("{}: {} rows of numbers, allowed 10 to 100000", file, at_nm.size()));
  for (std::size_t i = 0; i < at_nm.size(); ++i) {
    if (!std::isfinite(at_nm[i]) || (i > 0 && at_nm[i] <= at_nm[i - 1]))
      throw algebra::Error(
          fmt::format("{}: wavelength [nm] = {:g} in row {}, allowed above that of "
                      "the row before",
                      file, at_nm[i], i + 1));
    for (const auto& column : channel_columns)
      if (const double value = table[column][i]; !(value >= 0 && value <= 1e6))
        throw algebra::Error(fmt::format("{}: {} = {:g} at {:g} nm, allowed 0 to 1e6", file, column,
                                         value, at_nm[i]));
  }
}

CameraSpectra read(const std::string& file) {
  if (!std::filesystem::is_regular_file(file))
    throw algebra::Error(
        fmt::format("{}: no such file, allowed a .csv of wavelength_nm, r, g, b, or "
                    "{}",
                    file, fmt::join(camera_spectra_names(), ", ")));
  constexpr std::uintmax_t most_bytes = 1 << 24;
  if (std::filesystem::file_size(file) > most_bytes)
    throw algebra::Error(fmt::format("{}: {} bytes, allowed to {}", file,
                                     std::filesystem::file_size(file), most_bytes));
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream.good() && !stream.eof())
    throw algebra::Error(fmt::format("{}: cannot be read", file));
  CameraSpectra camera;
  camera.table = algebra::parse_table(text, file);
  require_sound(camera.table, file);
  fit(camera, file);
  return camera;
}

/// All cameras in the built-in table, by name.
const std::map<std::string, CameraSpectra, std::less<>>& built_in() {
  static const auto cameras = [] {
    const auto table = algebra::parse_table(tables::camera_spectra(), "camera_spectra.csv");
    std::map<std::string, CameraSpectra, std::less<>> all;
    for (const auto& name : camera_spectra_names()) {
      CameraSpectra camera;
      camera.table.columns["wavelength_nm"] = table["wavelength_nm"];
      for (const auto& column : channel_columns)
        camera.table.columns[column] = table[name + "_" + column];
      fit(camera, name);
      all.emplace(name, std::move(camera));
    }
    return all;
  }();
  return cameras;
}

}  // namespace

const std::vector<std::string>& camera_spectra_names() {
  static const auto all = [] {
    std::vector<std::string> names;
    const auto table = algebra::parse_text_table(tables::camera_spectra());
    for (const auto& column : table.front())
      if (column.ends_with(of_red))
        names.push_back(column.substr(0, column.size() - of_red.size()));
    return names;
  }();
  return all;
}

std::optional<std::string> spectral_camera_of(std::string_view name_in_header) {
  constexpr std::size_t shortest = 4;
  std::string name;
  for (const char letter : name_in_header)
    name +=
        letter == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  for (const auto& camera : camera_spectra_names())
    if (name.ends_with(camera) || (name.size() >= shortest && camera.ends_with('-' + name)))
      return camera;
  return std::nullopt;
}

bool is_spectral(std::string_view response) {
  const auto& names = camera_spectra_names();
  return response.ends_with(ending) || std::ranges::find(names, response) != names.end();
}

CameraSpectra camera_spectra(const std::string& response) {
  if (const auto found = built_in().find(response); found != built_in().end()) return found->second;
  if (response.ends_with(ending)) return read(response);
  throw algebra::Error(fmt::format("response = {}, allowed colorimetric, {}, or a .csv file",
                                   response, fmt::join(camera_spectra_names(), ", ")));
}

void require_spectral(const std::string& response) {
  if (response != "colorimetric") camera_spectra(response);
}

algebra::Grid<double> xyz_weights(std::span<const double> edges_nm, const CameraSpectra& camera) {
  const auto patches = lit_patches();
  const double white_cd_m2 = signals(xyz_weights(colour::edges_nm()), patches.row(0)).y;
  auto weights = band_integrals(camera.table, channel_columns, edges_nm);
  for (std::size_t band = 0; band < weights.columns(); ++band) {
    const glm::dvec3 balanced =
        glm::dvec3(weights(0, band), weights(1, band), weights(2, band)) / camera.daylight;
    const auto xyz = white_cd_m2 * (camera.xyz_from_balanced * balanced);
    for (int i = 0; i < 3; ++i) weights(static_cast<std::size_t>(i), band) = xyz[i];
  }
  return weights;
}

}  // namespace coppermoon::colour
