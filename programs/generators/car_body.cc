#include "programs/generators/car_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/place.h"
#include "programs/generators/curve_split.h"

namespace stanok::programs {
namespace {

constexpr double half_width = 26.0;  // of the zone
constexpr double half_length = 43.0;
constexpr double depth = 31.0;
constexpr double safe_z = 50.0;
constexpr double clearance_z = 5.0;
constexpr double roll_radius = 2.0;  // of the quarter circles in ZX
constexpr double trial_step = 0.01;  // for the slope of the surface

struct Plan {
  int blocks;
  double time_s;  // at the programmed feeds, below the measured one by what the ramps take
  int rows;       // along the car
  int sections;
  int cross_rows;
  Spacing spacing;
};

constexpr Plan full{41913, 2690.0, 144, 4, 24, {0.002, 0.12, 0.50}};
constexpr Plan small{600, 11.0, 4, 2, 2, {0.01, 0.3, 2.0}};

// From 0 at t <= 0 to 1 at t >= 1, three derivatives continuous.
double smooth_step(double t) {
  const double u = std::clamp(t, 0.0, 1.0);
  return u * u * u * u * (35.0 + u * (-84.0 + u * (70.0 - 20.0 * u)));
}

// 1 between `rise_end` and `fall`, 0 outside `rise` and `fall_end`.
double plateau(double t, double rise, double rise_end, double fall, double fall_end) {
  return smooth_step((t - rise) / (rise_end - rise)) *
         (1.0 - smooth_step((t - fall) / (fall_end - fall)));
}

double bump(double dx, double dy, double radius) {
  const double q = 1.0 - (dx * dx + dy * dy) / (radius * radius);
  return q <= 0.0 ? 0.0 : q * q * q * q;
}

// Lays out the two operations for one budget.
class CarBody {
 public:
  CarBody(const Plan& plan, const Layout& layout, const Budget& budget, const Point& start)
      : plan_(plan),
        budget_(budget),
        unit_(std::pow(10.0, -layout.decimals)),
        program_(layout, start) {}

  ProgramWriter lay_out() {
    share_blocks();
    head();
    for (int section = 0; section < plan_.sections; ++section) raster(section);
    for (int row = 0; row < plan_.cross_rows; ++row) cross_row(row);
    tail();
    return std::move(program_);
  }

 private:
  // The half circles at the row ends stand on the base plane, inside the zone.
  [[nodiscard]] double row_pitch() const { return 2.0 * half_width / (plan_.rows - 1); }
  [[nodiscard]] double row_end() const { return half_length - 0.5 * row_pitch(); }
  // Rounded to an even number of units, so that the centres of the half circles are exact.
  [[nodiscard]] double row_x(int row) const {
    return 2.0 * unit_ * std::round((-half_width + row * row_pitch()) / (2.0 * unit_));
  }
  [[nodiscard]] double cross_y(int row) const {
    return plan_.cross_rows == 1 ? 0.0 : -36.0 + 72.0 * row / (plan_.cross_rows - 1);
  }
  [[nodiscard]] static Point on_surface(double x, double y) {
    return {x, y, car_height(x, y) - depth};
  }
  [[nodiscard]] static bool is_upward(int row) { return row % 2 == 0; }

  [[nodiscard]] CurveSplit row_split(int row) const {
    const double x = row_x(row);
    const double end = is_upward(row) ? row_end() : -row_end();
    return {[x](double y) { return on_surface(x, y); }, -end, end, plan_.spacing};
  }
  [[nodiscard]] CurveSplit cross_split(int row) const {
    const double y = cross_y(row);
    const double end = half_width - roll_radius;
    return {[y](double x) { return on_surface(x, y); }, -end, end, plan_.spacing};
  }

  void share_blocks() {
    for (int row = 0; row < plan_.rows; ++row) splits_.push_back(row_split(row));
    for (int row = 0; row < plan_.cross_rows; ++row) splits_.push_back(cross_split(row));
    std::vector<double> weights;
    weights.reserve(splits_.size());
    for (const CurveSplit& split : splits_) weights.push_back(split.chords_wanted());
    counts_ = shares(weights, budget_.row_blocks);
  }

  void head() {
    program_.comment("%");
    program_.comment("(0003_MB_3D, MODEL CAR BODY, FINISHING)");
    program_.comment("(T1 BALL CUTTER D6, ZERO ON THE ROOF)");
    program_.block("G21 G90 G17 G40 G49 G80");
    program_.block("T1 M6");
    program_.block("S12000 M3");
    program_.block("G54");
    program_.rapid({row_x(0), -row_end(), stay, stay, stay});
    program_.rapid({stay, stay, safe_z, stay, stay}, "G43 H1");
    program_.block("G64 P0.01");
    program_.block("M8");
  }

