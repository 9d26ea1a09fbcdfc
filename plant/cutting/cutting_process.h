// CuttingProcess: the force on a turning tool, the power it takes and the vibration it makes.
//
//   P_z = C t h^y (HB / HB_0)^e,  N = P_z w R / efficiency
// t: depth of cut from the stock; h: thickness of the chip, the travel of the tool in the cut over
// the last revolution, so that a change of feed acts over a whole one; HB: hardness of the material
// there. Allocates in its constructor only.
#pragma once

#include <array>
#include <vector>

#include "base/rt_safe.h"
#include "plant/cutting/self_oscillation.h"
#include "plant/cutting/stock.h"

namespace stanok::plant {

// The tool in the frame of the program: x is a radius, mm.
struct ToolPoint {
  double x_mm = 0.0;
  double z_mm = 0.0;
};

// Travel of the tool in the cut over the last revolution of the spindle.
class ChipThickness {
 public:
  ChipThickness();
  void advance(double travel_mm, double turns) RT_SAFE;
  [[nodiscard]] double thickness_mm() const RT_SAFE { return thickness_mm_; }

 private:
  struct Sample {
    double turns = 0.0;
    double travel_mm = 0.0;
  };
  std::vector<Sample> samples_;  // a ring
  std::size_t newest_ = 0;
  std::size_t oldest_ = 0;  // the last one that is a revolution old, or older
  double thickness_mm_ = 0.0;
};

class CuttingProcess {
 public:
  explicit CuttingProcess(const config::CuttingConfig& config);

  // `dt_s` on, with the tool at `tool` and the spindle at this speed.
  void advance(const ToolPoint& tool, double rev_per_min, double dt_s) RT_SAFE;

  [[nodiscard]] double force_n() const RT_SAFE { return force_n_; }
  [[nodiscard]] double power_w() const RT_SAFE { return power_w_; }
  [[nodiscard]] const Stock::Cut& cut() const RT_SAFE { return cut_; }
  // The vibration at four instants of the latest `dt_s`, um.
  static constexpr std::size_t vibration_samples = 4;
  [[nodiscard]] const std::array<double, vibration_samples>& vibration_um() const RT_SAFE {
    return vibration_um_;
  }

 private:
  config::CuttingConfig config_;
  Stock stock_;
  ChipThickness chip_;
  SelfOscillation oscillation_;
  Stock::Cut cut_;
  ToolPoint tool_;
  bool is_placed_ = false;
  double force_n_ = 0.0;
  double force_mean_n_ = 0.0;
  double power_w_ = 0.0;
  std::array<double, vibration_samples> vibration_um_{};
};

}  // namespace stanok::plant
