// SPDX-License-Identifier: MIT
#include "uses/fit/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "algebra/error.h"
#include "colour/camera.h"
#include "colour/camera_spectra.h"
#include "eclipse/contacts.h"
#include "uses/fit/night.h"
#include "uses/picture/photo_file.h"

namespace coppermoon::uses {
namespace {

struct Earlier {
  bool operator()(const almanac::Instant& one, const almanac::Instant& other) const {
    return almanac::seconds_between(one, other) > 0;
  }
};

/// All data, and what they refer to.
struct Evidence {
  std::vector<std::vector<std::size_t>> photographs;        ///< [night] of the request
  std::vector<std::unique_ptr<const FitRequest>> requests;  ///< [night] with its camera's response
  std::vector<std::unique_ptr<Night>> nights;
  std::vector<MagnitudeData> magnitudes;

  std::vector<DataSet> data() const {
    std::vector<DataSet> all;
    for (const auto& night : nights) all.push_back(night->data());
    for (const auto& magnitude : magnitudes) all.push_back(magnitude.data);
    return all;
  }
};

/// Progress over steps of equal length, which never goes back.
class Steps {
 public:
  Steps(algebra::Progress whole, std::size_t count)
      : whole_(std::move(whole)), count_(static_cast<double>(count)) {}

  algebra::Progress next() {
    return [this, from = done_++](double part) {
      if (!whole_) return;
      const double now = (from + part) / count_;
      double most = most_;
      while (now > most && !most_.compare_exchange_weak(most, now)) {
      }
      whole_(std::max(now, most));
    };
  }

 private:
  algebra::Progress whole_;
  double count_, done_ = 0;
  std::atomic<double> most_ = 0;
};

using ByNight = std::map<std::pair<std::string, double>, std::vector<std::size_t>>;
using ByInstant = std::map<almanac::Instant, std::vector<MeasuredMagnitude>, Earlier>;

/// Photographs that cannot be used, and the first one's error.
struct LeftOut {
  const FitRequest& request;
  std::vector<ReadPhotograph>& photographs;  ///< in the order of the request
  std::optional<algebra::Error> first{};

