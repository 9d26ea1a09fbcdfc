// G12.1 and G7.1 in the preparation: the face or the side of a turned workpiece as a plane.
//
// While one of them is on, the path in W is one in mm over that plane, with the rotary axis in
// the place of one coordinate: on the face the word is in mm already, on the cylinder it is
// in deg and becomes the developed length. The scheme is made from the active one; a work offset of
// the rotary axis, in deg, becomes part of its zero.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <utility>

#include "base/diagnostic.h"
#include "channels/contract/machine_config.h"
#include "kinematics/polar_face.h"
#include "lang/contract/command.h"
#include "motion/path/path.h"

namespace stanok::channels {

class FaceTransformation {
 public:
  explicit FaceTransformation(const motion::MotionConfig& motion) : motion_(motion) {}

  // Why `change` cannot be made with this scheme, the axes standing at `axes_M`.
  [[nodiscard]] std::optional<Diagnostic> refusal(const lang::TransformationChange& change,
                                                  const kinematics::Scheme& active) const;

  // Replaces `transform`, whose scheme is `active` and whose frame is as programmed, by the one of
  // the plane. Schemes made stay for the run that is under way and the next one.
  void begin(const lang::TransformationChange& change, const kinematics::Scheme& active,
             const motion::Point& axes_M);
  void end() { change_ = {}; }
  void begin_run() { made_before_ = std::exchange(made_, {}); }

  [[nodiscard]] bool is_on() const { return change_.kind != lang::Transformation::off; }
  [[nodiscard]] int rotary_axis() const { return change_.rotary_axis; }
  [[nodiscard]] bool is_on_face() const { return change_.kind == lang::Transformation::polar_face; }

  // The transform of the path for a frame as programmed.
  [[nodiscard]] kinematics::Transform applied_to(const kinematics::Transform& programmed);
  // Between programmed coordinates and those of the path; they differ on the cylinder.
  [[nodiscard]] motion::Point to_path(motion::Point programmed) const;
  [[nodiscard]] motion::Point to_program(motion::Point path) const;
  // X, Y, Z of the workpiece space: the rotary axis stands for one of them.
  [[nodiscard]] std::array<int, 3> geometry() const;

  // How near a line or arc from `start` comes to where the axis of rotation pierces the face, mm.
  [[nodiscard]] double distance_to_pole(const motion::Point& start,
                                        const motion::PathBlock& block) const;

 private:
  const motion::MotionConfig& motion_;
  lang::TransformationChange change_;
  const kinematics::Scheme* active_ = nullptr;
  kinematics::FaceSide side_ = kinematics::FaceSide::positive;
  std::deque<std::unique_ptr<const kinematics::Scheme>> made_;
  std::deque<std::unique_ptr<const kinematics::Scheme>> made_before_;  // in the run before
};

}  // namespace stanok::channels
