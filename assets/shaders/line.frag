// SPDX-License-Identifier: GPL-3.0-or-later
// A feathered line: the distance from the pixel's centre to the segment, in pixels, decides its coverage.
// OVER_SCENE: what the scene hides is thinner, dashed and fainter; see overlay_depth.glsl.
in vec4 v_place;       // along the segment from a, aside of it; along it from a place that all its pieces share; its length; pixels
flat in vec4 v_color;  // opacity at a
flat in vec4 v_shape;  // width, opacity at b, dash + gap, taper
out vec4 o_color;

#ifdef OVER_SCENE
uniform vec3 u_hidden;  // width and opacity over a line's own, dash + gap
#endif

const float kDashShare = 0.6;

float dash_coverage(float period) {
  float from_middle = abs(fract(v_place.z / period) - 0.5) * period;
  return period > 0.0 ? clamp(0.5 * kDashShare * period - from_middle + 0.5, 0.0, 1.0) : 1.0;
}

void main() {
  float t = v_place.x, aside = abs(v_place.y), len = v_place.w;
  bool is_head = v_shape.w > 0.0;  // v_shape.x is half its base, and b its tip
  float width = v_shape.x, opacity = mix(v_color.a, v_shape.y, clamp(t / max(len, 1e-6), 0.0, 1.0)), period = v_shape.z;
#ifdef OVER_SCENE
  if (gl_FragCoord.z > overlay_depth()) {
    opacity *= u_hidden.y;
    if (!is_head) width *= u_hidden.x, period = u_hidden.z;
  }
#endif
  float sides, ends;
  if (is_head) {
    float slope = width / max(len, 1e-6);
    sides = ((len - t) * slope - aside) * inversesqrt(1.0 + slope * slope) + 0.5;
    ends = t + 0.5;
  } else {
    // Never below one pixel: thinner lines fade instead.
    float half_width = 0.5 * max(width, 1.0);
    opacity *= min(width, 1.0);
    sides = half_width + 0.5 - aside;
    // Ends reach half the width further, as far as a quarter pixel, so that edges of a body meet in its corners.
    float extra = period > 0.0 ? 0.0 : 0.5 * half_width;
    ends = min(t, len - t) + extra + 0.5;
  }
  float coverage = clamp(sides, 0.0, 1.0) * clamp(ends, 0.0, 1.0) * dash_coverage(period);
  o_color = vec4(v_color.rgb, opacity * coverage);
}
