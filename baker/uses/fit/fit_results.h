// SPDX-License-Identifier: MIT
// Descriptions of a fit's results, for documents and Python.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algebra/described.h"
#include "uses/fit/fit.h"
#include "uses/fit/misfit.h"

namespace coppermoon::uses {

/// Name of a channel by its index: red, green or blue.
inline algebra::Word channel_named(std::size_t channel) {
  const std::vector<std::string_view> names{"red", "green", "blue"};
  return {names[channel], names};
}

/// Converts an estimate to the unit of its unknown, undoing the logarithm if there is one.
inline Estimate in_its_unit(const Unknown& unknown, const Estimate& estimate) {
  return {unknown.from_axis(estimate.median), unknown.from_axis(estimate.low),
          unknown.from_axis(estimate.high), estimate.information};
}

/// A result counts as determined by the data if they reduce its prior variance by at least this share.
inline constexpr double told_information = 0.3;

template <class Field>
void describe(Field&& is, const Estimate& estimate) {
  is.a("Estimate", "One number of the air, as far as it is known.");
  is("median", estimate.median, "as likely above as below");
  is("low_68", estimate.low, "where the middle 68 % of the probability begins");
  is("high_68", estimate.high, "where the middle 68 % of the probability ends");
  is("told", estimate.information >= told_information,
     "whether what was seen tells it: information is 0.3 or more");
  is("information", estimate.information,
     "1 - its variance over that before anything was seen: 0 (nothing learnt) to 1");
}

template <class Field>
void describe(Field&& is, const ClippedAt& clipped) {
  is.a("ClippedAt", "Number of a FITS file that counts as clipped.");
  is("number", clipped.number, "as in the file");
  is("source", algebra::Word{clipped.of_header ? "DATAMAX" : "greatest", {"DATAMAX", "greatest"}},
     "the header, or the greatest number");
}

template <class Field>
void describe(Field&& is, const ReadPhotograph& photograph) {
  const auto if_dated = [&](auto value) {
    return algebra::if_any(photograph.instant ? std::optional(value) : std::nullopt);
  };
  const auto if_used = [&](auto value) {
    return algebra::if_any(photograph.left_out.empty() ? std::optional(value) : std::nullopt);
  };
  is.a("PhotographRead", "How a photograph was read for a fit.");
  is("file", photograph.file, "its path");
  is("instant", photograph.instant, "the moment told; none: its header has no date");
  is("numbers", if_dated(photograph.measurements), "how many numbers it gave");
  is("exposure_known", if_dated(photograph.exposure_known),
     "whether its exposure was known; else any is as likely");
  is("coding", if_dated(std::string(photograph.curved ? "camera" : "known")),
     "camera: its tone curve was in question; known: it was not");
  is("clipped_at", algebra::if_any(photograph.clipped_at),
     "number of a FITS file that counts as clipped; none: the format's own");
  is("mirrored", if_used(photograph.registration.render_to_photo.mirrored),
     "whether it shows the Moon mirrored");
  is("correlation", if_used(photograph.registration.correlation),
     "of its markings with those of the Moon that it was laid over, -1 to 1");
  is("left_out",
     algebra::if_any(photograph.left_out.empty() ? std::nullopt
                                                 : std::optional(photograph.left_out)),
     "why it tells nothing, one line; none: it was used");
}

template <class Field>
void describe(Field&& is, const ClockError& clock) {
  is.a("Clock", "Correction of a camera's clock.");
  is("add_s", clock.seconds, algebra::unit::seconds, "what is to be added to its instants");
  is("standard_error_s", clock.error_s, algebra::unit::seconds, "standard error of that");
  is("zone", algebra::if_any(clock.zone.empty() ? std::nullopt : std::optional(clock.zone)),
     "zone in which its instants were taken, or GPS");
}

template <class Field>
void describe(Field&& is, const Misfit& misfit) {
  is.a("Misfit", "How the light of a photograph in one channel differs from that of the air.");
  is("file", misfit.file, "the photograph");
  is("channel", channel_named(misfit.channel), "the channel");
  is("numbers", misfit.count, "how many numbers were compared");
  is("chi_squared", misfit.chi_squared, "their part of chi squared");
  is("mean_log_ratio", misfit.mean, "mean logarithm of its light over that of the air");
  is("worst_km", misfit.worst_km, algebra::unit::kilometres,
     "distance from the shadow's axis where they differ most");
  is("worst_log_ratio", misfit.worst, "logarithm of the ratio there");
}

template <class Field>
void describe(Field&& is, const FittedNight& night) {
  using Numbers = std::vector<double>;
  is.a("Night", "Camera of one night, as far as its photographs tell.");
  is("photographs", night.files, "files of its photographs");
  is("response", night.response, "through which its camera sees; none: the CIE 1931 observer");
  is("clock", algebra::of_any(&night, &FittedNight::clock),
     "its clock; none: instants were taken as right");
  is("tone_curve",
     night.curve ? std::optional(Numbers(night.curve->numbers.begin(),
                                         night.curve->numbers.begin() + colour::tone_components))
                 : std::nullopt,
     "the camera's tone curve: its principal components, in standard deviations over cameras; "
     "none: "
     "not in question");
  is("misfits", night.misfits, "by photograph and channel");
}

template <class Field>
void describe(Field&& is, const Suspicion& suspicion) {
  is.a("Suspicion", "Likely reason of a misfit.");
  is("file", suspicion.worst.file, "the photograph that misfits most");
  is("channel", channel_named(suspicion.worst.channel), "the channel in which it does");
  is("place",
     algebra::Word{part_of_shadow(suspicion.worst.worst_km),
                   {"umbra", "edge of the umbra", "penumbra"}},
     "where on the Moon");
  is("suspect",
     algebra::Word{suspect_names[static_cast<std::size_t>(suspicion.suspect)],
                   {suspect_names.begin(), suspect_names.end()}},
     "what is wrong");
}

template <class Field>
void describe(Field&& is, const FitReport& report) {
  const auto& [estimates, correlation, least] = report.fit.posterior;
  is.a("Fit", "The air that explains what was measured.");
  for (const auto unknowns : {Unknowns::factors, Unknowns::amounts})
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& unknown = unknowns_of(unknowns)[i];
      is(unknown.key,
         algebra::if_any(report.fit.unknowns == unknowns
                             ? std::optional(in_its_unit(unknown, estimates[i]))
                             : std::nullopt),
         algebra::Unit{unknown.unit},
         std::string(unknown.title) + " found; none: it was not looked for");
    }
  is("correlation",
     algebra::ByName<double>{{"aerosol_cloud", correlation[0][1]},
                             {"aerosol_ozone", correlation[0][2]},
                             {"cloud_ozone", correlation[1][2]}},
     "of the unknowns; logarithms where one is a factor or dust");
  is("chi_squared", least, "sum of squared differences over the errors, of the best air");
  is("explained", explains(report.fit),
     "whether that air explains them; if not, the estimates mean little");
  is("numbers", report.fit.measurements, "how many numbers were compared");
  is("nights", report.nights, "the camera of each night");
  is("photographs", report.photographs, "how each photograph was read");
  is("misfit", algebra::of_any(&report, suspicion_of),
     "likely reason of a misfit; none: all is as expected");
}

}  // namespace coppermoon::uses
