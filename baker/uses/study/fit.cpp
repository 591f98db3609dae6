// SPDX-License-Identifier: MIT
#include "uses/study/fit.h"

#include <fmt/format.h>

#include <list>
#include <map>

#include "algebra/error.h"
#include "colour/camera.h"
#include "colour/exposure.h"
#include "uses/picture/photo_file.h"
#include "uses/study/fit_witness.h"

namespace coppermoon::uses {
namespace {

struct Earlier {
  bool operator()(const almanac::Instant& one, const almanac::Instant& other) const {
    return almanac::seconds_between(one, other) > 0;
  }
};

/// All that tells of the air, for as long as it is asked.
struct Evidence {
  std::map<almanac::Instant, FitScene, Earlier> scenes;
  std::list<MagnitudeWitness> magnitudes;
  std::vector<Witness> witnesses;
  std::vector<ReadPhotograph> photographs;
};

/// Exposure as told, else as the header says; nothing unless all of it is known.
std::optional<colour::Exposure> exposure_of(const EclipsePhotograph& photograph) {
  const auto exif = exif_of(photograph.file);
  if (!exif && !(photograph.time_s && photograph.iso && photograph.f_number)) return std::nullopt;
  auto exposure = exif.value_or(colour::Exposure{});
  exposure.time_s = photograph.time_s.value_or(exposure.time_s);
  exposure.iso = photograph.iso.value_or(exposure.iso);
  exposure.f_number = photograph.f_number.value_or(exposure.f_number);
  return exposure;
}

PhotometricErrors errors_of(const FitRequest& request, const EclipsePhotograph& photograph) {
  PhotometricErrors errors{{}, request.exposure_error, request.white_balance_error};
  const auto exposure = exposure_of(photograph);
  if (!exposure) return errors;
  errors.value_per_cd_m2 =
      request.camera.empty()
          ? colour::exposure_scale(*exposure)
          : 1 / colour::saturation_cd_m2(colour::camera_named(request.camera), *exposure);
  return errors;
}

const FitScene& scene_at(const almanac::Instant& instant, const FitRequest& request,
                         Evidence& evidence) {
  const auto known = evidence.scenes.find(instant);
  if (known != evidence.scenes.end()) return known->second;
  auto scene = fit_scene(request.moon, request.view, almanac::sky_at(instant));
  return evidence.scenes.emplace(instant, std::move(scene)).first->second;
}

void add_photograph(const FitRequest& request, const EclipsePhotograph& photograph,
                    Evidence& evidence) {
  const auto photo = texture::read_light(photograph.file, photograph.coding);
  const auto errors = errors_of(request, photograph);
  const auto& scene = scene_at(photograph.instant, request, evidence);
  try {
    const auto light = binned(scene, photo);
    evidence.witnesses.push_back(witness_of(scene, light, errors));
    evidence.photographs.push_back(
        {light.registration, errors.value_per_cd_m2.has_value(), evidence.witnesses.back().count});
  } catch (const algebra::Error& error) {
    throw algebra::Error(fmt::format("{}: {}", photograph.file, error.what()));
  }
}

void add_magnitudes(const FitRequest& request, Evidence& evidence) {
  std::map<almanac::Instant, std::vector<MeasuredMagnitude>, Earlier> by_instant;
  for (const auto& magnitude : request.magnitudes)
    by_instant[magnitude.instant].push_back(magnitude);
  for (const auto& [instant, magnitudes] : by_instant) {
    evidence.magnitudes.push_back(witness_of(request.moon, almanac::sky_at(instant), magnitudes));
    evidence.witnesses.push_back(evidence.magnitudes.back().witness);
  }
}

void require_sound(const FitRequest& request) {
  algebra::require_within("exposure error", request.exposure_error, 1e-3, 10);
  algebra::require_within("white balance error", request.white_balance_error, 1e-3, 10);
  if (!request.camera.empty()) colour::camera_named(request.camera);
  if (request.photographs.empty() && request.magnitudes.empty())
    throw algebra::Error("photographs and magnitudes are missing: one of the two is needed");
}

}  // namespace

FitReport fitted_air(const FitRequest& request) {
  require_sound(request);
  Evidence evidence;
  for (const auto& photograph : request.photographs) add_photograph(request, photograph, evidence);
  add_magnitudes(request, evidence);
  return {fitted_air(evidence.witnesses), std::move(evidence.photographs)};
}

}  // namespace coppermoon::uses
