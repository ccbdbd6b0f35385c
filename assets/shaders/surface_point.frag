// SPDX-License-Identifier: GPL-3.0-or-later
// What the eye's ray through the pixel's middle meets: the place and the triangle's own normal, local space, as the bits of
// floats: a framebuffer of unsigned integers is the one with 32 bits that OpenGL ES 3.0 promises. MAY_DISCARD, TEXTURED, COLORED: as
// in scene.frag.
in vec3 v_position;
in vec2 v_texcoord;
in vec4 v_color;

uniform sampler2D u_texture;
uniform vec4 u_base_color;
uniform float u_alpha_cutoff;

layout(location = 0) out uvec4 o_position;
layout(location = 1) out uvec4 o_normal;

void main() {
  vec3 normal = cross(dFdx(v_position), dFdy(v_position));
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
  o_position = uvec4(floatBitsToUint(v_position), 1u);
  o_normal = uvec4(floatBitsToUint(normal), 1u);
}
