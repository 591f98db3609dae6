// SPDX-License-Identifier: MIT
// A light file holds a line of JSON that describes the light, its numbers as bytes, and a fingerprint of both.
#include "uses/light/light_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>

#include "algebra/error.h"
#include "files/fingerprint.h"
#include "files/whole_file.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

using nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "numbers are written as they are");

constexpr const char* light_kind = "coppermoon light 1";

ordered_json described(const plan::Plan& plan) {
  const auto& work = plan.work;
  ordered_json left_out = ordered_json::array();
  for (const auto& [term, size] : plan.left_out) left_out.push_back({name(term), size});
  return {{"method", static_cast<int>(work.solver)},
          {"photons", work.photons},
          {"terms", {work.refracted, work.ellipsoid, work.regions, work.scattered_light}},
          {"knobs", {work.bands, work.rays, work.sun_terms, work.planes}},
          {"place_error", work.place_error},
          {"tolerance", plan.tolerance},
          {"predicted_error", plan.error},
          {"left_out", left_out},
          {"gave_way", plan.misses_tolerance ? "tolerance" : ""}};
}

plan::Plan plan_from(const ordered_json& all) {
  plan::Plan plan;
  auto& work = plan.work;
  work.solver = static_cast<plan::Solver>(all.at("method").get<int>());
  work.photons = all.at("photons");
  const auto &terms = all.at("terms"), &knobs = all.at("knobs");
  work.refracted = terms.at(0), work.ellipsoid = terms.at(1), work.regions = terms.at(2);
  work.scattered_light = terms.at(3);
  work.bands = knobs.at(0), work.rays = knobs.at(1);
  work.sun_terms = knobs.at(2), work.planes = knobs.at(3);
  work.place_error = all.at("place_error");
  plan.tolerance = all.at("tolerance");
  plan.error = all.at("predicted_error");
  for (const auto& one : all.at("left_out"))
    plan.left_out.push_back({plan::term_named(one.at(0).get<std::string>()), one.at(1)});
  plan.misses_tolerance = all.at("gave_way").get<std::string>() == "tolerance";
  return plan;
}

ordered_json described(const Moonlight& light, const std::string& key) {
  const auto& refracted = *light.refracted;
  return {{"kind", light_kind},
          {"key", key},
          {"sun_distance_m", refracted.arrangement.sun_distance_m},
          {"depths_m", refracted.arrangement.depths_m},
          {"limb_darkening", refracted.arrangement.limb_darkening},
          {"wavelengths_nm", refracted.wavelengths_nm},
          {"axis_distances_m", refracted.axis_distances_m},
          {"sectors", refracted.sectors},
          {"photons", refracted.photons},
          {"errors_add", refracted.errors_correlated},
          {"range", {light.range.from_m, light.range.to_m, light.range.tolerance}},
          {"range_sectors", {light.range.sectors.first, light.range.sectors.count}},
          {"error_found", light.error_found},
          {"plan", described(light.plan)}};
}

Moonlight light_from(const ordered_json& all) {
  Moonlight light;
  auto& refracted = light.refracted.emplace();
  refracted.arrangement = {all.at("sun_distance_m"), all.at("depths_m"), all.at("limb_darkening")};
  refracted.wavelengths_nm = all.at("wavelengths_nm").get<std::vector<double>>();
  refracted.axis_distances_m = all.at("axis_distances_m").get<std::vector<double>>();
  refracted.sectors = all.at("sectors");
  refracted.photons = all.at("photons");
  refracted.errors_correlated = all.at("errors_add");
  const auto &range = all.at("range"), &sectors = all.at("range_sectors");
  light.range = {
      range.at(0), range.at(1), range.at(2), {refracted.sectors, sectors.at(0), sectors.at(1)}};
  light.error_found = all.at("error_found");
  light.plan = plan_from(all.at("plan"));
  return light;
}

using Grids = std::vector<algebra::Grid<double>>;

void append(const Grids& grids, std::string& bytes) {
  for (const auto& grid : grids)
    bytes.append(reinterpret_cast<const char*>(grid.values().data()),
                 grid.values().size() * sizeof(double));
}

