// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/grid.h"
#include "algebra/table.h"

namespace coppermoon::colour {

/// Spectral sensitivity of a camera's red, green and blue channels, lens and filters included, and its colour matrix.
struct CameraSpectra {
  algebra::Table table;   ///< columns wavelength_nm, r, g, b; sensitivities on any scale
  glm::dvec3 daylight{};  ///< signals from a white surface under D65, in the table's unit × nm
  glm::dmat3 xyz_from_balanced{1};  ///< maps signals divided by `daylight` to XYZ; white has Y = 1
  double mean_delta_e = 0,
         most_delta_e = 0;  ///< mean and largest CIEDE2000 error over the patches used in the fit
};

/// Names of the cameras in data/camera_spectra.csv: canon-eos-600d, nikon-d850, sony-ilce-7m3, …
const std::vector<std::string>& camera_spectra_names();

/// Name of a camera in camera_spectra_names, given its name in a photograph's header, such as "NIKON CORPORATION NIKON
/// D850" or "ILCE-7M3". Returns nothing if that list does not have the camera.
std::optional<std::string> spectral_camera_of(std::string_view name_in_header);

/// Whether a response is spectral: one of camera_spectra_names, or a file whose name ends in .csv.
bool is_spectral(std::string_view response);

/// Spectral sensitivities of a camera, and the matrix that turns its channels into colours.
///
/// The matrix from white-balanced channels to XYZ is fitted by least squares to the 24 patches of a ColorChecker under
/// D65, with the condition that white stays white. Raw converters use matrices of this kind.
///
/// Given     response  one of camera_spectra_names, or a .csv file with 10 to 100000 rows and the columns wavelength_nm
///                     (increasing), r, g and b (0 or more). Only wavelengths from 380 to 780 nm are used
/// Accuracy  CIEDE2000 errors over the patches, by camera: mean 0.6 to 1.4, largest 1.9 to 4.3
/// Omits     differences between specimens of a camera, and between lenses
/// Throws    Error     for any other name, listing the valid ones; for a file that is not such a table; for channels
///                     that are insensitive to light, or too alike to tell colours apart
/// Source    rawtoaces-data of the Academy Software Foundation; ColorChecker: N. Ohta (1997)
CameraSpectra camera_spectra(const std::string& response);

/// Refuses a response that is neither spectral nor "colorimetric" (the CIE 1931 observer).
///
/// Throws  Error  as for camera_spectra
void require_spectral(const std::string& response);

/// Weights that turn band means of a spectral radiance into XYZ by way of a camera's channels and its colour matrix.
/// For D65, XYZ is the same as for the CIE 1931 observer. If the camera's curves are linear combinations of the
/// observer's curves, all weights are the same as the observer's.
///
/// Given     edges_nm  as in xyz_weights
/// Returned  [X Y Z][band], cd/m² per W m⁻² sr⁻¹ nm⁻¹; some are negative
algebra::Grid<double> xyz_weights(std::span<const double> edges_nm, const CameraSpectra& camera);

}  // namespace coppermoon::colour
