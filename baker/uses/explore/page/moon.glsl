// SPDX-License-Identifier: MIT
// Shader that computes the light of each pixel of the Moon, in the shadow's frame [km]. It is compiled twice: once to
// draw on the screen, and once with RAW defined, to return the radiance in red, green, blue and V as bits of floats.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler3D;

uniform vec3 centre;         // position of the Moon's centre
uniform float sunDistance;
uniform float moonRadius;
uniform mat3 moonFromShadow; // rotation from the shadow's axes to Moon-fixed axes
uniform float earthRadius;
uniform float au;

// log2 of light: a row for each depth and position angle; two columns (reddest, bluest ground) for each axis distance
uniform sampler2D light;
uniform int nodes, sectors;
uniform vec3 ends, stretches;  // ends of three ranges of axis distance, and number of nodes in each range
uniform vec2 depths;         // distances of the table's two planes behind the Earth's centre
uniform float middleDepth;

uniform sampler2D map;       // logarithm of albedo, scaled to 0 to 1
uniform vec2 mapLogs;        // the map's smallest logarithm of albedo, and its range of logarithms
uniform vec2 mapLongitudes;  // the map's first longitude, and its range of longitudes [rad]

uniform sampler2D ground;    // the ground's colour and opposition surge, each scaled to 0 to 1
uniform vec2 groundLongitudes;
uniform float widestSurge;

uniform vec4 law;            // photometric law: scale, and coefficients of incidence, emission and a constant
uniform float phases[61], surges[61];  // phase factors, and their change per unit of opposition surge
uniform float phaseStep;     // phase angle between table entries [rad]
uniform bool shadowed;

uniform float moonDistance;  // distance of the Moon's centre from the observer
uniform vec3 forward, right, up;
uniform vec2 middle;         // picture's centre relative to the disc's centre [lunar radii]
uniform float pixel;         // size of a pixel [lunar radii]
uniform vec2 size;           // width and height of the picture [pixels]

#ifdef RAW
uniform sampler2D places;    // unit vectors to points on the ground, in Moon-fixed axes
uniform bool atPlaces;       // whether to compute light at `places` instead of a picture
#endif

const float pi = 3.14159265358979;

float sheared(float d, float deeper) {
  return d + (d - 6390.0) * (deeper - 1.0) * min(1.0, d / 1500.0);
}

// Fractional index of the node at a distance from the shadow's axis.
float nodeAt(float d) {
  if (d < ends.x) return d / ends.x * stretches.x;
  if (d < ends.y) return stretches.x + (d - ends.x) / (ends.y - ends.x) * stretches.y;
  return stretches.x + stretches.y + (d - ends.y) / (ends.z - ends.y) * stretches.z;
}

// Logarithm of light in one row of the table, interpolated between nodes, on the reddest (0) or bluest (1) ground.
vec4 atNode(int row, float node, int bluest) {
  int low = clamp(int(floor(node)), 0, nodes - 2);
  float part = clamp(node - float(low), 0.0, 1.0);
  return mix(texelFetch(light, ivec2(2 * low + bluest, row), 0),
    texelFetch(light, ivec2(2 * low + 2 + bluest, row), 0), part);
}

// Radiance of ground with albedo 1 that faces the Sun, at a place in the shadow, with the Sun at 1 au. The ground has
// the Moon's reddest (0) or bluest (1) colour.
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

// Map coordinates of the ground with this normal: longitude [rad], and 0 at the north pole to 1 at the south pole.
vec2 onMap(vec3 normal) {
  vec3 fixedGround = moonFromShadow * normal;
  return vec2(atan(fixedGround.y, fixedGround.x), 0.5 - asin(clamp(fixedGround.z, -1.0, 1.0)) / pi);
}

float albedoAt(vec2 place) {
  vec2 at = vec2((place.x - mapLongitudes.x) / mapLongitudes.y, place.y);
#ifdef RAW
  if (atPlaces) return exp(mapLogs.x + mapLogs.y * textureLod(map, at, 0.0).r);  // mipmaps need neighbouring places
#endif
  return exp(mapLogs.x + mapLogs.y * texture(map, at).r);
}

// Radiance of the ground with this normal in red, green, blue [cd/m²] and V.
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

// Normal of the ground that is seen at a point in the picture, and the point's distance inside the limb [lunar radii].
vec3 groundAt(vec2 at, out float inside) {
  float reach = length(at), away = moonRadius / moonDistance * reach;
  float cosine = inversesqrt(1.0 + away * away), sine = away * cosine;
  float nearest = moonDistance * sine;
  inside = 1.0 - nearest / moonRadius;
  vec3 outward = reach > 0.0 ? (at.x * right + at.y * up) / reach : right;
  vec3 sight = cosine * forward + sine * outward, across = cosine * outward - sine * forward;
  nearest = min(nearest, moonRadius);  // outside the disc, use the nearest point of the limb
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
uniform float exposure;      // pixel value for 1 cd/m²; a value of 1 is saturated
uniform int look;            // 0: plain sRGB; 1: view from a table; 2: false colours by stops; 3: hue-preserving view
uniform sampler3D view;
uniform vec2 viewCode;       // gain and stops: `view` is read at log2(1 + gain x) / stops of each channel x
uniform float viewSize;
uniform vec3 around;         // light of the sky around and in front of the Moon [cd/m²]
uniform float fullMoon;      // luminance of a full Moon [cd/m²]
uniform vec3 stopColours[10];
uniform float darker;        // two stops share a false colour, which this factor darkens for the fainter stop
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

// Same as the view "Hue-preserving" in colour/config.ocio. The brightest channel is compressed smoothly near white, and
// overexposed colours fade to white.
vec3 hueKept(vec3 light) {
  float most = max(light.r, max(light.g, light.b)), least = min(light.r, min(light.g, light.b));
  float held = most < 0.8 ? most : 0.8 + 0.04 * log(1.0 + (most - 0.8) / 0.04);
  float saturation = 1.0 - least / max(most, 1e-30);
  float kept = max(0.0, 1.0 - 0.03 * (most - held) / max(saturation, 1e-6));
  return min(held, 1.0) * (1.0 - kept * (1.0 - light / max(most, 1e-30)));
}

// False colour for the number of stops below a full Moon. Two stops share a colour, and the fainter one is darker.
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
  // limb pixels are blended after the view is applied, so that an overexposed limb is not jagged
  colour = vec4(srgb(mix(beside, linear(shown(seen)), cover)) + noise(gl_FragCoord.xy) / 255.0, 1.0);
}
#endif
