// SPDX-License-Identifier: MIT
#include "uses/light/photon_file.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "algebra/error.h"
#include "files/whole_file.h"

namespace coppermoon::uses {
namespace {

using algebra::Error;
using nlohmann::json;
using shadow::PhotonSums;
using Grids = std::vector<algebra::Grid<double>>;

constexpr const char* kind = "coppermoon photon sums";
constexpr std::uint64_t sums_version = 1;
constexpr std::uint64_t last_block = 1'000'000'000'000;

json numbers_of(const Grids& grids) {
  auto all = json::array();
  for (const auto& grid : grids)
    all.push_back(std::vector<double>(grid.values().begin(), grid.values().end()));
  return all;
}

json blocks_of(const PhotonSums& sums) {
  auto all = json::array();
  for (const auto& range : sums.done) all.push_back({range.from, range.to});
  return all;
}

void require(bool sound, const std::string& what) {
  if (!sound) throw Error(what);
}

double positive(const json& value, const char* what) {
  require(value.is_number(), fmt::format("{} is no number", what));
  const auto number = value.get<double>();
  require(std::isfinite(number) && number > 0,
          fmt::format("{} = {:g}, allowed above 0", what, number));
  return number;
}

std::vector<double> numbers(const json& list, const char* what) {
  require(list.is_array() && !list.empty(), fmt::format("{} is no list of numbers", what));
  std::vector<double> numbers;
  for (const auto& value : list) numbers.push_back(positive(value, what));
  return numbers;
}

std::size_t count(const json& value, std::uint64_t most, const char* what) {
  require(value.is_number_unsigned(), fmt::format("{} is no whole number", what));
  algebra::require_within(what, value.get<double>(), 1, static_cast<double>(most));
  return value.get<std::size_t>();
}

std::vector<shadow::BlockRange> read_blocks(const json& list) {
  require(list.is_array(), "blocks are no list");
  std::vector<shadow::BlockRange> blocks;
  for (const auto& pair : list) {
    require(pair.is_array() && pair.size() == 2 && pair[0].is_number_unsigned() &&
                pair[1].is_number_unsigned(),
            "blocks are no pairs of whole numbers");
    const shadow::BlockRange range{pair[0].get<std::uint64_t>(), pair[1].get<std::uint64_t>()};
    require(range.from < range.to && range.to <= last_block &&
                (blocks.empty() || blocks.back().to < range.from),
            fmt::format("blocks {} to {} are out of order", range.from, range.to));
    blocks.push_back(range);
  }
  return blocks;
}

Grids read_grids(const json& list, const PhotonSums& sums, const char* what) {
  const std::size_t grids = sums.arrangement.depths_m.size() * sums.sectors,
                    cells = sums.rings * sums.wavelengths_nm.size();
  require(list.is_array() && list.size() == grids, fmt::format("{} has not {} grids", what, grids));
  Grids all;
  for (const auto& values : list) {
    require(values.is_array() && values.size() == cells,
            fmt::format("{} has not {} cells in every grid", what, cells));
    auto& grid = all.emplace_back(sums.rings, sums.wavelengths_nm.size());
    for (std::size_t i = 0; i < cells; ++i) {
      require(values[i].is_number(), fmt::format("{} holds what is no number", what));
      grid.values()[i] = values[i].get<double>();
      require(std::isfinite(grid.values()[i]) && grid.values()[i] >= 0,
              fmt::format("{} holds {:g}, allowed 0 or more", what, grid.values()[i]));
    }
  }
  return all;
}

PhotonSums sums_of(const json& all) {
  require(all.is_object() && all.value("kind", json()) == kind, "these are no photons' sums");
  require(all.at("version") == sums_version,
          fmt::format("version = {}, allowed {}", all.at("version").dump(), sums_version));
  PhotonSums sums;
  sums.key = all.at("key").get<std::string>();
  sums.arrangement = {positive(all.at("sun_distance_m"), "sun_distance_m"),
                      numbers(all.at("depths_m"), "depths_m"),
                      all.at("limb_darkening").get<bool>()};
  require_valid(sums.arrangement);
  sums.wavelengths_nm = numbers(all.at("wavelengths_nm"), "wavelengths_nm");
  sums.ring_width_m = positive(all.at("ring_width_m"), "ring_width_m");
  sums.rings = count(all.at("rings"), 1'000'000, "rings");
  sums.sectors = count(all.at("sectors"), 360, "sectors");
  sums.all_wavelengths = all.at("all_wavelengths").get<bool>();
  sums.done = read_blocks(all.at("blocks"));
  sums.sum = read_grids(all.at("sum_m2"), sums, "sum_m2");
  sums.sum_of_squares = read_grids(all.at("sum_of_squares_m4"), sums, "sum_of_squares_m4");
  return sums;
}

}  // namespace

void write_sums(const std::filesystem::path& path, const PhotonSums& sums) {
  const json all{{"kind", kind},
                 {"version", sums_version},
                 {"key", sums.key},
                 {"sun_distance_m", sums.arrangement.sun_distance_m},
                 {"depths_m", sums.arrangement.depths_m},
                 {"limb_darkening", sums.arrangement.limb_darkening},
                 {"wavelengths_nm", sums.wavelengths_nm},
                 {"ring_width_m", sums.ring_width_m},
                 {"rings", sums.rings},
                 {"sectors", sums.sectors},
                 {"all_wavelengths", sums.all_wavelengths},
                 {"blocks", blocks_of(sums)},
                 {"sum_m2", numbers_of(sums.sum)},
                 {"sum_of_squares_m4", numbers_of(sums.sum_of_squares)}};
  files::write_whole(path, all.dump() + "\n");
}

PhotonSums read_sums(const std::filesystem::path& path) {
  const auto text = files::bytes_of(path);
  try {
    return sums_of(json::parse(text));
  } catch (const json::parse_error& error) {
    throw Error(fmt::format("{}: no JSON at byte {}", path.string(), error.byte));
  } catch (const json::exception& error) {
    throw Error(fmt::format("{}: {}", path.string(), error.what()));
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", path.string(), error.what()));
  }
}

}  // namespace coppermoon::uses
