// SPDX-License-Identifier: GPL-3.0-or-later
// A rounded box (a disc where the radius is half its side) with an outline on its inner side.
// OVER_SCENE: what the scene hides is fainter; see overlay_depth.glsl.
flat in vec4 v_box;  // centre, half size
flat in vec4 v_fill;
flat in vec4 v_outline;
flat in vec2 v_shape;  // corner radius, outline width
out vec4 o_color;

#ifdef OVER_SCENE
uniform float u_hidden;  // opacity over its own
#endif

void main() {
  float opacity = 1.0;
#ifdef OVER_SCENE
  if (gl_FragCoord.z > overlay_depth()) opacity = u_hidden;
#endif
  vec2 beyond = abs(gl_FragCoord.xy - v_box.xy) - v_box.zw + v_shape.x;
  float outside = length(max(beyond, vec2(0.0))) + min(max(beyond.x, beyond.y), 0.0) - v_shape.x;
  float coverage = clamp(0.5 - outside, 0.0, 1.0);
  float rim = clamp(outside + v_shape.y + 0.5, 0.0, 1.0) * v_outline.a * opacity;
  float fill = v_fill.a * opacity, alpha = rim + fill * (1.0 - rim);  // the outline over the fill
  vec3 color = (v_outline.rgb * rim + v_fill.rgb * fill * (1.0 - rim)) / max(alpha, 1e-6);
  o_color = vec4(color, alpha * coverage);
}
