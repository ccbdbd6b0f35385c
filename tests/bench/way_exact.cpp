// SPDX-License-Identifier: GPL-3.0-or-later
#include "ways.h"

namespace psm {

WayBody way_exact(const BodyCase& c) {
  const ConvexBody body = caster_body_of(planes_of(c));
  WayBody out;
  out.vertices = body.vertices;
  for (const auto& f : body.facets) out.facet_sizes.push_back(int(f.size()));
  if (body.dimension == 2) out.facet_sizes.pop_back();
  out.volume = body.volume();
  return out;
}

}  // namespace psm
