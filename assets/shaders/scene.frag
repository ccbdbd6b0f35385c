// SPDX-License-Identifier: GPL-3.0-or-later
// Hemisphere light from above and one light with shadows. No fall-off with distance: shadows have to be read, not admired.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_texcoord;
in vec4 v_color;

uniform sampler2D u_texture;
uniform bool u_textured;
uniform vec4 u_base_color;
uniform float u_alpha_cutoff;
uniform bool u_has_surface;  // false for lines and points: they have no side that could face the light

uniform vec4 u_light;         // homogeneous, towards the light, local space
uniform vec3 u_spot_axis;     // into the scene, unit
uniform vec2 u_spot_cosines;  // of the edge and of where it starts to soften; (-2, -2): no cone

uniform sampler2DArrayShadow u_map;
uniform mat4 u_map_from_local[6];
uniform int u_map_count;

uniform mat4 u_cube_from_local;
uniform float u_cube_limit;  // 0: no limit
uniform vec3 u_ground;       // what it fades to, sRGB

out vec4 o_color;

// Chosen so that a near-white floor (0.85) is #E8E8E8 in the light and #808080 in shadow, 3.2 to 1.
const vec3 kSkyLight = vec3(0.250, 0.255, 0.262);
const vec3 kGroundLight = vec3(0.150, 0.150, 0.148);
const vec3 kLight = vec3(0.700, 0.695, 0.688);

float shadow_test(vec3 position) {
  for (int i = 0; i < u_map_count; ++i) {
    vec4 q = u_map_from_local[i] * vec4(position, 1.0);
    // A little wider than the map, so that nothing falls between two of six.
    if (q.w > 0.0 && max(abs(q.x), abs(q.y)) <= 1.00001 * q.w) {
      vec3 at = 0.5 * q.xyz / q.w + 0.5;
      return texture(u_map, vec4(at.xy, float(i), clamp(at.z, 0.0, 1.0)));
    }
  }
  return 1.0;
}

float direct_light(vec3 normal) {
  vec3 to_light = u_light.xyz - u_light.w * v_position;
  to_light /= max(length(to_light), 1e-20);
  float cosine = u_has_surface ? dot(normal, to_light) : 1.0;
  float cone = u_spot_cosines.x < -1.0 ? 1.0 : smoothstep(u_spot_cosines.x, u_spot_cosines.y, dot(-to_light, u_spot_axis));
  if (cosine <= 0.0 || cone <= 0.0) return 0.0;
  // The square root keeps raking light bright enough for its shadows to be seen.
  return sqrt(cosine) * cone * shadow_test(v_position);
}

vec3 encode(vec3 linear) {
  return mix(1.055 * pow(max(linear, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055, 12.92 * linear, vec3(lessThan(linear, vec3(0.0031308))));
}

// How far the point is on its way to the limit: 0 inside, 1 at the limit and beyond.
float distance_fade() {
  vec4 cube = u_cube_from_local * vec4(v_position, 1.0);
  float reach = max(max(abs(cube.x), abs(cube.y)), abs(cube.z));
  return smoothstep(0.75, 1.0, reach / max(abs(cube.w) * u_cube_limit, 1e-20));
}

void main() {
  vec4 albedo = u_base_color * v_color;
  if (u_textured) albedo *= texture(u_texture, v_texcoord);
  if (albedo.a < u_alpha_cutoff) discard;
  float fade = u_cube_limit > 0.0 ? distance_fade() : 0.0;
  if (fade >= 1.0) discard;

  vec3 normal = v_normal / max(length(v_normal), 1e-20) * (gl_FrontFacing ? 1.0 : -1.0);
  vec3 ambient = mix(kGroundLight, kSkyLight, u_has_surface ? 0.5 + 0.5 * normal.y : 1.0);
  vec3 color = encode(clamp(albedo.rgb * (ambient + kLight * direct_light(normal)), 0.0, 1.0));
  o_color = vec4(mix(color, u_ground, fade), 1.0);
}
