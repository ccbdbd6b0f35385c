// SPDX-License-Identifier: GPL-3.0-or-later
// Depth only. MAY_DISCARD: fragments below the cutoff cast no shadow. TEXTURED: as in scene.frag.
#ifdef MAY_DISCARD
in vec2 v_texcoord;
in float v_alpha;
uniform sampler2D u_texture;
uniform vec4 u_base_color;
uniform float u_alpha_cutoff;

void main() {
  float alpha = u_base_color.a * v_alpha;
#ifdef TEXTURED
  alpha *= texture(u_texture, v_texcoord).a;
#endif
  if (alpha < u_alpha_cutoff) discard;
}
#else
void main() {}
#endif
