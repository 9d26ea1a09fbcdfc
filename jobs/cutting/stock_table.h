// The turned workpiece before a cut, as people give it: a line of text or a table in a file.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace stanok::jobs {

// The workpiece before the cut, in the frame of the program: from this z on to smaller z.
struct StockStep {
  double z_mm = 0.0;
  double radius_mm = 0.0;
  double hardness_hb = 0.0;  // 0: not known, the force is that of the first step
};

// The force of a hardness HB is that of HB_0 times (HB / HB_0)^e.
struct StockTable {
  std::vector<StockStep> steps;  // z falls
  double hardness_hb = 0.0;      // HB_0, for which C is; 0: the hardness of the first step
  double hardness_exponent = 0.75;

  // Radius at a z; 0: in front of the workpiece.
  [[nodiscard]] double radius_mm(double z_mm) const;
  [[nodiscard]] double force_factor(double z_mm) const;
};

// Z:RADIUS or Z:RADIUS:HARDNESS in mm and HB with falling Z, as "0:32:200,-20:33:240"; nothing: the
// text is not of this form.
[[nodiscard]] std::optional<StockTable> stock_of_text(std::string_view text);

// A machine file (.toml): its [[simulation.cutting.stock]]; else lines of z, radius and hardness
// with commas between, the first of which may name them. Throws std::runtime_error with what is
// wrong in it.
[[nodiscard]] StockTable read_stock_table(const std::filesystem::path& file);

}  // namespace stanok::jobs
