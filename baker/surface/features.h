// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

namespace coppermoon::surface {

/// A place on the unit sphere with the directions along the ground there.
struct Site {
  double latitude_rad, longitude_rad;
  glm::vec3 up, east, north;
};

Site site(double latitude_rad, double longitude_rad);

/// An ellipse of another albedo; its edge reaches from 1 − softness to 1 + softness of its size.
struct Patch {
  Site at;
  float semi_east_rad, semi_north_rad, cos_turn, sin_turn, albedo, softness;
};

/// One ray of a fresh crater.
struct Ray {
  float east, north;  ///< where it leads to, a unit vector
  float length_rad, half_width_rad, strength;
};

/// A fresh crater: a bright floor and halo, and rays.
struct RayCrater {
  Site at;
  float radius_rad, albedo;
  std::vector<Ray> rays;
};

/// A nameless old crater: a bright wall around a floor.
struct OldCrater {
  Site at;
  float radius_rad, contrast;
};

/// What the built-in Moon is drawn from, in the order of drawing.
struct Features {
  std::vector<Patch> patches;
  std::vector<OldCrater> old_craters;  ///< scattered at random, always the same
  std::vector<RayCrater> ray_craters;
};

/// Reads a table of features.
///
/// Throws  Error  "<name>:<row>: …" for a cell that is no number, an unknown kind, a missing cell
Features features(std::string_view table, std::string_view name);

}  // namespace coppermoon::surface
