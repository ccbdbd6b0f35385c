// SPDX-License-Identifier: GPL-3.0-or-later
// A feathered line: the distance from the pixel's centre to the segment, in pixels, decides its coverage.
flat in vec4 v_segment;  // a.xy, b.xy
flat in vec4 v_color;    // opacity at a
flat in vec4 v_shape;    // half width, opacity at b, dash + gap, taper
out vec4 o_color;

const float kDashShare = 0.6;

// Measured along the line from a place that does not depend on where it was clipped, so that pieces of one line dash as one.
float dash_coverage(vec2 along) {
  float period = v_shape.z;
  if (period <= 0.0) return 1.0;
  vec2 upright = along.x < 0.0 || (along.x == 0.0 && along.y < 0.0) ? -along : along;
  float from_middle = abs(fract(dot(gl_FragCoord.xy, upright) / period) - 0.5) * period;
  return clamp(0.5 * kDashShare * period - from_middle + 0.5, 0.0, 1.0);
}

void main() {
  vec2 a = v_segment.xy, b = v_segment.zw;
  float len = length(b - a);
  vec2 along = len > 0.0 ? (b - a) / len : vec2(1.0, 0.0);
  vec2 from_a = gl_FragCoord.xy - a;
  float t = dot(from_a, along);
  float aside = abs(dot(from_a, vec2(-along.y, along.x)));

  float sides, ends;
  if (v_shape.w > 0.0) {  // an arrow head: half as wide as v_shape.x at its base, a point at b
    float slope = v_shape.x / max(len, 1e-6);
    sides = ((len - t) * slope - aside) * inversesqrt(1.0 + slope * slope) + 0.5;
    ends = t + 0.5;
  } else {
    sides = v_shape.x + 0.5 - aside;
    // Ends reach half the width further, as far as a quarter pixel, so that edges of a body meet in its corners.
    float extra = v_shape.z > 0.0 ? 0.0 : 0.5 * v_shape.x;
    ends = min(t, len - t) + extra + 0.5;
  }
  float coverage = clamp(sides, 0.0, 1.0) * clamp(ends, 0.0, 1.0) * dash_coverage(along);
  float opacity = mix(v_color.a, v_shape.y, clamp(t / max(len, 1e-6), 0.0, 1.0));
  if (coverage * opacity <= 0.0) discard;
  o_color = vec4(v_color.rgb, opacity * coverage);
}
