// SPDX-License-Identifier: GPL-3.0-or-later
// The shadow map as a picture: near is light, far is dark, stretched over the depths in use; hatched where no caster is.
in vec2 v_map;
flat in vec2 v_depth_range;
uniform sampler2DArray u_map;
uniform vec2 u_tiles;  // columns and rows of the sheet
uniform bool u_empty;  // no map was drawn
uniform vec3 u_ground;
uniform float u_scale;
out vec4 o_color;

const float kNear = 0.86, kFar = 0.22;  // sRGB greys
const float kRelief = 3.0;

vec3 empty_color() {
  float dark = step(u_ground.r, 0.5);
  float stripe = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / (9.0 * u_scale)) - 0.5) * 9.0 * u_scale;  // pixels along x
  float line = clamp(1.2 * u_scale - stripe, 0.0, 1.0);
  vec3 paper = mix(vec3(0.955, 0.965, 0.985), vec3(0.10, 0.11, 0.14), dark);
  vec3 ink = mix(vec3(0.80, 0.85, 0.92), vec3(0.20, 0.23, 0.29), dark);
  return mix(paper, ink, line);
}

// Depth over the range in use.
float stretched(float depth) { return (depth - v_depth_range.x) / max(v_depth_range.y - v_depth_range.x, 1e-7); }

float depth_at(vec2 texel, int layer) {
  int last = textureSize(u_map, 0).x - 1;
  return texelFetch(u_map, ivec3(clamp(ivec2(floor(texel)), ivec2(0), ivec2(last)), layer), 0).r;
}

// How much the surroundings are farther than a texel: 0 on a plane, large along the edge of a caster. Without it, a caster close to
// its receiver is hardly seen beside the receiver's own range of depths.
float relief(vec2 texel, int layer, float here) {
  float side = float(textureSize(u_map, 0).x);
  if (any(lessThan(texel, vec2(3.0))) || any(greaterThan(texel, vec2(side - 3.0)))) return 0.0;
  vec4 there = vec4(depth_at(texel + vec2(3.0, 0.0), layer), depth_at(texel - vec2(3.0, 0.0), layer),
                    depth_at(texel + vec2(0.0, 3.0), layer), depth_at(texel - vec2(0.0, 3.0), layer));
  if (max(max(here, max(there.x, there.y)), max(there.z, there.w)) >= 1.0) return 0.0;
  return stretched(dot(there, vec4(0.25))) - stretched(here);
}

// The map's colour: 3 x 3 samples a pixel, so that texels stay crisp when large, and do not flicker when small.
vec3 map_color(vec2 right, vec2 up, vec3 empty) {
  vec2 sheet = clamp(v_map, vec2(0.0), vec2(0.999999)) * u_tiles, tile = floor(sheet);
  float side = float(textureSize(u_map, 0).x);
  int layer = (int(u_tiles.y) - 1 - int(tile.y)) * int(u_tiles.x) + int(tile.x);
  vec2 texel = (sheet - tile) * side, step_right = right * u_tiles * side / 3.0, step_up = up * u_tiles * side / 3.0;
  float here = depth_at(texel, layer), sum = 0.0, casters = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      float depth = depth_at(texel + float(x) * step_right + float(y) * step_up, layer);
      float is_caster = depth < 1.0 ? 1.0 : 0.0;
      sum += is_caster * depth;
      casters += is_caster;
    }
  }
  float grey = mix(kNear, kFar, clamp(stretched(sum / max(casters, 1.0)), 0.0, 1.0));
  return mix(empty, vec3(grey), casters / 9.0) + clamp(kRelief * relief(texel, layer, here), -0.10, 0.16);
}

void main() {
  vec2 right = dFdx(v_map), up = dFdy(v_map);
  vec3 empty = empty_color();
  vec3 color = u_empty ? empty : map_color(right, up, empty);
  // A seam between the tiles of a sheet.
  vec2 sheet = v_map * u_tiles;
  vec2 seam = abs(sheet - floor(sheet + 0.5)) / max(vec2(length(vec2(right.x, up.x)), length(vec2(right.y, up.y))) * u_tiles, vec2(1e-9));
  float inside = clamp(min(seam.x, seam.y) / u_scale, 0.0, 1.0);
  o_color = vec4(u_tiles.x > 1.0 ? mix(u_ground, color, inside) : color, 1.0);
}
