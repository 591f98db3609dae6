// SPDX-License-Identifier: MIT
#include "uses/fit/fit.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "algebra/error.h"
#include "colour/camera.h"
#include "colour/camera_spectra.h"
#include "eclipse/contacts.h"
#include "uses/fit/night.h"
#include "uses/fit/reading.h"
#include "uses/picture/photo_file.h"

namespace coppermoon::uses {
namespace {

/// Greatest number of times that a night is processed again.
constexpr int most_turns = 4;

struct Earlier {
  bool operator()(const almanac::Instant& one, const almanac::Instant& other) const {
    return almanac::seconds_between(one, other) > 0;
  }
};

/// Reports the progress of a task that consists of steps of equal length. The reported progress never decreases.
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

/// Records why photographs cannot be used, and keeps the first error.
struct LeftOut {
  const FitRequest& request;
  std::vector<ReadPhotograph>& photographs;  ///< photographs in the order of the request
  std::optional<algebra::Error> first{};

  void add(std::size_t i, const algebra::Error& error) {
    photographs[i].left_out = reason_without_name(request.photographs[i].file, error);
    if (!first) first = error;
  }
};

/// Groups the photographs of a request by camera and eclipse.
ByNight nights_of(const FitRequest& request, LeftOut& left_out) {
  ByNight nights;
  for (std::size_t i = 0; i < request.photographs.size(); ++i) try {
      const auto& photograph = request.photographs[i];
      if (request.clock_error_s == 0 && !clock_is_free(request))
        require_eclipse(photograph.instant);
      const auto eclipse = eclipse::nearest_eclipse(
          photograph.instant, eclipse::ShadowConvention::danjon, almanac::LunarTheory::moon98);
      // gains have no common unit, so photographs with different gains are treated as from different cameras
      const auto camera =
          camera_of(photograph.file).value_or("") + settings_of(photograph.file).gain.value_or("");
      nights[{camera, std::round(eclipse.greatest.tt_day)}].push_back(i);
    } catch (const algebra::Error& error) {
      left_out.add(i, error);
    }
  return nights;
}

/// Camera response that is used for a photograph if the request names none.
std::optional<std::string> usual_response(const EclipsePhotograph& photograph) {
  const auto camera = camera_of(photograph.file);
  const bool own_curve = is_curved(photograph);
  if (!camera || !(own_curve || texture::is_raw_file(photograph.file))) return std::nullopt;
  if (auto known = colour::spectral_camera_of(*camera)) return known;
  return own_curve ? std::optional<std::string>("canon-eos-600d") : std::nullopt;
}

/// Request for one night, reduced to the photographs with the given indices and completed by their camera's response.
FitRequest request_of(FitRequest request, const std::vector<std::size_t>& indices) {
  const auto all = std::exchange(request.photographs, {});
  for (const auto i : indices) request.photographs.push_back(all[i]);
  request.magnitudes.clear();
  if (auto& response = request.moon.response; !response) {
    const auto& first = request.photographs.front();
    response = usual_response(first);
    request.response_assumed =
        response && !colour::spectral_camera_of(camera_of(first.file).value_or(""));
  }
  return request;
}

/// A night, the indices of its photographs in the whole request, and why it was processed again.
struct NightOf {
  std::vector<std::size_t> photographs;
  Night night;
  std::vector<Again> turns{};
};

/// Fits the air to the photographs of several nights and to magnitudes. If the result shows that a night's photographs
/// should be processed again (see why_again), they are processed and the air is fitted again.
AirFit fitted(std::vector<NightOf>& nights, const std::vector<DataSet>& magnitudes, Steps& steps) {
  auto progress = steps.next();
  for (int turn = 0;; ++turn) {
    std::vector<DataSet> data;
    for (const auto& each : nights) data.push_back(data_of(each.night));
    data.insert(data.end(), magnitudes.begin(), magnitudes.end());
    auto fit = fitted_air(data, progress);
    bool anew = false;
    for (auto& [photographs, night, turns] : nights)
      if (const auto why = why_again(night, fit, turn); why != Again::no && turn < most_turns) {
        night = looked_at_again(std::move(night), why, fit, [&](double) { progress(0); });
        turns.push_back(why);
        anew = true;
      }
    if (!anew) return fit;
    progress = steps.next();
  }
}

void require_sound(const FitRequest& request) {
  if (request.exposure_error)
    algebra::require_within("exposure error", *request.exposure_error, 1e-3, 10);
  if (request.shutter_error)
    algebra::require_within("shutter error", *request.shutter_error, 1e-3, 10);
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
  const auto by_night = nights_of(request, left_out);
  ByInstant by_instant;
  for (const auto& magnitude : request.magnitudes)
    by_instant[magnitude.instant].push_back(magnitude);
  Steps steps(progress, by_night.size() + by_instant.size() + 1 + most_turns);
  std::vector<NightOf> nights;
  for (const auto& [key, indices] : by_night) try {
      nights.push_back({indices, first_look(request_of(request, indices), steps.next())});
    } catch (const algebra::Error& error) {
      for (const auto i : indices) left_out.add(i, error);
    }
  if (nights.empty() && by_instant.empty()) throw *left_out.first;
  std::vector<DataSet> magnitudes;
  for (const auto& [instant, measured] : by_instant)
    magnitudes.push_back(data_of(request.moon, unknowns_of(request), almanac::sky_at(instant),
                                 measured, steps.next()));
  report.fit = fitted(nights, magnitudes, steps);
  for (std::size_t n = 0; n < nights.size(); ++n) {
    const auto& [photographs, night, turns] = nights[n];
    const auto read = photographs_of(night);
    for (std::size_t i = 0; i < read.size(); ++i) report.photographs[photographs[i]] = read[i];
    auto& found = report.nights.emplace_back(found_of(night, report.fit, report.fit.clocks[n]));
    found.photographs = photographs;
    found.turns = turns;
    for (const auto i : photographs) found.files.push_back(request.photographs[i].file);
    for (auto& misfit : found.misfits) {
      misfit.photograph = photographs[misfit.photograph];
      misfit.file = request.photographs[misfit.photograph].file;
    }
  }
  for (std::size_t i = 0; i < report.photographs.size(); ++i) {
    report.photographs[i].file = request.photographs[i].file;
    report.photographs[i].instant = almanac::utc_text(request.photographs[i].instant);
  }
  return report;
}

}  // namespace coppermoon::uses
