// SPDX-License-Identifier: MIT
// An eclipse's shader, run step by step as eclipse.json lists its steps.
#pragma once

#include "end_to_end/shadow_strip.h"
#include "support/testing.h"

namespace coppermoon::end_to_end {

/// A folder of `coppermoon shader`.
struct EclipseShader {
  texture::Image strip;
  nlohmann::json facts;

  /// Texel at u and v, straight lines between texel centres, clamped.
  Vector texel(double u, double v) const {
    const double x = std::clamp(u * static_cast<double>(strip.width) - 0.5, 0.,
                                static_cast<double>(strip.width) - 1.001),
                 y = std::clamp(v * static_cast<double>(strip.height) - 0.5, 0.,
                                static_cast<double>(strip.height) - 1.001);
    const auto c = static_cast<std::size_t>(x), r = static_cast<std::size_t>(y);
    const double right = x - static_cast<double>(c), down = y - static_cast<double>(r);
    Vector colour{};
    for (std::size_t k = 0; k < 3; ++k)
      colour[k] = std::lerp(std::lerp(strip(r, c, k), strip(r, c + 1, k), right),
                            std::lerp(strip(r + 1, c, k), strip(r + 1, c + 1, k), right), down);
    return colour;
  }

  /// Light over sunlight at a place of the Moon, some seconds from greatest eclipse.
  Vector at(const Vector& place, double seconds) const { return run(place, seconds).back(); }

  /// Value of a step that has a name.
  double step(const std::string& name, const Vector& place, double seconds) const {
    const auto values = run(place, seconds);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (facts["steps"][i].value("name", "") == name) return values[i][0];
    ADD_FAILURE() << name;
    return 0;
  }

 private:
  /// Values of all steps.
  std::vector<Vector> run(const Vector& place, double seconds) const {
    std::vector<Vector> values;
    for (const auto& step : facts.at("steps")) {
      const auto operation = step.at("operation").get<std::string>();
      std::vector<Vector> of;
      for (const std::size_t operand : step.at("from")) of.push_back(values.at(operand));
      const auto each = [&](auto&& function) {
        const bool scaled = operation == "multiply" && kind(step, 0) != kind(step, 1);
        Vector result;
        for (std::size_t k = 0; k < 3; ++k) result[k] = function(of[0][k], of[1][scaled ? 0 : k]);
        return result;
      };
      const auto one = [&](auto&& function) {
        return Vector{function(of[0][0]), function(of[0][1]), function(of[0][2])};
      };
      if (operation == "place")
        values.push_back(place);
      else if (operation == "time")
        values.push_back({seconds});
      else if (operation == "constant")
        values.push_back(step["value"].is_array() ? step["value"].get<Vector>()
                                                  : Vector{step["value"].get<double>()});
      else if (operation == "add")
        values.push_back(each(std::plus<>()));
      else if (operation == "subtract")
        values.push_back(each(std::minus<>()));
      else if (operation == "multiply")
        values.push_back(each(std::multiplies<>()));
      else if (operation == "divide")
        values.push_back({of[0][0] / of[1][0]});
      else if (operation == "min")
        values.push_back({std::min(of[0][0], of[1][0])});
      else if (operation == "clamp")
        values.push_back(one([](double x) { return std::clamp(x, 0., 1.); }));
      else if (operation == "dotproduct")
        values.push_back({dot(of[0], of[1])});
      else if (operation == "normalize") {
        const double length = std::sqrt(dot(of[0], of[0]));
        values.push_back(one([&](double x) { return x / length; }));
      } else if (operation == "sqrt")
        values.push_back({std::sqrt(of[0][0])});
      else if (operation == "atan2")
        values.push_back({std::atan2(of[0][0], of[1][0])});
      else if (operation == "floor")
        values.push_back({std::floor(of[0][0])});
      else if (operation == "mix") {
        const double share = of[2][0];
        values.push_back(each([&](double a, double b) { return std::lerp(a, b, share); }));
      } else if (operation == "image")
        values.push_back(texel(of[0][0], of[1][0]));
      else
        ADD_FAILURE() << operation;
    }
    return values;
  }

  std::string kind(const nlohmann::json& step, std::size_t operand) const {
    return facts["steps"][step["from"][operand].get<std::size_t>()]["kind"];
  }
};

/// The shader in a folder.
inline EclipseShader read_shader(const std::filesystem::path& folder) {
  return {texture::read_image(folder / "eclipse.exr"),
          nlohmann::json::parse(text_of(folder / "eclipse.json"))};
}

/// Light in all places of one time, within a share of itself.
inline void expect_alike(const std::vector<Vector>& found, const EclipseShader& of,
                         const std::vector<Vector>& places, double seconds, double share,
                         const char* why) {
  double least = 1, most = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto expected = of.at(places[i], seconds);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_WITHIN(found[i][k], expected[k], share * (expected[k] + 1e-5), why);
      least = std::min(least, expected[k]), most = std::max(most, expected[k]);
    }
  }
  EXPECT_LT(least, 1e-3) << "umbra";
  EXPECT_GT(most, seconds < -5000 ? 0.5 : 1e-4);
}

}  // namespace coppermoon::end_to_end
