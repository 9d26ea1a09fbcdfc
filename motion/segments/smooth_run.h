// SmoothRun: a cubic spline with continuous curvature in place of a run of straight blocks that
// turn little.
//
// The spline is a quasi-interpolant of the programmed path over its length: control points lie on
// it at the Greville abscissae of the knots, less the second difference that makes quadratics exact
// (docs/developer/motion.md#runs). It is local, needs no solution of equations and is straight
// where the path is. Knots stand as far apart as the tolerance allows: every stretch between two
// knots or corners is compared with its block by the control points of the difference, which bound
// it, and knots are put in until all are within tolerance. Owner: the channel's preparation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "motion/path/path.h"
#include "motion/path/run_spline.h"

namespace stanok::motion {

class SmoothRun {
 public:
  explicit SmoothRun(const MotionConfig& config);

  // Whether two straight blocks in a row may belong to one run.
  [[nodiscard]] bool may_join(const Segment& incoming, const Segment& outgoing,
                              const Tolerance& tolerance) const;

  [[nodiscard]] bool is_open() const { return !spline_.way.is_empty(); }
  void clear();

  // How the path goes on where the run has an end.
  enum class End : std::uint8_t {
    straight,  // along half of the block there, as it is programmed, for a blend with another block
    at_rest,   // the axes stand there: the spline begins or ends with the path, bent as it likes
  };
  // A place on a block, by path length from its start.
  struct Place {
    double s = 0.0;
    Point point{};
  };
  // Opens a run with its first block, of which a blend has taken the part up to `taken`; returns
  // where on it the spline begins: there or later.
  [[nodiscard]] Place begin(const Segment& first, const Tolerance& tolerance, End end,
                            const Place& taken);
  // Takes the next block. Segments that are final are appended to `out`.
  void add(const Segment& next, const Tolerance& tolerance, std::vector<Segment>& out);
  // Closes the run. Returns where on its last block the spline ends.
  [[nodiscard]] Place end(End end, std::vector<Segment>& out);

 private:
  [[nodiscard]] Tolerance chord_share(const Tolerance& tolerance) const;
  [[nodiscard]] SegmentBounds bounds_of(const Segment& segment, const Tolerance& tolerance) const;
  void place_knots();
  [[nodiscard]] double next_knot() const;
  double place_last_knots();
  double place_knots_before_straight();
  void make_room_before(double t);
  void settle();
  [[nodiscard]] bool fits(std::size_t span) const;
  [[nodiscard]] bool fits_leg(const Leg& leg, double a, double b,
                              const RunSpline::ControlPoints& points) const;
  void split_around(std::size_t span);
  bool split(std::size_t span);
  void take_back(std::size_t knot);
  void grade(std::size_t span);
  [[nodiscard]] bool is_long_straight(std::size_t span) const;

  void emit(std::size_t until, std::vector<Segment>& out);
  void emit_span(std::size_t span, std::vector<Segment>& out);
  void emit_line(std::vector<Segment>& out);
  void emit_curve(const Leg& leg, const RunSpline::ControlPoints& points,
                  std::vector<Segment>& out);
  void forget_emitted();

  MotionConfig config_;
  Tolerance chord_margin_;
  double turn_cosine_min_;
  RunSpline spline_;
  std::size_t settled_ = 0;  // spans before it are within tolerance
  std::size_t emitted_ = 0;  // spans before it have left
  std::size_t frozen_ = 0;   // knots on which they depend, or the first ones
  Point emitted_to_{};
  // A straight stretch within one leg that has not left yet.
  struct Straight {
    bool is_open = false;
    double from = 0.0;
    double to = 0.0;
  };
  Straight straight_;
};

}  // namespace stanok::motion
