// SPDX-License-Identifier: MIT
// A strip of the shadow, read as a shader reads it: here, and by shaders themselves in a browser.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "end_to_end/browser.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end {

using Vector = std::array<double, 3>;

inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A strip with what its .json says of it; the shader's lines, in C++.
struct Strip {
  texture::Image light;
  nlohmann::json facts;

  double fact(const char* name) const { return facts.at(name).get<double>(); }

  /// As a GPU does: straight lines between texel centres, clamped along, wrapped around.
  Vector bilinear(double u, double v) const {
    const auto columns = static_cast<int>(light.width), rows = static_cast<int>(light.height);
    const double x = std::clamp(u * static_cast<double>(columns) - 0.5, 0., columns - 1.),
                 y = v * static_cast<double>(rows) - 0.5;
    const int c = std::min(static_cast<int>(x), columns - 2), r = static_cast<int>(std::floor(y));
    Vector colour{};
    for (std::size_t k = 0; k < 3; ++k)
      for (const int i : {0, 1})
        for (const int j : {0, 1}) {
          const double share = std::abs(1. - i - (x - c)) * std::abs(1. - j - (y - r));
          colour[k] += share * light(static_cast<std::size_t>(((r + j) % rows + rows) % rows),
                                     static_cast<std::size_t>(c + i), k);
        }
    return colour;
  }

  Vector at(const Vector& place) const {
    const auto axis = facts.at("axis_direction").get<Vector>(),
               point = facts.at("axis_point_lunar_radii").get<Vector>();
    const Vector q{place[0] - point[0], place[1] - point[1], place[2] - point[2]};
    const double east = dot(q, facts.at("axis_east").get<Vector>()),
                 north = dot(q, facts.at("axis_north").get<Vector>());
    return at(std::hypot(east, north), std::atan2(east, north),
              fact("axis_point_depth_lunar_radii") + dot(q, axis));
  }

  Vector at(double d, double angle, double depth) const {
    d += (d - fact("limb_lunar_radii")) * (fact("depth_lunar_radii") / depth - 1) *
         std::min(1., d / fact("one_limb_lunar_radii"));
    return bilinear((0.5 + d / fact("step_lunar_radii")) / fact("columns"),
                    angle / (2 * std::numbers::pi) + 0.5 / fact("rows"));
  }
};

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
                             const std::string& sampler, const Strip& strip, bool from_below,
                             const std::vector<Vector>& places) const {
    std::vector<float> texels;
    for (std::size_t r = 0; r < strip.light.height; ++r)
      for (std::size_t c = 0; c < strip.light.width; ++c)
        for (std::size_t k = 0; k < 3; ++k)
          texels.push_back(strip.light(from_below ? strip.light.height - 1 - r : r, c, k));
    const nlohmann::json told{
        {"source", source}, {"uniforms", uniforms},       {"sampler", sampler},
        {"texels", texels}, {"width", strip.light.width}, {"height", strip.light.height},
        {"places", places}};
    const auto answer =
        answer_of(*this, "", fmt::format("const told = {};\n{}", told.dump(), drawing), "100,100");
    return answer.is_array() ? answer.get<std::vector<Vector>>()
                             : std::vector<Vector>(places.size());
  }

  /// The light of places_on_moon, as the strip itself has it.
  static void expect_shaded(const std::vector<Vector>& found, const Strip& strip) {
    const auto places = places_on_moon();
    double worst = 0, least = 1, most = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const double expected = strip.at(places[i])[k];
        worst = std::max(worst, std::abs(found[i][k] - expected) / (expected + 1e-5));
        least = std::min(least, expected), most = std::max(most, expected);
      }
    EXPECT_LT(worst, 0.01) << "a GPU's filter has 256 steps between texels";
    EXPECT_LT(least, 1e-3) << "umbra";
    EXPECT_GT(most, 0.5) << "penumbra";
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

}  // namespace coppermoon::end_to_end
