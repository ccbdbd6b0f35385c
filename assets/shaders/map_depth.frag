// SPDX-License-Identifier: GPL-3.0-or-later
// The shadow map as a picture: near is light, far is dark, stretched over the depths in use; hatched where no caster is.
in vec2 v_map;
uniform sampler2DArray u_map;
uniform vec2 u_depth_range;
uniform vec2 u_tiles;  // columns and rows of the sheet
uniform vec3 u_ground;
uniform float u_scale;
out vec4 o_color;

const float kNear = 0.86, kFar = 0.22;  // sRGB greys

vec3 empty_color() {
  float dark = step(u_ground.r, 0.5);
  float stripe = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / (9.0 * u_scale)) - 0.5) * 9.0 * u_scale;  // pixels along x
  float line = clamp(1.2 * u_scale - stripe, 0.0, 1.0);
  vec3 paper = mix(vec3(0.955, 0.965, 0.985), vec3(0.10, 0.11, 0.14), dark);
  vec3 ink = mix(vec3(0.80, 0.85, 0.92), vec3(0.20, 0.23, 0.29), dark);
  return mix(paper, ink, line);
}

vec3 texel_color(vec2 at, vec3 empty) {
  vec2 sheet = clamp(at, vec2(0.0), vec2(0.999999)) * u_tiles;
  ivec2 tile = ivec2(sheet);
  int layer = (int(u_tiles.y) - 1 - tile.y) * int(u_tiles.x) + tile.x;
  int side = textureSize(u_map, 0).x;
  ivec2 texel = min(ivec2(fract(sheet) * float(side)), ivec2(side - 1));
  float depth = texelFetch(u_map, ivec3(texel, layer), 0).r;
  if (depth >= 1.0) return empty;
  float t = (depth - u_depth_range.x) / max(u_depth_range.y - u_depth_range.x, 1e-7);
  return vec3(mix(kNear, kFar, clamp(t, 0.0, 1.0)));
}

void main() {
  vec2 right = dFdx(v_map), up = dFdy(v_map);
  vec3 empty = empty_color();
  vec3 sum = vec3(0.0);
  // 3 x 3 samples a pixel: texels stay crisp when large, and do not flicker when small.
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) sum += texel_color(v_map + (float(x) * right + float(y) * up) / 3.0, empty);
  }
  vec3 color = sum / 9.0;
  // A seam between the tiles of a sheet.
  vec2 sheet = v_map * u_tiles;
  vec2 seam = abs(sheet - floor(sheet + 0.5)) / max(vec2(length(vec2(right.x, up.x)), length(vec2(right.y, up.y))) * u_tiles, vec2(1e-9));
  float inside = clamp(min(seam.x, seam.y) / u_scale, 0.0, 1.0);
  o_color = vec4(u_tiles.x > 1.0 ? mix(u_ground, color, inside) : color, 1.0);
}
