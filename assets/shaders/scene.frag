// SPDX-License-Identifier: GPL-3.0-or-later
// With MAY_DISCARD: cutoff textures and the cube view's limit; without, cards test depth before they shade. TEXTURED, COLORED: the
// surface has a texture, colours at its vertices.
// VERDICT: what the map says, as a number from 0 to 255 in red (MapVerdict: 1 dark, 2 lit, 3 outside the map); the lit fraction in green.
// MAPS: how many shadow maps there are; not defined without any. SUN: the light is a direction. LOOKUP: with filters, and with points
// that are shifted before they are looked up.
// Hemisphere light from above and one light with shadows. No fall-off with distance: shadows have to be read, not admired.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_texcoord;
in vec4 v_color;

uniform sampler2D u_texture;
uniform vec4 u_base_color;
uniform float u_alpha_cutoff;
uniform bool u_has_surface;  // false for lines and points: they have no side that could face the light

uniform vec4 u_light;         // homogeneous, towards the light, local space; a direction is of unit length
uniform vec3 u_spot_axis;     // into the scene, unit
uniform vec2 u_spot_cosines;  // of the edge and of where it starts to soften; (-2, -2): no cone

#ifdef MAPS
uniform sampler2DArrayShadow u_map;
in vec4 v_in_map[MAPS];                 // the point's place in each map, homogeneous
vec4 g_along_x[MAPS], g_along_y[MAPS];  // its change from pixel to pixel, which is along the surface
uniform float u_receiver_bias;          // 1, or less where the caster's bias is below one texel: without bias, acne is to be seen
#endif

uniform mat4 u_cube_from_local;
uniform float u_cube_limit;  // 0: no limit
uniform vec4 u_ground;       // what it fades to, sRGB

out vec4 o_color;

bool g_outside_map = false;  // the shadow test found no map that holds the point

// Chosen so that a near-white floor (0.85) is #E8E8E8 in the light and #808080 in shadow, 3.2 to 1.
const vec3 kSkyLight = vec3(0.250, 0.255, 0.262);
const vec3 kGroundLight = vec3(0.150, 0.150, 0.148);
const vec3 kLight = vec3(0.700, 0.695, 0.688);

vec3 direction_to_light() {
#ifdef SUN
  return u_light.xyz;
#else
  vec3 to_light = u_light.xyz - u_light.w * v_position;
  return to_light / max(length(to_light), 1e-20);
#endif
}

#ifdef MAPS
// How the depth of the surface's plane changes over the map, in map coordinates from 0 to 1; 0 where it is seen from its edge.
vec2 depth_slope(int i) {
  vec4 q = v_in_map[i], x = g_along_x[i], y = g_along_y[i];
  vec3 device = q.xyz / q.w;
  vec3 dx = x.xyz - device * x.w, dy = y.xyz - device * y.w;  // times q.w, which cancels
  float area = dx.x * dy.y - dx.y * dy.x;
  if (abs(area) <= 1e-5 * sqrt(dot(dx.xy, dx.xy) * dot(dy.xy, dy.xy))) return vec2(0.0);
  return vec2(dx.z * dy.y - dy.z * dx.y, dy.z * dx.x - dx.z * dy.x) / area;
}

#ifdef LOOKUP
uniform mat4 u_map_from_local[MAPS];
uniform float u_constant_bias, u_normal_bias;  // texels
uniform int u_kernel;                          // texels across; 0: the hardware's weighted four

vec3 row_of(mat4 m, int i) { return vec3(m[0][i], m[1][i], m[2][i]); }

// A texel's size in space, across the light: the columns of the Jacobian's pseudo-inverse.
float texel_size(mat4 map, vec4 q) {
  vec3 du = (row_of(map, 0) - q.x / q.w * row_of(map, 3)) / q.w, dv = (row_of(map, 1) - q.y / q.w * row_of(map, 3)) / q.w;
  vec3 ray = cross(du, dv);
  return 2.0 / float(textureSize(u_map, 0).x) * max(length(cross(dv, ray)), length(cross(ray, du))) / max(dot(ray, ray), 1e-30);
}

