// SPDX-License-Identifier: GPL-3.0-or-later
// Depth only; fragments below the cutoff cast no shadow.
in vec2 v_texcoord;
in float v_alpha;
uniform sampler2D u_texture;
uniform bool u_textured;
uniform vec4 u_base_color;
uniform float u_alpha_cutoff;

void main() {
  float alpha = u_base_color.a * v_alpha;
  if (u_textured && u_alpha_cutoff > 0.0) alpha *= texture(u_texture, v_texcoord).a;
  if (alpha < u_alpha_cutoff) discard;
}
