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

/// Spectral sensitivity of a camera's red, green and blue channel, lens and filters included, and its colour matrix.
struct CameraSpectra {
  algebra::Table table;   ///< columns wavelength_nm, r, g, b; of any scale
  glm::dvec3 daylight{};  ///< signals of a white ground under D65, in the table's unit × nm
  glm::dmat3 xyz_from_balanced{1};  ///< from signals over `daylight`; white ground has Y = 1
  double mean_delta_e = 0,
         most_delta_e = 0;  ///< CIEDE2000 of the patches that the matrix is fitted to
};

/// Cameras of data/camera_spectra.csv: canon-eos-600d, nikon-d850, sony-ilce-7m3, …
const std::vector<std::string>& camera_spectra_names();

/// Camera of camera_spectra_names that a photograph's header names: "NIKON CORPORATION NIKON D850", "ILCE-7M3"; nothing
/// for others.
std::optional<std::string> spectral_camera_of(std::string_view name_in_header);

/// Whether a response is spectral: one of camera_spectra_names, or a file that ends in .csv.
bool is_spectral(std::string_view response);

/// Spectra of a camera, and the matrix that makes colours of its channels.
///
/// The matrix is the least-squares one from white-balanced channels to XYZ over the 24 patches of a ColorChecker
/// under D65, such that white stays white. Raw converters use matrices of this kind.
///
/// Given     response  one of camera_spectra_names, or a .csv file: columns wavelength_nm, increasing; r, g and b, 0 or
///                     more; 10 to 100000 rows. Only 380 to 780 nm count
/// Accuracy  mean CIEDE2000 of the patches 0.6 to 1.4, the largest 1.9 to 4.3
/// Omits     differences between specimens, and between lenses
/// Throws    Error     for another name: lists those there are; for a file that is no such table, or whose channels
///                     see nothing, or are so alike that they tell no colours
/// Source    rawtoaces-data of the Academy Software Foundation; ColorChecker: N. Ohta (1997)
CameraSpectra camera_spectra(const std::string& response);

/// Refuses a response that is neither spectral nor "colorimetric", the CIE 1931 observer.
///
/// Throws  Error  as camera_spectra
void require_spectral(const std::string& response);

/// Weights as xyz_weights has them, of the XYZ that a camera's matrix makes of its channels. D65 keeps the XYZ that the
/// CIE 1931 observer gives it; a camera whose curves are linear combinations of that observer's sees as that observer.
///
/// Given     edges_nm  as in xyz_weights
/// Returned  [X Y Z][band], cd/m² per W m⁻² sr⁻¹ nm⁻¹; some are negative
algebra::Grid<double> xyz_weights(std::span<const double> edges_nm, const CameraSpectra& camera);

}  // namespace coppermoon::colour
