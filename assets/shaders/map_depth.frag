// SPDX-License-Identifier: GPL-3.0-or-later
// The shadow map as a picture: near is light, far is dark, stretched over the depths in use; hatched where no caster is. SHEET: several
// maps beside each other. EMPTY: no map was drawn.
in vec2 v_map;
flat in vec2 v_depth_range;
uniform sampler2DArray u_map;
uniform vec2 u_tiles;  // columns and rows of the sheet
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

float depth_at(vec2 map, float layer) { return texture(u_map, vec3(map, layer)).r; }

// How much the surroundings are farther than a texel: 0 on a plane, large along the edge of a caster. Without it, a caster close to
// its receiver is hardly seen beside the receiver's own range of depths.
float relief(vec2 map, float layer, float here) {
  float reach = 3.0 / float(textureSize(u_map, 0).x);
  if (any(greaterThan(abs(map - 0.5), vec2(0.5 - reach)))) return 0.0;
  vec4 there = vec4(depth_at(map + vec2(reach, 0.0), layer), depth_at(map - vec2(reach, 0.0), layer),
                    depth_at(map + vec2(0.0, reach), layer), depth_at(map - vec2(0.0, reach), layer));
  if (max(max(here, max(there.x, there.y)), max(there.z, there.w)) >= 1.0) return 0.0;
  return stretched(dot(there, vec4(0.25))) - stretched(here);
}

// The map's colour: the pixel's middle and four places around it, so that texels stay crisp when large, and do not flicker when small.
vec3 map_color(vec2 map, float layer, vec2 right, vec2 up) {
  float here = depth_at(map, layer);
  vec2 rising = (right + up) / 3.0, falling = (right - up) / 3.0;
  vec4 around = vec4(depth_at(map + rising, layer), depth_at(map - rising, layer), depth_at(map + falling, layer),
                     depth_at(map - falling, layer));
  vec4 are_casters = vec4(lessThan(around, vec4(1.0)));
  float is_caster = here < 1.0 ? 1.0 : 0.0;
  float casters = is_caster + dot(are_casters, vec4(1.0)), sum = is_caster * here + dot(are_casters, around);
  float grey = mix(kNear, kFar, clamp(stretched(sum / max(casters, 1.0)), 0.0, 1.0));
  return mix(empty_color(), vec3(grey), casters / 5.0) + clamp(kRelief * relief(map, layer, here), -0.10, 0.16);
}

void main() {
#ifdef EMPTY
  o_color = vec4(empty_color(), 1.0);
#else
  vec2 right = dFdx(v_map), up = dFdy(v_map);
#ifdef SHEET
  vec2 sheet = clamp(v_map, vec2(0.0), vec2(0.999999)) * u_tiles, tile = floor(sheet);
  vec3 color = map_color(sheet - tile, (u_tiles.y - 1.0 - tile.y) * u_tiles.x + tile.x, right * u_tiles, up * u_tiles);
  // A seam between the tiles.
  vec2 seam = abs(v_map * u_tiles - floor(v_map * u_tiles + 0.5)) /
              max(vec2(length(vec2(right.x, up.x)), length(vec2(right.y, up.y))) * u_tiles, vec2(1e-9));
  o_color = vec4(mix(u_ground, color, clamp(min(seam.x, seam.y) / u_scale, 0.0, 1.0)), 1.0);
#else
  o_color = vec4(map_color(v_map, 0.0, right, up), 1.0);
#endif
#endif
}
