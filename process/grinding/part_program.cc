#include "process/grinding/part_program.h"

#include <algorithm>
#include <cmath>

#include "process/grinding/number_text.h"

namespace stanok::process {
namespace {

constexpr double feed_change_max = 0.02;
// More decimals than a feed of a control file has after its change of unit; takes off the noise.
constexpr int feed_decimals = 9;
constexpr int place_decimals = 9;

// The axes stand at the size for some cycles of the control before they turn back.
constexpr double stand_min_s = 0.01;

// What a program terminates with when the gauge stays silent: code of the user.
constexpr int no_size_code = 1600;

// At most `decimals`, without zeros at the end.
std::string short_text(double value, int decimals) {
  std::string text = rounded_text(value, decimals);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string comment(const std::string& text) {
  std::string ascii;
  for (const char c : text) {
    const bool is_plain = c >= ' ' && c <= '~' && c != '(' && c != ')';
    ascii += is_plain ? c : ' ';
  }
  return "(" + ascii + ")\n";
}

class ProgramText {
 public:
  void add(const std::string& block) {
    number_ += 10;
    text_ += "N" + std::to_string(number_) + " " + block + "\n";
  }
  void add_statement(const std::string& statement) { text_ += statement + "\n"; }
  void add_comment(const std::string& words) { text_ += comment(words); }
  [[nodiscard]] std::string text() const { return "%\n" + text_ + "%\n"; }

 private:
  int number_ = 0;
  std::string text_;
};

void add_spindles(ProgramText& program, const GrindingProcess& process,
                  const ProgramOptions& options) {
  if (options.wheel_spindle > 0) {
    program.add("$" + std::to_string(options.wheel_spindle) + " S" +
                short_text(options.wheel_speed_rpm, 1) + " M3");
  }
  program.add("$" + std::to_string(options.part_spindle) + " S" +
              short_text(process.part_speed_rpm, 3) + " M3");
}

void add_infeed(ProgramText& program, const InfeedLaw& law, const ProgramOptions& options) {
  const auto place = [&](double x_mm) {
    return options.infeed_word + short_text(x_mm, place_decimals);
  };
  const auto feed = [](double mm_per_s) {
    return " F" + short_text(mm_per_s * 60.0, feed_decimals);
  };
  program.add("G0 " + place(law.front().x_mm + options.gap_mm));
  program.add("G1 " + place(law.front().x_mm) + feed(law.front().feed_mm_per_s));
  std::vector<FeedBlock> blocks = feed_blocks(law);
  const FeedBlock last = blocks.back();
  if (options.gauge_margin_mm > 0.0) blocks.pop_back();
  for (const FeedBlock& block : blocks) {
    program.add("G1 " + place(block.end_mm) + feed(block.feed_mm_per_s));
  }
  if (options.gauge_margin_mm > 0.0) {
    program.add("G38.3 " + place(last.end_mm - options.gauge_margin_mm) + feed(last.feed_mm_per_s));
  }
}

}  // namespace

std::vector<FeedBlock> feed_blocks(const InfeedLaw& law) {
  std::vector<FeedBlock> blocks;
  for (std::size_t k = 0; k + 1 < law.size(); ++k) {
    const InfeedRow& begin = law[k];
    const InfeedRow& end = law[k + 1];
    if (begin.x_mm == end.x_mm) continue;
    const double change = std::abs(std::log(end.feed_mm_per_s / begin.feed_mm_per_s));
    const int steps = std::max(1, static_cast<int>(std::ceil(change / feed_change_max)));
    for (int step = 0; step < steps; ++step) {
      const auto at = [&](int place) {
        return std::lerp(begin.feed_mm_per_s, end.feed_mm_per_s,
                         static_cast<double>(place) / steps);
      };
      const double part = static_cast<double>(step + 1) / steps;
      const double end_mm = step + 1 == steps ? end.x_mm : std::lerp(begin.x_mm, end.x_mm, part);
      blocks.push_back({end_mm, std::min(at(step), at(step + 1))});
    }
  }
  return blocks;
}

std::string part_program(const GrindingProcess& process, const InfeedLaw& law,
                         const ProgramOptions& options) {
  ProgramText program;
  if (!options.title.empty()) program.add_comment(options.title);
  program.add_comment("PLUNGE GRINDING TO RADIUS " + short_text(process.part_radius_mm, 4) +
                      ", ALLOWANCE " + short_text(law.front().x_mm, 4) + " PER SIDE");
  program.add_comment("X IS WHAT A RIGID MACHINE WOULD HAVE LEFT, AS IN THE CONTROL FILE");
  program.add("G21 G90 G18 G8 G40 G94 G54 G64");
  program.add("G52 " + options.infeed_word + short_text(process.part_radius_mm, place_decimals));
  add_spindles(program, process, options);
  program.add("M8");
  add_infeed(program, law, options);
  program.add("G4 P" + short_text(std::max(options.spark_out_s, stand_min_s), 3));
  program.add("G0 " + options.infeed_word + short_text(options.retract_mm, 3));
  if (options.gauge_margin_mm > 0.0) {
    program.add_statement("if ($probe_ok == false) { terminate (" + std::to_string(no_size_code) +
                          ", \"no size from the gauge\"); }");
  }
  program.add("G52 " + options.infeed_word + "0");
  program.add("M9");
  program.add("M5 $-1");
  program.add("M30");
  return program.text();
}

}  // namespace stanok::process
