// SPDX-License-Identifier: MIT
#include "uses/light/air.h"

#include "atmosphere/presets.h"
#include "wrappers/python/fields.h"
#include "wrappers/python/nouns.h"

namespace coppermoon::python {
namespace {

using uses::Air, uses::AirRegion, uses::ColumnChange;

uses::Stratosphere stratosphere_of(py::handle told) {
  if (!py::isinstance<py::str>(told)) {
    const auto depth = read_as<double>("stratospheric_aerosol", told);
    algebra::require_within("stratospheric aerosol", depth, 0, 2);
    return depth;
  }
  const auto word = told.cast<std::string>();
  if (word == "dated") return uses::DatedAerosol{};
  return value_of<atmosphere::StratosphericAerosol>(word);
}

py::object told_of(const std::optional<uses::Stratosphere>& stratosphere) {
  if (!stratosphere) return py::none();
  if (std::holds_alternative<uses::DatedAerosol>(*stratosphere)) return py::str("dated");
  if (const auto* depth = std::get_if<double>(&*stratosphere)) return py::float_(*depth);
  return py::cast(std::get<atmosphere::StratosphericAerosol>(*stratosphere));
}

/// What may differ from one part of the limb to another.
template <class Request>
std::vector<Field<Request>> column_fields() {
  const auto of = [](const char* name, auto ColumnChange::*member, const char* text) {
    return field<Request>(
        name, [member](Request & all) -> auto& { return all.column.*member; }, text);
  };
  return {
      of("danjon", &ColumnChange::danjon,
         "brightness of the eclipse on Danjon's scale, 0 (very dark) to 4 (bright): cloud and "
         "aerosol are scaled until the eclipse has it"),
      of("ozone_du", &ColumnChange::ozone_du, "vertical column of ozone [DU], 0 to 1000"),
      of("cloud_cover", &ColumnChange::cloud_cover,
         "share of the Earth's limb where a deck of cloud stops the light, 0 to 1"),
      of("dust_extinction", &ColumnChange::dust_extinction_per_m,
         "extinction of a grey layer of dust [1/m]"),
      of("tropospheric_aerosol", &ColumnChange::tropospheric_optical_depth,
         "vertical optical depth of the aerosol near the ground at 550 nm, 0 to 10"),
      Field<Request>{"stratospheric_aerosol",
                     "'dated', 'none', 'background', 'moderate', 'high', 'extreme', or a vertical "
                     "optical depth at 550 nm, 0 to 2",
                     [](Request& all, py::handle told) {
                       all.column.stratosphere.reset();
                       if (!told.is_none()) all.column.stratosphere = stratosphere_of(told);
                     },
                     [](const Request& all) { return told_of(all.column.stratosphere); }},
      of("free_troposphere", &ColumnChange::free_troposphere,
         "factor on the aerosol between ground and tropopause, 0 to 100"),
      of("cloud_chance", &ColumnChange::cloud_chance,
         "factor on the chance that a ray meets cloud, 0 to 100"),
      of("cirrus", &ColumnChange::cirrus, "factor on the thin cirrus, 0 to 100"),
      of("tropopause_km", &ColumnChange::tropopause_km, "height of the tropopause [km], 5 to 20"),
      of("cloud_top_km", &ColumnChange::cloud_top_km,
         "height of the deck that cloud_cover lays [km], 0 to 30"),
      of("dust_bottom_km", &ColumnChange::dust_bottom_km, "lower edge of the dust layer [km]"),
      of("dust_top_km", &ColumnChange::dust_top_km, "upper edge of the dust layer [km]")};
}

std::vector<Field<AirRegion>> region_fields() {
  const auto of = [](const char* name, auto AirRegion::*member, const char* text) {
    return field<AirRegion>(
        name, [member](AirRegion & all) -> auto& { return all.*member; }, text);
  };
  std::vector all{
      of("from_latitude", &AirRegion::from_latitude, "southern edge [degrees]"),
      of("to_latitude", &AirRegion::to_latitude, "northern edge [degrees]"),
      of("from_position_angle", &AirRegion::from_position_angle,
         "where it begins about the shadow's axis, from north through east [degrees]"),
      of("to_position_angle", &AirRegion::to_position_angle, "where it ends [degrees]")};
  for (auto& each : column_fields<AirRegion>()) all.push_back(std::move(each));
  return all;
}

std::vector<Field<Air>> air_fields() {
  const auto of = [](const char* name, auto Air::*member, const char* text) {
    return field<Air>(
        name, [member](Air & all) -> auto& { return all.*member; }, text);
  };
  std::vector all{
      of("atmosphere", &Air::atmosphere,
         "'standard' (the air of the eclipse's month, by latitude), 'undated' (the same everywhere "
         "and always), 'clear' (air and ozone), 'molecular' (air only), 'paper' (as in Yapo & "
         "Cutler, 2009), 'none'"),
      of("earth", &Air::earth, "figure of the Earth: 'sphere' or 'ellipsoid'"),
      of("density", &Air::density, "'seasonal', 'us-1976' or 'yapo-cutler'"),
      of("refraction", &Air::refraction, "bending of light"),
      of("dispersion", &Air::dispersion, "formula of the refractive index: 'ciddor' or 'crc'"),
      of("rayleigh", &Air::rayleigh, "Rayleigh scattering out of the ray"),
      of("king_factor", &Air::king_factor, "'bates' (by wavelength) or 'fixed' (1.05)"),
      of("ozone_path", &Air::ozone_path,
         "'bent' (along the ray) or 'filter' (the same for all rays)"),
      of("ozone_profile", &Air::ozone_profile, "'climatology' or 'us-1976'"),
      of("oxygen_pairs", &Air::oxygen_pairs, "absorption by pairs of oxygen molecules"),
      of("nitrogen_dioxide", &Air::nitrogen_dioxide, "absorption by nitrogen dioxide")};
  for (auto& each : column_fields<Air>()) all.push_back(std::move(each));
  all.push_back(of("regions", &Air::regions,
                   "parts of the limb with air of their own; the first that holds a place counts"));
  return all;
}

}  // namespace

void add_air(py::module_& package) {
  class_of(package, "Region", region_fields(),
           "A part of the Earth's limb with air of its own: between two latitudes, or between two "
           "position angles. What is None is as the air has it.\n\n"
           ">>> coppermoon.Region(from_latitude=-90, to_latitude=0, dust_extinction=1e-5)\n"
           "Region(from_latitude=-90.0, to_latitude=0.0, dust_extinction=1e-05)")
      .def(
          "__eq__", [](const AirRegion& a, const AirRegion& b) { return a == b; },
          py::is_operator());
  class_of(package, "Air", air_fields(),
           "The Earth's air, term by term, as the command's options of these names have it. What "
           "is None is as the atmosphere has it.\n\n"
           ">>> coppermoon.Air(atmosphere='clear', ozone_du=280)\n"
           "Air(atmosphere='clear', ozone_du=280.0)")
      .def(
          "__eq__", [](const Air& a, const Air& b) { return a == b; }, py::is_operator());
}

}  // namespace coppermoon::python