  void add(std::size_t i, const algebra::Error& error) {
    photographs[i].left_out = reason_without_name(request.photographs[i].file, error);
    if (!first) first = error;
  }
};

/// Photographs by camera and eclipse.
ByNight nights_of(const FitRequest& request, LeftOut& left_out) {
  ByNight nights;
  for (std::size_t i = 0; i < request.photographs.size(); ++i) try {
      const auto& photograph = request.photographs[i];
      if (request.clock_error_s == 0 && !request.half_hours_free && request.clock_search_s == 0)
        require_eclipse(photograph.instant);
      const auto eclipse = eclipse::nearest_eclipse(
          photograph.instant, eclipse::ShadowConvention::danjon, almanac::LunarTheory::moon98);
      // a gain has no unit: at another the camera is another
      const auto camera =
          camera_of(photograph.file).value_or("") + settings_of(photograph.file).gain.value_or("");
      nights[{camera, std::round(eclipse.greatest.tt_day)}].push_back(i);
    } catch (const algebra::Error& error) {
      left_out.add(i, error);
    }
  return nights;
}

/// Response of the camera of a night's photographs, where none is asked for.
std::optional<std::string> usual_response(const EclipsePhotograph& photograph) {
  const auto camera = camera_of(photograph.file);
  const auto coding = coding_of(photograph.file, photograph.coding);
  const bool own_curve = coding == texture::Coding::camera;
  if (!camera || !(own_curve || texture::is_raw_file(photograph.file))) return std::nullopt;
  if (auto known = colour::spectral_camera_of(*camera)) return known;
  return own_curve ? std::optional<std::string>("canon-eos-600d") : std::nullopt;
}

void add_nights(const FitRequest& request, const ByNight& nights, Steps& steps, Evidence& evidence,
                LeftOut& left_out) {
  for (const auto& [key, indices] : nights) try {
      std::vector<const EclipsePhotograph*> photographs;
      for (const auto i : indices) photographs.push_back(&request.photographs[i]);
      auto of_night = std::make_unique<FitRequest>(request);
      auto& response = of_night->moon.response;
      if (!response) {
        response = usual_response(*photographs.front());
        of_night->response_assumed =
            response &&
            !colour::spectral_camera_of(camera_of(photographs.front()->file).value_or(""));
      }
      evidence.nights.push_back(
          std::make_unique<Night>(*of_night, std::move(photographs), steps.next()));
      evidence.requests.push_back(std::move(of_night));
      evidence.photographs.push_back(indices);
    } catch (const algebra::Error& error) {
      for (const auto i : indices) left_out.add(i, error);
    }
}

ByInstant moments_of(const FitRequest& request) {
  ByInstant by_instant;
  for (const auto& magnitude : request.magnitudes)
    by_instant[magnitude.instant].push_back(magnitude);
  return by_instant;
}

void add_magnitudes(const FitRequest& request, const ByInstant& by_instant, Steps& steps,
                    Evidence& evidence) {
  for (const auto& [instant, magnitudes] : by_instant)
    evidence.magnitudes.push_back(data_of(request.moon, unknowns_of(request),
                                          almanac::sky_at(instant), magnitudes, steps.next()));
}

constexpr int most_readings = 4;

/// Air fitted, and again to photographs read, and to light computed, by what was found.
AirFit fitted(const Evidence& evidence, Steps& steps) {
  auto fit = fitted_air(evidence.data(), steps.next());
  for (int reading = 0; reading < most_readings; ++reading) {
    bool anew = false;
    for (const auto& night : evidence.nights) anew = night->refine(fit) || anew;
    if (!anew) break;
    fit = fitted_air(evidence.data(), steps.next());
  }
  return fit;
}

FittedNight found_of(const FitRequest& request, const Evidence& evidence, std::size_t n,
                     const AirFit& fit) {
  const auto& night = *evidence.nights[n];
  FittedNight found{.photographs = evidence.photographs[n],
                    .clock = {},
                    .response = evidence.requests[n]->moon.response,
                    .curve = {},
                    .light = night.measured(fit),
                    .misfits = night.misfits(fit)};
  for (auto& misfit : found.misfits) misfit.photograph = found.photographs[misfit.photograph];
  if (request.clock_error_s > 0)
    found.clock = ClockError{night.clock_s() + fit.clocks[n].seconds, fit.clocks[n].error_s};
  if (night.curved()) found.curve = night.curve(fit);
  return found;
}

void require_sound(const FitRequest& request) {
  if (request.exposure_error)
    algebra::require_within("exposure error", *request.exposure_error, 1e-3, 10);
  algebra::require_within("shutter error", request.shutter_error, 1e-3, 10);
  if (request.white_balance_error)
    algebra::require_within("white balance error", *request.white_balance_error, 1e-3, 10);
  if (request.weather_error) algebra::require_within("weather error", *request.weather_error, 0, 1);
  algebra::require_within("clock error [min]", request.clock_error_s / 60, 0, 60);
  if (!request.camera.empty()) colour::camera_named(request.camera);
  if (request.photographs.empty() && request.magnitudes.empty())
    throw algebra::Error("photographs and magnitudes are missing: one of the two is needed");
}

}  // namespace

Unknowns unknowns_of(const FitRequest& request) {
  return request.unknowns.value_or(usual_unknowns(request.moon.light.air));
}

std::string reason_without_name(const std::string& file, const algebra::Error& error) {
  const std::string what = error.what();
  return what.starts_with(file + ": ") ? what.substr(file.size() + 2) : what;
}

FitReport fitted_air(const FitRequest& request, const algebra::Progress& progress) {
  require_sound(request);
  FitReport report;
  report.photographs.resize(request.photographs.size());
  LeftOut left_out{request, report.photographs};
  const auto nights = nights_of(request, left_out);
  const auto moments = moments_of(request);
  Steps steps(progress, nights.size() + moments.size() + 1 + most_readings);
  Evidence evidence;
  add_nights(request, nights, steps, evidence, left_out);
  if (evidence.nights.empty() && moments.empty()) throw *left_out.first;
  add_magnitudes(request, moments, steps, evidence);
  report.fit = fitted(evidence, steps);
  for (std::size_t n = 0; n < evidence.nights.size(); ++n) {
    const auto read = evidence.nights[n]->read();
    for (std::size_t i = 0; i < read.size(); ++i)
      report.photographs[evidence.photographs[n][i]] = read[i];
    report.nights.push_back(found_of(request, evidence, n, report.fit));
  }
  return report;
}

}  // namespace coppermoon::uses
