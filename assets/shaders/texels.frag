// SPDX-License-Identifier: GPL-3.0-or-later
// The map's texels in the picture. As it is: a colour for the largest extent m of a texel in pixels, or for its anisotropy, from the
// analytic Jacobian d(texel)/d(pixel) in the triangle's plane (viz/math/texel_footprint.h has the derivation).
// GRID: every u_step-th line between texels, to be blended over the scene. MAY_DISCARD, TEXTURED, COLORED: as in scene.frag.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_texcoord;
in vec4 v_color;

uniform sampler2D u_texture;
uniform vec4 u_base_color;
uniform float u_alpha_cutoff;
uniform bool u_has_surface;

uniform vec4 u_light;
uniform vec3 u_spot_axis;
uniform vec2 u_spot_cosines;
uniform mat4 u_texel_maps[6];  // what the texels are of, drawn or not
uniform int u_texel_map_count;
uniform float u_resolution;  // texels along a side
uniform float u_scale;
uniform mat4 u_cube_from_local;
uniform float u_cube_limit;

uniform mat4 u_eye_from_local;  // clip space of the eye's image
uniform vec2 u_image_size;      // its pixels
uniform bool u_anisotropy;
uniform vec3 u_bands[8];
uniform int u_band_count;
uniform float u_first_bound, u_marked_from;  // log2
uniform vec3 u_no_texel;

uniform float u_step;
uniform float u_strong;  // every how many of these lines is strong
uniform float u_weak;    // opacity of the others
uniform vec3 u_line_color;

out vec4 o_color;

bool faces_light() {
  vec3 normal = v_normal * (gl_FrontFacing ? 1.0 : -1.0);
  vec3 to_light = u_light.xyz - u_light.w * v_position;
  bool in_cone = u_spot_cosines.x < -1.0 || dot(-to_light, u_spot_axis) > u_spot_cosines.x * length(to_light);
  return u_has_surface && in_cone && dot(normal, to_light) > 0.0;
}

// The one that looks the point's way: the first with the largest w.
mat4 texel_map() {
  int best = 0;
  float most = -1e30;
  for (int i = 0; i < u_texel_map_count; ++i) {
    float w = (u_texel_maps[i] * vec4(v_position, 1.0)).w;
    if (w > most) best = i, most = w;
  }
  return u_texel_maps[best];
}

// d(x/w, y/w) of the point moving along t, in half sizes of the window.
vec2 projected_derivative(mat4 map, vec4 p, vec3 t) {
  vec4 d = map * vec4(t, 0.0);
  return (d.xy - p.xy * (d.w / p.w)) / p.w;
}

#ifdef GRID
// Of lines `spacing` texels apart, a pixel's share; they fade where they would run together.
vec2 line_coverage(vec2 texel, vec2 texels_a_pixel, float spacing, float width) {
  vec2 pixels = spacing / max(texels_a_pixel, vec2(1e-9));
  vec2 aside = abs(fract(texel / spacing - 0.5) - 0.5) * pixels;
  return clamp(0.5 * width + 0.5 - aside, 0.0, 1.0) * smoothstep(4.0 * u_scale, 10.0 * u_scale, pixels);
}

float distance_fade() {
  if (u_cube_limit <= 0.0) return 0.0;
  vec4 cube = u_cube_from_local * vec4(v_position, 1.0);
  float reach = max(max(abs(cube.x), abs(cube.y)), abs(cube.z));
  return smoothstep(0.75, 1.0, reach / max(abs(cube.w) * u_cube_limit, 1e-20));
}

