// SPDX-License-Identifier: GPL-3.0-or-later
// The depths of layer 0, as bits: ES 3.0 reads neither depth nor float textures back.
uniform sampler2DArray u_map;
out uvec4 o_bits;

void main() { o_bits = uvec4(floatBitsToUint(texelFetch(u_map, ivec3(gl_FragCoord.xy, 0), 0).r)); }
