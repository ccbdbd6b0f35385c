// SPDX-License-Identifier: GPL-3.0-or-later
// The depth of a picture, as bits.
out uvec4 o_bits;

void main() { o_bits = uvec4(floatBitsToUint(overlay_depth()), 0u, 0u, 0u); }
