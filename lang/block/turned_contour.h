// A contour to be turned, in the coordinates of its roughing: `depth` goes from the start point
// into the material (along X for G71, along Z for G72), `along` is the direction of the passes.
//
// The contour is a chain of segments that are monotonic in both; mm, from the start point.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace stanok::lang {

// X and Z in W, mm.
struct TurningPoint {
  double x = 0.0;  // radius
  double z = 0.0;
};

// A programmed move of the contour, absolute in W.
struct PlaneMove {
  TurningPoint end;
  bool arc = false;
  TurningPoint centre;
  bool counter_clockwise = false;
  std::uint32_t line = 0;
  bool rapid = false;
};

struct TurnedPoint {
  double depth = 0.0;
  double along = 0.0;
};

struct TurnedSegment {
  TurnedPoint start;
  TurnedPoint end;
  bool arc = false;
  TurnedPoint centre;
  bool counter_clockwise = false;  // of the arc as programmed
  std::uint32_t line = 0;
};

// A stretch of a pass on one level that stays off the contour.
struct TurnedStretch {
  double begin = 0.0;
  double end = 0.0;
  bool from_start = false;  // no need to plunge
};

// The axis along which passes run.
enum class PassAxis { x, z };

class TurnedContour {
 public:
  // `moves` in ZX from the start point; the first leads to the contour. `allowance` is added to
  // every point. On failure problem() says why.
  TurnedContour(const std::vector<PlaneMove>& moves, TurningPoint start, TurningPoint allowance,
                PassAxis along);

  [[nodiscard]] const std::string& problem() const { return problem_; }
  [[nodiscard]] std::uint32_t problem_line() const { return problem_line_; }

  [[nodiscard]] TurningPoint point(TurnedPoint p) const;
  [[nodiscard]] TurnedPoint turned(TurningPoint p) const;
  [[nodiscard]] TurnedPoint first_point() const { return segments_.front().start; }
  [[nodiscard]] double deepest() const;
  [[nodiscard]] double shallowest() const;
  [[nodiscard]] std::vector<TurnedStretch> stretches(double depth) const;
  // The contour without its pockets: where it goes deeper than it was, it stays on the level until
  // it is no deeper any more. The first move leads to where it begins.
  [[nodiscard]] std::vector<PlaneMove> without_pockets() const;

 private:
  void add(const PlaneMove& move, TurningPoint start, TurningPoint allowance);
  void add_segment(const TurnedSegment& segment);
  [[nodiscard]] PlaneMove move_to(TurnedPoint end, const TurnedSegment& of) const;

  TurningPoint start_;
  bool along_z_;
  double depth_sign_ = 1.0;
  double along_sign_ = 1.0;
  std::vector<TurnedSegment> segments_;
  std::string problem_;
  std::uint32_t problem_line_ = 0;
};

}  // namespace stanok::lang