// The height over the surface's plane at which a point is nearer to the light by what the plane's depth changes over these texels.
// Over the plane, depth grows with the height h as h / (1 + h g), g being how w grows along the normal.
float height_of(float texels, mat4 map, vec4 q, vec3 normal, vec2 slope) {
  vec4 up = map * vec4(normal, 0.0);
  vec3 rate = (up.xyz - q.xyz / q.w * up.w) / q.w;
  float rise = abs(rate.z - dot(slope, rate.xy)), change = 2.0 / float(textureSize(u_map, 0).x) * (abs(slope.x) + abs(slope.y));
  float height = texels * change / max(rise, 1e-30);
  return height / max(1.0 - height * up.w / q.w, 0.1);
}

// Where the point is looked up: shifted towards the light, and along the normal.
vec3 lookup_place(mat4 map, vec4 q, vec3 normal, vec2 slope) {
  return v_position + u_constant_bias * texel_size(map, q) * direction_to_light() + height_of(u_normal_bias, map, q, normal, slope) * normal;
}

// Each comparison is with the depth of the surface's own plane at that texel's centre.
float compare(vec3 at, vec2 slope, float layer) {
  float side = float(textureSize(u_map, 0).x);
  slope *= u_receiver_bias / side;
  if (u_kernel == 0) {
    vec2 from_first = at.xy * side - 0.5 - floor(at.xy * side - 0.5);  // of the four texels' centres
    float least = min(-slope.x * from_first.x, slope.x * (1.0 - from_first.x)) +
                  min(-slope.y * from_first.y, slope.y * (1.0 - from_first.y));
    return texture(u_map, vec4(at.xy, layer, clamp(at.z + least, 0.0, 1.0)));
  }
  vec2 to_centre = floor(at.xy * side) + 0.5 - at.xy * side;
  float lit = 0.0, own = at.z + min(dot(slope, to_centre), 0.0);
  int reach = u_kernel / 2;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      vec2 place = clamp(at.xy + vec2(x, y) / side, 0.5 / side, 1.0 - 0.5 / side);  // the kernel ends where the map does
      lit += texture(u_map, vec4(place, layer, clamp(own + dot(slope, (place - at.xy) * side), 0.0, 1.0)));
    }
  }
  return lit / float(u_kernel * u_kernel);
}

float lit_by(int i, vec3 normal) {
  mat4 map = u_map_from_local[i];
  vec4 q = v_in_map[i];
  vec2 slope = depth_slope(i);
  vec4 shifted = map * vec4(lookup_place(map, q, normal, slope), 1.0);
  if (shifted.w <= 0.0) return 1.0;  // shifted past the light
  vec3 at = 0.5 * shifted.xyz / shifted.w + 0.5;
  return compare(at, at.z <= 1.0 ? slope : vec2(0.0), float(i));
}
#else
// The texel's depth was taken at its centre: the reference comes nearer (or stays) by as much as the surface's plane does there.
// Without it, curved surfaces shadow themselves where the light grazes them, since a caster's bias knows only its own triangle's slope.
float lit_by(int i, vec3 normal) {
  vec3 at = 0.5 * v_in_map[i].xyz / v_in_map[i].w + 0.5;
  float side = float(textureSize(u_map, 0).x);
  vec2 texels = at.xy * side, to_centre = (floor(texels) + 0.5 - texels) / side;
  // Beyond the map's far end: anything in it is nearer to the light, and no surface can shadow itself.
  if (at.z <= 1.0) at.z += min(dot(depth_slope(i), to_centre), 0.0) * u_receiver_bias;
  return texture(u_map, vec4(at.xy, float(i), clamp(at.z, 0.0, 1.0)));
}
#endif

