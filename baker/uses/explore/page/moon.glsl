// SPDX-License-Identifier: MIT
// The Moon, lit pixel by pixel, in the shadow's frame [km]. It is compiled twice: for the screen, and with RAW to
// return the bits of the radiance in red, green, blue and V.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler3D;

uniform vec3 centre;         // of the Moon
uniform float sunDistance;
uniform float moonRadius;
uniform mat3 moonFromShadow; // to Moon-fixed axes
uniform float earthRadius;
uniform float au;

uniform sampler2D light;     // log2, [plane × sector][node, on the reddest ground before the bluest]
uniform int nodes, sectors;
uniform vec3 ends, stretches;  // axis distances at which stretches end, and their numbers of nodes
uniform vec2 depths;         // of the planes
uniform float middleDepth;

uniform sampler2D map;       // logarithm of albedo
uniform vec2 mapLogs;        // smallest logarithm, and range
uniform vec2 mapLongitudes;  // first longitude, and range [rad]

uniform sampler2D ground;    // colour and surge by place, 0 for the lowest and 1 for the highest
uniform vec2 groundLongitudes;
uniform float widestSurge;

uniform vec4 law;            // photometric law: scale, and weights for incidence, emission and 1
uniform float phases[61], surges[61];  // phase factors, and their change per unit of surge
uniform float phaseStep;     // [rad]
uniform bool shadowed;

uniform float moonDistance;  // from the observer
uniform vec3 forward, right, up;
uniform vec2 middle;         // of the picture, relative to the disc's middle [lunar radii]
uniform float pixel;         // size of a pixel [lunar radii]
uniform vec2 size;           // of the picture [pixels]

#ifdef RAW
uniform sampler2D places;    // unit vectors to ground, Moon-fixed
uniform bool atPlaces;       // whether to light `places` rather than a picture
#endif

const float pi = 3.14159265358979;

float sheared(float d, float deeper) {
  return d + (d - 6390.0) * (deeper - 1.0) * min(1.0, d / 1500.0);
}

// Position among the nodes for an axis distance.
float nodeAt(float d) {
  if (d < ends.x) return d / ends.x * stretches.x;
  if (d < ends.y) return stretches.x + (d - ends.x) / (ends.y - ends.x) * stretches.y;
  return stretches.x + stretches.y + (d - ends.y) / (ends.z - ends.y) * stretches.z;
}

// Light in a row at a position among the nodes, on the reddest (0) or bluest (1) ground.
vec4 atNode(int row, float node, int bluest) {
  int low = clamp(int(floor(node)), 0, nodes - 2);
  float part = clamp(node - float(low), 0.0, 1.0);
  return mix(texelFetch(light, ivec2(2 * low + bluest, row), 0),
    texelFetch(light, ivec2(2 * low + 2 + bluest, row), 0), part);
}

// Radiance of white ground that faces the Sun at 1 au, in the light at a place in the shadow, for the reddest (0) or
// bluest (1) colour of ground.
vec4 lightAt(vec3 place, int bluest) {
  if (!shadowed) return exp2(texelFetch(light, ivec2(2 * (nodes - 1) + bluest, 0), 0));
  float node = nodeAt(sheared(length(place.xy), middleDepth / place.z));
  float turn = atan(place.x, place.y) / (2.0 * pi);
  float sector = fract(turn + 1.0) * float(sectors);
  int low = min(int(floor(sector)), sectors - 1);
  float around = sector - float(low);
  float deeper = clamp((place.z - depths.x) / (depths.y - depths.x), 0.0, 1.0);
  int next = sectors + 1;
  vec4 nearer = mix(atNode(low, node, bluest), atNode(low + 1, node, bluest), around);
  vec4 farther = mix(atNode(next + low, node, bluest), atNode(next + low + 1, node, bluest), around);
  return exp2(mix(nearer, farther, deeper));
}

float phaseFactor(vec3 toSun, vec3 toEarth, float surge) {
  float sine = length(cross(toSun, toEarth)) / (length(toSun) * length(toEarth));
  float phase = max(asin(min(sine, 1.0)), asin(earthRadius / length(toEarth)));
  float place = min(phase / phaseStep, 59.999);
  int low = int(place);
  float part = place - float(low);
  return mix(phases[low], phases[low + 1], part) + surge * mix(surges[low], surges[low + 1], part);
}

// Longitude, and how far the ground is from the north pole (0) to the south pole (1).
vec2 onMap(vec3 normal) {
  vec3 fixedGround = moonFromShadow * normal;
  return vec2(atan(fixedGround.y, fixedGround.x), 0.5 - asin(clamp(fixedGround.z, -1.0, 1.0)) / pi);
}

float albedoAt(vec2 place) {
  vec2 at = vec2((place.x - mapLongitudes.x) / mapLongitudes.y, place.y);
#ifdef RAW
  if (atPlaces) return exp(mapLogs.x + mapLogs.y * textureLod(map, at, 0.0).r);  // pixels are not neighbours
#endif
  return exp(mapLogs.x + mapLogs.y * texture(map, at).r);
}

