// SPDX-License-Identifier: GPL-3.0-or-later
// What moves by itself for a moment: the camera shift (key A), the cube view on its way to the world and back (key W), and what
// a lesson reveals. Times are in seconds.
#pragma once

#include "ui/model.h"
#include "ui/number_play.h"

namespace psm {

class Movements {
 public:
  explicit Movements(Model& model) : model_(model) {}

  bool any() const { return shift_ || cube_ || reveal_; }
  bool reveals() const { return reveal_.has_value(); }

  /// The camera shift from 0 to what its rule makes it; else why it stays. `still`: it is there at once.
  std::optional<std::string> play_camera_shift(double now, bool still);
  /// The cube view to the farther of the two, the world and the cube. `still`: as above.
  void play_world_to_cube(double now, bool still);
  /// The whole experiment to this one, undone as one step.
  void play_reveal(const Experiment& to, double now);
  /// At once at its end; whether there was one.
  bool finish_reveal(double now);

  /// Moves on; returns the history's name for it, empty if nothing moved. Whatever the user has taken over is over.
  std::string move(Experiment& edited, double now);

 private:
  struct Reveal {
    double start;
    Experiment from, to;
    Experiment last;  // what it set last
  };
  std::optional<NumberPlay> start(const char* path, double from, double to, double seconds, double now, bool still);
  bool move_reveal(Experiment& edited, double now);

  Model& model_;
  std::optional<NumberPlay> shift_, cube_;
  std::optional<Reveal> reveal_;
  ShiftRule played_rule_ = ShiftRule::automatic;
};

}  // namespace psm