/// Reads the grids that follow the header: the light and, if photons were traced, its standard errors.
bool read_grids(std::string_view bytes, shadow::RefractedLight& light) {
  const std::size_t rows = light.axis_distances_m.size(), columns = light.wavelengths_nm.size(),
                    size = rows * columns * sizeof(double),
                    grids = light.arrangement.depths_m.size() * light.sectors;
  const std::size_t kinds = light.photons > 0 ? 2 : 1;
  if (size == 0 || bytes.size() % size != 0 || bytes.size() / size != kinds * grids) return false;
  for (std::size_t g = 0; g < kinds * grids; ++g) {
    auto& grid = (g < grids ? light.ratio : light.standard_error).emplace_back(rows, columns);
    std::memcpy(grid.values().data(), bytes.data(), size);
    bytes.remove_prefix(size);
  }
  return true;
}

void require(bool sound) {
  if (!sound) throw algebra::Error("no light");
}

bool are_within(std::span<const double> values, double low, double high) {
  return std::ranges::all_of(values, [&](double v) { return v >= low && v <= high; });
}

bool ascend(std::span<const double> values) {
  return !values.empty() &&
         std::ranges::adjacent_find(values, std::greater_equal()) == values.end();
}

/// Refuses light with sizes or settings out of bounds. Sizes are checked before any grid is read.
void require_sound(const Moonlight& light) {
  const auto& work = light.plan.work;
  const auto& refracted = *light.refracted;
  require(work.solver >= plan::Solver::quadrature && work.solver <= plan::Solver::literal);
  require_knobs(plan::ByHand{.bands = work.bands,
                             .rays = work.rays,
                             .sun_terms = work.sun_terms,
                             .planes = work.planes,
                             .place_error = work.place_error});
  require(are_within(
      std::array{work.photons, light.error_found, light.plan.tolerance, light.plan.error}, 0,
      1e15));
  shadow::require_valid(refracted.arrangement);
  require(ascend(refracted.arrangement.depths_m));
  require(refracted.wavelengths_nm == wavelengths_nm(work.bands));
  require(ascend(refracted.axis_distances_m) && are_within(refracted.axis_distances_m, 0, 1e9));
  require(refracted.sectors >= 1 && refracted.sectors <= 1000);
  const auto& range = light.range;
  require(range.from_m >= 0 && range.to_m > range.from_m && range.to_m <= 1e9);
  require(range.tolerance >= 1e-6 && range.tolerance <= 0.1);
  require(range.sectors.count > 0 && range.sectors.first < range.sectors.around);
}

/// Refuses light brighter than unobstructed sunlight. Only light from photons may be brighter, because of its noise.
void require_sound(const shadow::RefractedLight& light) {
  const double most = light.photons > 0 ? 1e12 : 1;
  for (const auto* grids : {&light.ratio, &light.standard_error})
    for (const auto& grid : *grids) require(are_within(grid.values(), 0, most));
}

std::string stamp_of(std::string_view bytes) {
  return fmt::format("{:016x}", files::fingerprint(bytes));
}

}  // namespace

void write_light(const std::filesystem::path& path, const std::string& key,
                 const Moonlight& light) {
  std::string bytes = described(light, key).dump() + "\n";
  append(light.refracted->ratio, bytes);
  append(light.refracted->standard_error, bytes);
  files::write_whole(path, bytes + stamp_of(bytes));
}

bool is_light(const std::filesystem::path& path) {
  constexpr std::string_view head = "{\"kind\":\"coppermoon light ";
  const auto begins = files::beginning_of(path, head.size());
  return head.starts_with(begins);
}

std::optional<KeptLight> read_light(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  const auto all = files::bytes_of(path);
  constexpr std::size_t stamp = 16;
  if (all.size() < stamp) return std::nullopt;
  const auto bytes = std::string_view(all).substr(0, all.size() - stamp);
  if (stamp_of(bytes) != all.substr(bytes.size())) return std::nullopt;
  const auto line = bytes.find('\n');
  if (line == std::string_view::npos) return std::nullopt;
  try {
    const auto header = ordered_json::parse(bytes.substr(0, line));
    if (header.at("kind") != light_kind) return std::nullopt;
    KeptLight kept{header.at("key"), light_from(header)};
    require_sound(kept.light);
    if (!read_grids(bytes.substr(line + 1), *kept.light.refracted)) return std::nullopt;
    require_sound(*kept.light.refracted);
    return kept;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  } catch (const algebra::Error&) {
    return std::nullopt;
  }
}

}  // namespace coppermoon::uses
