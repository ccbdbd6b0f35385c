// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/experiment_names.h"

#include <algorithm>

namespace psm {
namespace {

template <class Enum, std::size_t N>
std::optional<Enum> from_name(const std::array<const char*, N>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt : std::optional<Enum>(Enum(found - names.begin()));
}

}  // namespace

const char* name_of(LightType type) { return kLightTypes[std::size_t(type)]; }
const char* name_of(Technique technique) { return kTechniques[std::size_t(technique)]; }
const char* name_of(EyeOverlay overlay) { return kEyeOverlays[std::size_t(overlay)]; }
const char* name_of(Cull cull) { return kCulls[std::size_t(cull)]; }
const char* name_of(Filter filter) { return kFilters[std::size_t(filter)]; }
const char* name_of(ViewId id) { return kViews[std::size_t(id)]; }

const char* name_of(ShiftRule rule) { return kShiftRules[std::size_t(rule)]; }

std::optional<ShiftRule> shift_rule_from_name(const std::string& name) { return from_name<ShiftRule>(kShiftRules, name); }
std::optional<ViewId> view_from_name(const std::string& name) { return from_name<ViewId>(kViews, name); }
std::optional<Technique> technique_from_name(const std::string& name) { return from_name<Technique>(kTechniques, name); }

std::vector<std::string> technique_names() { return {kTechniques.begin(), kTechniques.end()}; }

}  // namespace psm