// What one map says: 1 where it does not hold the point.
float lit_in(int i, vec3 normal) {
  vec4 q = v_in_map[i];
  // A little wider than the map, so that nothing falls between two of six.
  if (!(q.w > 0.0 && max(abs(q.x), abs(q.y)) <= 1.00001 * q.w)) return 1.0;
  g_outside_map = false;
  return lit_by(i, normal);
}

// Lit if all maps that hold the point say so: one map, the one of six that looks its way, or the two of psm_two_maps, of which the
// second lies wholly between the light and every receiver.
float shadow_test(vec3 normal) {
  float lit = 1.0;
  g_outside_map = true;
  for (int i = 0; i < MAPS; ++i) lit = min(lit, lit_in(i, normal));
  return lit;
}
#else
float shadow_test(vec3 normal) { return 1.0; }  // nothing casts a shadow: that is an answer, too
#endif

float direct_light(vec3 normal) {
  vec3 to_light = direction_to_light();
  float cosine = u_has_surface ? dot(normal, to_light) : 1.0, cone = 1.0;
#ifndef SUN
  if (u_spot_cosines.x >= -1.0) cone = smoothstep(u_spot_cosines.x, u_spot_cosines.y, dot(-to_light, u_spot_axis));
#endif
  if (cosine <= 0.0 || cone <= 0.0) return 0.0;
  // The square root keeps raking light bright enough for its shadows to be seen; where it only grazes, the map has nothing to say.
  return sqrt(cosine) * smoothstep(0.0, 0.1, cosine) * cone * shadow_test(normal);
}

// sRGB from linear light. Roots instead of the power, which software renderers compute slowly: within 0.1 / 255 of it, fitted for
// the smallest largest error over [0.0031308, 1].
vec3 encode(vec3 linear) {
  vec3 root = sqrt(linear);
  vec3 curved = 0.83472974 * root + 0.29728847 * sqrt(root) - 0.05565831 * linear - 0.07672651;
  return mix(curved, 12.92 * linear, vec3(lessThan(linear, vec3(0.0031308))));
}

// How far the point is on its way to the limit: 0 inside, 1 at the limit and beyond.
float distance_fade() {
  vec4 cube = u_cube_from_local * vec4(v_position, 1.0);
  float reach = max(max(abs(cube.x), abs(cube.y)), abs(cube.z));
  return smoothstep(0.75, 1.0, reach / max(abs(cube.w) * u_cube_limit, 1e-20));
}

void main() {
  vec4 albedo = u_base_color;
#ifdef COLORED
  albedo *= v_color;
#endif
#ifdef TEXTURED
  albedo *= texture(u_texture, v_texcoord);
#endif
  float fade = 0.0;
#ifdef MAY_DISCARD
  if (albedo.a < u_alpha_cutoff) discard;
  fade = u_cube_limit > 0.0 ? distance_fade() : 0.0;
  if (fade >= 1.0) discard;
#endif

#ifdef MAPS
  for (int i = 0; i < MAPS; ++i) {
    g_along_x[i] = u_has_surface ? dFdx(v_in_map[i]) : vec4(0.0);
    g_along_y[i] = u_has_surface ? dFdy(v_in_map[i]) : vec4(0.0);
  }
#endif
  vec3 normal = v_normal / max(length(v_normal), 1e-20) * (gl_FrontFacing ? 1.0 : -1.0);
#ifdef VERDICT
  float lit = shadow_test(normal);
  o_color = vec4((g_outside_map ? 3.0 : lit >= 0.5 ? 2.0 : 1.0) / 255.0, lit, 0.0, 1.0);
#else
  vec3 ambient = mix(kGroundLight, kSkyLight, u_has_surface ? 0.5 + 0.5 * normal.y : 1.0);
  vec3 color = encode(clamp(albedo.rgb * (ambient + kLight * direct_light(normal)), 0.0, 1.0));
  o_color = mix(vec4(color, 1.0), u_ground, fade);
#endif
}
