// Writes a part program block by block and keeps the path that its text describes.
//
// Every coordinate is rounded once to the decimals of the program; the text, the path and the
// nominal time are all made from the rounded value, so that the path is exactly what is programmed.
// Words that do not change are left out unless the layout says otherwise. Units: mm, deg, mm/min in
// the text, mm/s in the path.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace stanok::programs {

inline constexpr int coordinate_count = 5;
using Point = std::array<double, coordinate_count>;  // X Y Z B C: mm, mm, mm, deg, deg

// As a coordinate of a rapid motion: not programmed, the axis stands.
inline constexpr double stay = std::numeric_limits<double>::quiet_NaN();

// How the text looks.
struct Layout {
  std::size_t axis_count = 3;  // 3: X Y Z, 5: X Y Z B C
  int decimals = 4;
  int number_step = 10;  // N10 N20 ...
  int feed_decimals = 0;
  bool every_motion_code = false;  // G1 in every motion block, changed or not
  bool every_word = false;         // all axis words and F in every motion block
};

enum class Turn : std::uint8_t { clockwise, counter_clockwise };  // of an arc

// One motion of the path, in the form of the judges' path files.
struct PathStep {
  std::int64_t block = 0;  // which block of the program, from 1
  Point end{};
  double feed_mm_per_s = 0.0;
  int shape = 1;                   // 1 line, 2 clockwise, 3 counter-clockwise arc in the XY plane
  std::array<double, 2> centre{};  // of the arc, from its start
};

class ProgramWriter {
 public:
  // `start`: where the machine stands when the program begins, first point of the path.
  ProgramWriter(const Layout& layout, const Point& start);

  void comment(std::string_view line);  // a line that is no block, % included
  void block(std::string_view words);   // a block without motion
  // Motions to `end`; axes whose rounded coordinate stays are not programmed, and a rapid to where
  // the tool stands is left out. `prefix` stands
  // before the axis words, as G43 H1 does.
  void rapid(const Point& end, std::string_view prefix = {});
  void line(const Point& end, double feed_mm_per_min);
  // Half or part circle in XY; `centre` from the start. The other axes stand.
  void arc_xy(const Point& end, std::array<double, 2> centre_xy, Turn turn, double feed_mm_per_min);
  // Quarter circle in ZX under G18 with the centre (I, K) from the start; G17 is restored by the
  // next other motion. The path holds it as chords that leave the circle by less than 0.1 um.
  void quarter_zx(const Point& end, std::array<double, 2> centre_zx, Turn turn,
                  double feed_mm_per_min);

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const std::vector<PathStep>& path() const { return path_; }
  [[nodiscard]] std::int64_t blocks() const { return blocks_; }
  // Sum of length over feed of all feed motions.
  [[nodiscard]] double feed_time_s() const { return feed_time_s_; }

 private:
  using Units =
      std::array<std::int64_t, coordinate_count>;  // coordinates in units of the last decimal

  [[nodiscard]] Units rounded(const Point& point) const;
  [[nodiscard]] Point value(const Units& units) const;
  [[nodiscard]] std::string word(char address, std::int64_t units) const;
  void begin_block();
  void end_block();
  void plane(int code);
  void motion_code(int code);
  void feed_word(double feed_mm_per_min);
  void axis_words(const Point& end);
  [[nodiscard]] bool is_at(const Point& end) const;
  [[nodiscard]] double feed_mm_per_s() const;  // as last programmed
  void move(const Point& end, PathStep step);

  Layout layout_;
  std::int64_t scale_ = 1;       // units of a coordinate in 1 mm or deg
  std::int64_t feed_scale_ = 1;  // units of the feed in 1 mm/min
  std::string text_;
  std::string line_;            // the current block
  std::vector<PathStep> path_;  // never empty
  std::int64_t blocks_ = 0;
  double feed_time_s_ = 0.0;
  Units position_{};
  std::array<bool, coordinate_count> programmed_{};  // the word has been programmed at least once
  int motion_ = -1;
  int plane_ = 17;
  std::int64_t feed_ = -1;  // mm/min in units of its last decimal
};

// `units` / 10^decimals as text, with all decimals.
[[nodiscard]] std::string decimal_text(std::int64_t units, int decimals);

}  // namespace stanok::programs