void shade() {
  vec4 q = texel_map() * vec4(v_position, 1.0);
  vec2 texel = (0.5 * q.xy / q.w + 0.5) * u_resolution;
  vec2 right = dFdx(texel), up = dFdy(texel);
  vec2 texels_a_pixel = vec2(length(vec2(right.x, up.x)), length(vec2(right.y, up.y)));
  vec2 weak = u_weak * line_coverage(texel, texels_a_pixel, u_step, u_scale);
  vec2 strong = 0.95 * line_coverage(texel, texels_a_pixel, u_step * u_strong, 2.0 * u_scale);
  float opacity = max(max(weak.x, weak.y), max(strong.x, strong.y)) * (1.0 - distance_fade());
  bool inside = q.w > 0.0 && max(abs(q.x), abs(q.y)) <= q.w;
  o_color = vec4(u_line_color, inside && faces_light() ? opacity : 0.0);
}
#else
// m and the anisotropy: 1 / sigma_min and sigma_max / sigma_min of J.
vec2 footprint() {
  mat4 map = texel_map();
  vec3 along_x = dFdx(v_position), along_y = dFdy(v_position);
  vec4 q = map * vec4(v_position, 1.0), p = u_eye_from_local * vec4(v_position, 1.0);
  vec2 half_map = vec2(0.5 * u_resolution), half_image = 0.5 * u_image_size;
  mat2 texel = mat2(projected_derivative(map, q, along_x) * half_map, projected_derivative(map, q, along_y) * half_map);
  mat2 pixel = mat2(projected_derivative(u_eye_from_local, p, along_x) * half_image,
                    projected_derivative(u_eye_from_local, p, along_y) * half_image);
  // J = texel * pixel^-1; its inverse, pixel * adjugate(texel) / det(texel), has 1 / sigma_min as its largest singular value.
  mat2 a = pixel * mat2(texel[1][1], -texel[0][1], -texel[1][0], texel[0][0]);
  float largest = 0.5 * (length(vec2(a[0][0] + a[1][1], a[1][0] - a[0][1])) + length(vec2(a[0][0] - a[1][1], a[1][0] + a[0][1])));
  float smallest = abs(determinant(a)) / max(largest, 1e-30);
  return vec2(largest / max(abs(determinant(texel)), 1e-30), largest / max(smallest, 1e-30));
}

// Distance to the nearest of diagonal lines, as coverage of lines of this width.
float hatching(float width, float period) {
  float aside = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / period) - 0.5) * period * 0.7071;
  return clamp(0.5 * width + 0.5 - aside, 0.0, 1.0);
}

void shade() {
  vec2 found = footprint();
  float octave = clamp(log2(max(u_anisotropy ? found.y : found.x, 1e-9)), -30.0, 30.0);
  float from_one = abs(octave - u_marked_from) / max(fwidth(octave), 1e-6);  // pixels, to where the hatching begins
  vec3 normal = normalize(v_normal) * (gl_FrontFacing ? 1.0 : -1.0);
  float tone = u_has_surface ? 0.90 + 0.10 * normal.y : 1.0;  // a little, so that shapes are seen
  if (u_texel_map_count == 0 || !faces_light()) {
    o_color = vec4(u_no_texel * tone, 1.0);
    return;
  }
  vec3 color = u_bands[clamp(int(floor(octave - u_first_bound)) + 1, 0, u_band_count - 1)];
  vec3 ink = vec3(dot(color, vec3(0.3, 0.6, 0.1)) > 0.4 ? 0.0 : 1.0);
  float mark = octave > u_marked_from ? 0.38 * hatching(1.2 * u_scale, 7.0 * u_scale) : 0.0;
  mark = max(mark, 0.85 * clamp(1.0 * u_scale + 0.5 - from_one, 0.0, 1.0));
  o_color = vec4(mix(color * tone, ink, mark), 1.0);
}
#endif

void main() {
#ifdef MAY_DISCARD
  float alpha = u_base_color.a;
#ifdef COLORED
  alpha *= v_color.a;
#endif
#ifdef TEXTURED
  alpha *= texture(u_texture, v_texcoord).a;
#endif
  if (alpha < u_alpha_cutoff) discard;
#endif
  shade();
}