  void tail() {
    program_.rapid({stay, stay, safe_z, stay, stay});
    program_.block("G49");
    program_.block("M9");
    program_.block("M5");
    program_.block("M30");
    program_.comment("%");
  }

  // To the start of a row through the air, then down at half feed.
  void approach(const Point& to) {
    program_.rapid({stay, stay, clearance_z, stay, stay});
    program_.rapid({to[0], to[1], stay, stay, stay});
    program_.rapid({stay, stay, to[2] + 2.0, stay, stay});
    program_.line(to, 0.5 * budget_.feed_low);
  }

  void raster(int section) {
    const int first = plan_.rows * section / plan_.sections;
    const int last = plan_.rows * (section + 1) / plan_.sections - 1;
    program_.comment("(RASTER SECTION " + std::to_string(section + 1) + ")");
    approach(on_surface(row_x(first), is_upward(first) ? -row_end() : row_end()));
    for (int row = first; row <= last; ++row) {
      const double x = row_x(row);
      follow(row, [x](double y) { return on_surface(x, y); });
      if (row < last) turn(row);
    }
  }

  void turn(int row) {
    const double y = is_upward(row) ? row_end() : -row_end();
    const double to_next = row_x(row + 1) - row_x(row);
    program_.arc_xy(on_surface(row_x(row + 1), y), {0.5 * to_next, 0.0},
                    is_upward(row) ? Turn::clockwise : Turn::counter_clockwise, budget_.feed_low);
  }

  void cross_row(int row) {
    const double y = cross_y(row);
    const double end = half_width - roll_radius;
    if (row == 0) program_.comment("(ROWS ACROSS THE CAR)");
    approach({-half_width, y, roll_radius - depth, stay, stay});
    program_.quarter_zx(on_surface(-end, y), {0.0, roll_radius}, Turn::clockwise, budget_.feed_low);
    follow(plan_.rows + row, [y](double x) { return on_surface(x, y); });
    program_.quarter_zx({half_width, y, roll_radius - depth}, {roll_radius, 0.0}, Turn::clockwise,
                        budget_.feed_low);
  }

  void follow(int row, const CurveSplit::Curve& curve) {
    const std::size_t index = checked_size(row);
    for (const double parameter : splits_[index].ends(counts_[index])) {
      const Point point = curve(parameter);
      program_.line(point, feed_at(point));
    }
  }

  // Three steps: flat parts, inclined parts, and the flanks that the ball cuts near its equator.
  [[nodiscard]] double feed_at(const Point& point) const {
    const double z = car_height(point[0], point[1]);
    const double slope = std::hypot(car_height(point[0] + trial_step, point[1]) - z,
                                    car_height(point[0], point[1] + trial_step) - z) /
                         trial_step;
    if (slope < std::tan(std::numbers::pi / 9.0)) return budget_.feed_high;
    if (slope < 1.0) return 0.5 * (budget_.feed_low + budget_.feed_high);
    return budget_.feed_low;
  }

  const Plan& plan_;
  Budget budget_;
  double unit_;
  ProgramWriter program_;
  std::vector<CurveSplit> splits_;
  std::vector<int> counts_;
};

}  // namespace

double car_height(double x_mm, double y_mm) {
  const double body =
      plateau(y_mm, -41.0, -25.0, 26.0, 41.0) * plateau(x_mm, -23.0, -13.0, 13.0, 23.0);
  const double cabin =
      plateau(y_mm, -17.0, -2.0, 14.0, 30.0) * plateau(x_mm, -17.0, -7.0, 7.0, 17.0);
  double arches = 0.0;
  for (const double side : {-1.0, 1.0}) {
    arches +=
        bump(x_mm - 16.0 * side, y_mm + 25.0, 9.0) + bump(x_mm - 16.0 * side, y_mm - 25.0, 9.0);
  }
  const double scoop = bump(x_mm, y_mm + 25.0, 7.0);
  return 15.0 * body + 16.0 * cabin + 2.5 * arches + 1.2 * scoop;
}

Workload car_body(const WorkloadOptions& options) {
  const Plan& plan = options.scale == Scale::full ? full : small;
  const Layout layout{
      .axis_count = 3, .decimals = options.decimals.value_or(4), .every_motion_code = true};
  const auto lay_out = [&](const Budget& budget) {
    return CarBody(plan, layout, budget, options.start).lay_out();
  };
  return {"0003_MB_3D.nc", layout, fitted(lay_out, plan.blocks, plan.time_s, 0.7, options)};
}

}  // namespace stanok::programs
