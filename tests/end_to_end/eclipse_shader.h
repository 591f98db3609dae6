// SPDX-License-Identifier: MIT
// An eclipse's shader, run step by step as eclipse.json lists its steps.
#pragma once

#include <fmt/format.h>

#include "end_to_end/browser.h"
#include "support/testing.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end {

using Vector = std::array<double, 3>;

inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Places all over the Moon.
inline std::vector<Vector> places_on_moon() {
  std::vector<Vector> all;
  constexpr int count = 2000;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.) / count, turn = i * std::numbers::pi * (3 - std::sqrt(5.));
    all.push_back(
        {std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z});
  }
  return all;
}

/// Place of a texel of a texture of so many rows.
inline Vector place_of(std::size_t row, std::size_t column, std::size_t rows) {
  const double texel = std::numbers::pi / static_cast<double>(rows);
  const double latitude = std::numbers::pi / 2 - (static_cast<double>(row) + 0.5) * texel,
               longitude = (static_cast<double>(column) + 0.5) * texel - std::numbers::pi;
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}

inline double brightest(const texture::Image& image, std::size_t row, std::size_t column) {
  return std::max({image(row, column, 0), image(row, column, 1), image(row, column, 2)});
}

/// Light at places on the Moon (unit vectors, Moon-fixed), as a fragment shader of OpenGL ES 3 finds it.
class ShaderTest : public ProgramTest {
 protected:
  /// Given  source    with main; takes the place as `in vec3 positionObject`, and gives a colour
  ///        uniforms  numbers and vectors by name
  ///        sampler   the strip's name; its first row is at v = 0, or the last one if `from_below`
  std::vector<Vector> shaded(const std::string& source, const nlohmann::json& uniforms,
                             const std::string& sampler, const texture::Image& strip,
                             bool from_below, const std::vector<Vector>& places) const {
    std::vector<float> texels;
    for (std::size_t r = 0; r < strip.height; ++r)
      for (std::size_t c = 0; c < strip.width; ++c)
        for (std::size_t k = 0; k < 3; ++k)
          texels.push_back(strip(from_below ? strip.height - 1 - r : r, c, k));
    const nlohmann::json told{{"source", source}, {"uniforms", uniforms}, {"sampler", sampler},
                              {"texels", texels}, {"width", strip.width}, {"height", strip.height},
                              {"places", places}};
    const auto answer =
        answer_of(*this, "", fmt::format("const told = {};\n{}", told.dump(), drawing), "100,100");
    return answer.is_array() ? answer.get<std::vector<Vector>>()
                             : std::vector<Vector>(places.size());
  }

 private:
  /// Draws a point for each place, side by side, in floats.
  static constexpr const char* drawing = R"(
const gl = document.createElement('canvas').getContext('webgl2');
for (const name of ['EXT_color_buffer_float', 'OES_texture_float_linear'])
  if (!gl.getExtension(name)) problems.push(name);
const program = gl.createProgram();
const add = (kind, text) => {
  const shader = gl.createShader(kind);
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) problems.push(gl.getShaderInfoLog(shader));
  gl.attachShader(program, shader);
};
const count = told.places.length;
add(gl.VERTEX_SHADER, `#version 300 es
in vec3 place;
out vec3 positionObject;
void main() {
  positionObject = place;
  gl_Position = vec4((float(gl_VertexID) + 0.5) / ${count}.0 * 2.0 - 1.0, 0.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}`);
add(gl.FRAGMENT_SHADER, told.source);
gl.bindAttribLocation(program, 0, 'place');
gl.linkProgram(program);
if (!gl.getProgramParameter(program, gl.LINK_STATUS)) problems.push(gl.getProgramInfoLog(program));
gl.useProgram(program);
const texture = (width, height, format, texels) => {
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texImage2D(gl.TEXTURE_2D, 0, format, width, height, 0, texels ? gl.RGB : gl.RGBA, gl.FLOAT, texels);
};
texture(count, 1, gl.RGBA32F, null);
const frame = gl.createFramebuffer();
gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D,
                        gl.getParameter(gl.TEXTURE_BINDING_2D), 0);
texture(told.width, told.height, gl.RGB32F, new Float32Array(told.texels));
gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.REPEAT);
gl.uniform1i(gl.getUniformLocation(program, told.sampler), 0);
for (const [name, value] of Object.entries(told.uniforms)) {
  const where = gl.getUniformLocation(program, name);
  if (!where) continue;
  if (Array.isArray(value)) gl[`uniform${value.length}fv`](where, value);
  else {
    gl.uniform1f(where, value);
    if (gl.getError()) gl.uniform1i(where, value);
  }
}
gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(told.places.flat()), gl.STATIC_DRAW);
gl.enableVertexAttribArray(0);
gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
gl.viewport(0, 0, count, 1);
gl.drawArrays(gl.POINTS, 0, count);
const pixels = new Float32Array(4 * count);
gl.readPixels(0, 0, count, 1, gl.RGBA, gl.FLOAT, pixels);
const problem = gl.getError();
if (problem) problems.push(`OpenGL's error ${problem}`);
return told.places.map((place, i) => [...pixels.slice(4 * i, 4 * i + 3)]);
)";
};

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
