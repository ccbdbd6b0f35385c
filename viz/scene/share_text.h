// SPDX-License-Identifier: GPL-3.0-or-later
// An experiment as one line to paste into a mail, a chat or psmlab: "psmlab:SOURCE?PATH=VALUE&PATH=VALUE". Values as --set takes
// them; members that are as the scene brings them are left out; what is not plain in a link is escaped as %XX.
#pragma once

#include <string>

#include "scene/experiment_members.h"
#include "scene/scene.h"

namespace psm {

/// `scene` is the experiment's own.
std::string share_text(const Experiment& experiment, const Scene& scene);

/// Whether it begins as one, after blanks.
bool is_share_text(const std::string& text);

/// The scene's source and the members of a share text. Errors start at the member.
Result<ExperimentMembers> members_from_share_text(const std::string& text);

/// "PATH=VALUE&PATH=VALUE", each at most once; none where the text is empty.
Result<ExperimentMembers> members_from_pairs(const std::string& pairs);

}  // namespace psm
