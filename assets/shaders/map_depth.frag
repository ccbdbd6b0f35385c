// SPDX-License-Identifier: GPL-3.0-or-later
// The shadow map as a picture: near is light, far is dark, stretched over the depths in use; hatched where no caster is.
in vec2 v_map;
uniform sampler2DArray u_map;
uniform vec2 u_depth_range;
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

// Texel and layer.
ivec3 texel_at(vec2 at) {
  vec2 sheet = clamp(at, vec2(0.0), vec2(0.999999)) * u_tiles;
  ivec2 tile = ivec2(sheet);
  int side = textureSize(u_map, 0).x;
  return ivec3(min(ivec2(fract(sheet) * float(side)), ivec2(side - 1)), (int(u_tiles.y) - 1 - tile.y) * int(u_tiles.x) + tile.x);
}

// Depth over the range in use.
float stretched(float depth) { return (depth - u_depth_range.x) / max(u_depth_range.y - u_depth_range.x, 1e-7); }

vec3 texel_color(vec2 at, vec3 empty) {
  if (u_empty) return empty;
  float depth = texelFetch(u_map, texel_at(at), 0).r;
  return depth >= 1.0 ? empty : vec3(mix(kNear, kFar, clamp(stretched(depth), 0.0, 1.0)));
}

// How much the surroundings are farther than a texel: 0 on a plane, large along the edge of a caster. Without it, a caster close to
// its receiver is hardly seen beside the receiver's own range of depths.
float relief(vec2 at) {
  if (u_empty) return 0.0;
  ivec3 texel = texel_at(at);
  float here = texelFetch(u_map, texel, 0).r;
  if (here >= 1.0) return 0.0;
  int last = textureSize(u_map, 0).x - 1;
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 by = (i % 2 == 0 ? ivec2(3, 0) : ivec2(0, 3)) * (i < 2 ? 1 : -1);
    if (any(lessThan(texel.xy + by, ivec2(0))) || any(greaterThan(texel.xy + by, ivec2(last)))) return 0.0;
    float there = texelFetch(u_map, texel + ivec3(by, 0), 0).r;
    if (there >= 1.0) return 0.0;
    sum += stretched(there) - stretched(here);
  }
  return sum / 4.0;
}

void main() {
  vec2 right = dFdx(v_map), up = dFdy(v_map);
  vec3 empty = empty_color();
  vec3 sum = vec3(0.0);
  // 3 x 3 samples a pixel: texels stay crisp when large, and do not flicker when small.
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) sum += texel_color(v_map + (float(x) * right + float(y) * up) / 3.0, empty);
  }
  vec3 color = sum / 9.0 + clamp(kRelief * relief(v_map), -0.10, 0.16);
  // A seam between the tiles of a sheet.
  vec2 sheet = v_map * u_tiles;
  vec2 seam = abs(sheet - floor(sheet + 0.5)) / max(vec2(length(vec2(right.x, up.x)), length(vec2(right.y, up.y))) * u_tiles, vec2(1e-9));
  float inside = clamp(min(seam.x, seam.y) / u_scale, 0.0, 1.0);
  o_color = vec4(u_tiles.x > 1.0 ? mix(u_ground, color, inside) : color, 1.0);
}
