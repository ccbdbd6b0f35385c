// SPDX-License-Identifier: GPL-3.0-or-later
// The depth of a picture, as bits.
uniform sampler2D u_depth;
out uvec4 o_bits;

void main() {
  o_bits = uvec4(floatBitsToUint(texelFetch(u_depth, ivec2(gl_FragCoord.xy), 0).r), 0u, 0u, 0u);
}