// Radiance of ground in red, green and blue [cd/m²] and V, given its normal.
vec4 radianceOf(vec3 normal) {
  vec3 place = centre + moonRadius * normal;
  vec3 toSun = vec3(0.0, 0.0, -sunDistance) - place;
  float incidence = dot(normal, toSun) / length(toSun);
  if (incidence <= 0.0) return vec4(0.0);
  float emission = max(0.0, dot(normal, -place) / length(place));
  float reflected = law.x * incidence / (law.y * incidence + law.z * emission + law.w);
  float nearer = au / length(toSun);
  vec2 at = onMap(normal);
  vec2 own = textureLod(ground, vec2((at.x - groundLongitudes.x) / groundLongitudes.y, at.y), 0.0).rg;
  float phase = phaseFactor(toSun, -place, widestSurge * (2.0 * own.g - 1.0));
  return albedoAt(at) * reflected * phase * nearer * nearer *
    mix(lightAt(place, 0), lightAt(place, 1), own.r);
}

// Ground seen at a point in the picture, and how far inside the limb the point is [lunar radii].
vec3 groundAt(vec2 at, out float inside) {
  float reach = length(at), away = moonRadius / moonDistance * reach;
  float cosine = inversesqrt(1.0 + away * away), sine = away * cosine;
  float nearest = moonDistance * sine;
  inside = 1.0 - nearest / moonRadius;
  vec3 outward = reach > 0.0 ? (at.x * right + at.y * up) / reach : right;
  vec3 sight = cosine * forward + sine * outward, across = cosine * outward - sine * forward;
  nearest = min(nearest, moonRadius);  // beside the Moon, use its limb
  float halfChord = sqrt(max(0.0, moonRadius * moonRadius - nearest * nearest));
  return (nearest * across - halfChord * sight) / moonRadius;
}

#ifdef RAW
out uvec4 bits;
void main() {
  vec4 value = vec4(0.0);
  if (atPlaces) {
    value = radianceOf(transpose(moonFromShadow) * texelFetch(places, ivec2(gl_FragCoord.xy), 0).xyz);
  } else {
    float inside;
    vec3 ground = groundAt(middle + (gl_FragCoord.xy - 0.5 * size) * pixel, inside);
    if (inside > 0.0) value = radianceOf(ground);
  }
  bits = floatBitsToUint(value);
}
#else
uniform float exposure;      // of 1 cd/m², relative to saturation
uniform int look;            // 0: display sRGB, 1: a table, 2: stops, 3: hue kept
uniform sampler3D view;
uniform vec2 viewCode;       // gain, stops
uniform float viewSize;
uniform vec3 around;         // light from the sky around and in front of the Moon [cd/m²]
uniform float fullMoon;      // luminance of a full Moon [cd/m²]
uniform vec3 stopColours[10];
uniform float darker;        // factor on the colour for the lower of two stops
out vec4 colour;

vec3 srgb(vec3 light) {
  vec3 x = clamp(light, 0.0, 1.0);
  return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, lessThanEqual(x, vec3(0.0031308)));
}

vec3 linear(vec3 coded) {
  return mix(pow((coded + 0.055) / 1.055, vec3(2.4)), coded / 12.92, lessThanEqual(coded, vec3(0.04045)));
}

vec3 viewed(vec3 light) {
  vec3 code = clamp(log2(1.0 + viewCode.x * max(light, 0.0)) / viewCode.y, 0.0, 1.0);
  return texture(view, (code * (viewSize - 1.0) + 0.5) / viewSize).rgb;
}

// The view Hue-preserving in colour/config.ocio: a shoulder for the brightest channel, and overexposure fades to white.
vec3 hueKept(vec3 light) {
  float most = max(light.r, max(light.g, light.b)), least = min(light.r, min(light.g, light.b));
  float held = most < 0.8 ? most : 0.8 + 0.04 * log(1.0 + (most - 0.8) / 0.04);
  float saturation = 1.0 - least / max(most, 1e-30);
  float kept = max(0.0, 1.0 - 0.03 * (most - held) / max(saturation, 1e-6));
  return min(held, 1.0) * (1.0 - kept * (1.0 - light / max(most, 1e-30)));
}

// Stops below a full Moon: one colour for every two stops, darker for the lower one.
vec3 stops(vec3 light) {
  float below = log2(fullMoon / max(dot(light, vec3(0.2126, 0.7152, 0.0722)), 1e-12));
  int step = clamp(int(floor(below / 2.0)), 0, 9);
  return stopColours[step] * (fract(below / 2.0) < 0.5 ? 1.0 : darker);
}

float noise(vec2 at) { return fract(52.9829189 * fract(dot(at, vec2(0.06711056, 0.00583715)))) - 0.5; }

vec3 shown(vec3 seen) {
  vec3 light = seen * exposure;
  return look == 2 ? stops(seen) : look == 1 ? viewed(light) : srgb(look == 3 ? hueKept(light) : light);
}

void main() {
  float inside;
  vec3 ground = groundAt(middle + (gl_FragCoord.xy - 0.5 * size) * pixel, inside);
  float cover = clamp(inside / pixel + 0.5, 0.0, 1.0);
  bool black = around == vec3(0.0);
  if (cover <= 0.0 && black) { colour = vec4(0.0, 0.0, 0.0, 1.0); return; }
  vec3 seen = cover > 0.0 ? max(radianceOf(ground).rgb, 0.0) + around : vec3(0.0);
  vec3 beside = black ? vec3(0.0) : linear(shown(around));
  // coverage at the limb weights light as displayed, so that a clipped limb is not jagged
  colour = vec4(srgb(mix(beside, linear(shown(seen)), cover)) + noise(gl_FragCoord.xy) / 255.0, 1.0);
}
#endif
