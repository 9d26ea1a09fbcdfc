// Action of G76 on lathe channels: a thread in many passes.
//
// Two forms. With K: Z end, P lead, I from the start diameter to the thread's peak (negative: an
// outside thread), J first depth, K full depth, R degression (depth of pass n is J n^(1/R)), Q
// angle at which the tool is fed in, H spring passes, E length of the tapers, L where they are (1
// entry, 2 exit, 3 both). Without K: a block P Q R without axes (P: spring passes, run-out in
// tenths of the lead and tool angle, two digits each; Q smallest cut; R last cut), then a block X Z
// R P Q F (root and end of the thread, taper, depth, first depth, lead). All depths are radii,
// program units. Sources: documentation of LinuxCNC, "G76"; of Fanuc lathe controls, multiple
// threading cycle. The tool is fed in along the flank that leads: shallow passes begin farther
// back.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "lang/actions/cycle_moves.h"
#include "lang/block/other_controls.h"

namespace stanok::lang {
namespace {

constexpr int thread_passes_max = 1000;

// What both forms come to.
struct Thread {
  double lead = 0.0;
  TurningPoint peak_start;  // the crest of the thread
  TurningPoint peak_end;
  double inward = -1.0;         // direction of depth along X
  double depth = 0.0;           // full, > 0
  double infeed_tangent = 0.0;  // along Z per depth
  double entry = 0.0;           // lengths along Z at full depth
  double exit = 0.0;
  std::vector<double> passes;  // depth of each
  int spindle = 0;
  double start_angle_deg = 0.0;
  bool ends_beside_its_end = false;  // not where it began
};

double tangent_of_deg(double angle) {
  return std::tan(angle * std::numbers::pi / 180.0);
}

void ask_for(ActiveBlock& block, char letter, const std::string& what) {
  const bool present = block.has(letter);
  block
      .fail(present ? "E4008" : "E4007", {present ? letter : 'G', present ? -1 : 760, {}},
            "`G76` needs " + what, present ? "out of range" : std::string("no ") + letter)
      .help.push_back(
          "write `G76 P Z I J K`, or the settings `G76 P Q R` and then `G76 X Z P Q F`");
}

// Lengths of a thread are far below this, in either unit; Fanuc controls count P and Q in
// thousandths.
constexpr double thread_depth_max = 20.0;

// Words of the other forms of G76.
void refuse_words_of_other_forms(ActiveBlock& block, std::string_view used) {
  for (const char letter : std::string_view("EFHIJKLPQR")) {
    if (!block.has(letter) || used.find(letter) != std::string_view::npos) continue;
    block.fail("E4003", {letter, -1, {}},
               std::string("this form of `G76` does not use `") + letter + "`", "unused word");
    return;
  }
}

// Depth n is first * n^exponent, then `last` once more and the spring passes.
void add_passes(ActiveBlock& block, Thread& thread, double first, double exponent, double smallest,
                int spring) {
  double depth = 0.0;
  for (int n = 1; depth < thread.depth; ++n) {
    if (n > thread_passes_max) {
      block.fail("E4063", {'J', -1, {}}, "G76 makes more than 1000 passes", "too small");
      return;
    }
    depth = std::max(first * std::pow(n, exponent), depth + smallest);
    // A rest that rounding leaves is no pass.
    if (depth > thread.depth - 1e-9) depth = thread.depth;
    thread.passes.push_back(depth);
  }
  thread.passes.insert(thread.passes.end(), static_cast<std::size_t>(spring), thread.depth);
}

void cut_pass(CycleMoves& moves, const Thread& thread, TurningPoint start, double depth) {
  const double along = thread.peak_end.z > thread.peak_start.z ? 1.0 : -1.0;
  const double back = (thread.depth - depth) * thread.infeed_tangent;
  const double z_start = start.z - along * back;
  const double z_end = thread.peak_end.z;
  const double slope =
      (thread.peak_end.x - thread.peak_start.x) / (thread.peak_end.z - thread.peak_start.z);
  const auto at = [&](double z, double below_peak) {
    const double peak = thread.peak_start.x + slope * (z - thread.peak_start.z);
    return TurningPoint{peak + thread.inward * below_peak, z};
  };
  const double part = depth / thread.depth;
  const double entry = thread.entry * part;
  const double exit = thread.exit * part;
  moves.rapid({start.x, z_start});
  moves.rapid(at(z_start, entry > 0.0 ? 0.0 : depth));
  if (entry > 0.0)
    moves.thread(at(z_start + along * entry, depth), thread.lead, thread.spindle,
                 thread.start_angle_deg);
  if (exit > 0.0)
    moves.thread(at(z_end - along * exit, depth), thread.lead, thread.spindle,
                 thread.start_angle_deg);
  if (exit > 0.0) {
    moves.run_out(at(z_end, 0.0), thread.lead, thread.spindle, thread.start_angle_deg);
    moves.rapid({start.x, z_end});
  } else {
    moves.thread_and_out(at(z_end, depth), start.x, thread.lead, thread.spindle,
                         thread.start_angle_deg);
  }
}

void cut_passes(ActiveBlock& block, CycleMoves& moves, const Thread& thread) {
  if (block.failed()) return;
  const TurningPoint start = moves.position();
  const double length = std::abs(thread.peak_end.z - thread.peak_start.z);
  if (length <= thread.entry + thread.exit || length <= thread.depth * thread.infeed_tangent) {
    block.fail("E4067", {'G', g(76), {}}, "the thread is shorter than its tapers", "no length left")
        .help.push_back("use a longer thread, shorter tapers or a smaller infeed angle");
    return;
  }
  const TurningPoint end{start.x, thread.peak_end.z};
  for (std::size_t n = 0; n < thread.passes.size(); ++n) {
    cut_pass(moves, thread, start, thread.passes[n]);
    const bool is_last = n + 1 == thread.passes.size();
    moves.rapid(is_last && thread.ends_beside_its_end ? end : start);
  }
}

void cut_with_full_depth(ActiveBlock& block, CycleMoves& moves, Thread thread) {
  refuse_words_of_other_forms(block, "EHIJKLPQR");
  const double taper = block.has('E') ? block.length('E') : 0.0;
  const double degression = block.has('R') ? block.value('R') : 1.0;
  const double angle = block.has('Q') ? block.value('Q') : 0.0;
  if (!block.has('P') || block.value('P') <= 0.0) ask_for(block, 'P', "P, a positive lead");
  if (!block.has('I') || block.value('I') == 0.0)
    ask_for(block, 'I', "I, the distance to the peak of the thread");
  if (!block.has('J') || block.value('J') <= 0.0) ask_for(block, 'J', "J, a positive first depth");
  if (block.value('K') <= 0.0) ask_for(block, 'K', "K, a positive depth");
  if (degression < 1.0) ask_for(block, 'R', "R of at least 1");
  if (angle < 0.0 || angle >= 80.0) ask_for(block, 'Q', "Q from 0 to below 80 degrees");
  if (taper < 0.0) ask_for(block, 'E', "E of at least 0");
  const auto spring = block.has('H') ? block.integer('H', 0, 99) : 0;
  const auto ends = block.has('L') ? block.integer('L', 0, 3) : 0;
  if (block.failed() || !spring || !ends) return;
  const TurningPoint start = moves.position();
  const double peak = start.x + block.length('I');
  thread.lead = block.length('P');
  thread.peak_start = {peak, start.z};
  thread.peak_end = {peak, moves.programmed_end().z};
  thread.inward = block.value('I') < 0.0 ? -1.0 : 1.0;
  thread.depth = block.length('K');
  thread.infeed_tangent = tangent_of_deg(angle);
  // LinuxCNC, G76: the tool ends at the end of the drive line.
  thread.ends_beside_its_end = block.words.rules.is_linuxcnc();
  thread.entry = (*ends & 1) != 0 ? taper : 0.0;
  thread.exit = (*ends & 2) != 0 ? taper : 0.0;
  add_passes(block, thread, block.length('J'), 1.0 / degression, 0.0, *spring);
  cut_passes(block, moves, thread);
}

// R has a point on Fanuc controls, too; a last cut of centimetres is one in thousandths.
void refuse_last_cut_in_thousandths(ActiveBlock& block) {
  const bool whole = (block.words.whole & letter_bit('R')) != 0;
  if (block.failed() || !block.has('R') || !whole || block.value('R') < thread_depth_max) return;
  const std::string value = std::to_string(static_cast<long long>(block.value('R')));
  block.fail("E4016", {'R', -1, {}}, "`R` is a last cut of " + value, "thousandths?")
      .help.push_back("write the number with its decimal point, in the units of the program");
}

// First block of the other form: it stays valid for those that follow.
void take_thread_settings(ActiveBlock& block) {
  refuse_words_of_other_forms(block, "PQR");
  refuse_thousandths(block, 'Q', thread_depth_max / 10.0, "a smallest cut");
  refuse_last_cut_in_thousandths(block);
  if (block.failed()) return;
  ThreadSettings& settings = block.modal.cycles.thread;
  if (block.has('P')) {
    const auto digits = block.integer('P', 0, 999999);
    if (!digits) return;
    settings.spring_passes = std::max(*digits / 10000, 1) - 1;
    settings.run_out_tenths = *digits / 100 % 100;
    settings.angle_deg = *digits % 100;
  }
  if (block.has('Q'))
    settings.smallest_cut = value_or_thousandths(block, 'Q') * block.length_unit();
  if (block.has('R')) settings.last_cut = block.length('R');
  if (settings.smallest_cut < 0.0) ask_for(block, 'Q', "Q of at least 0");
  if (settings.last_cut < 0.0) ask_for(block, 'R', "R of at least 0");
}

void cut_with_root(ActiveBlock& block, CycleMoves& moves, Thread thread) {
  const ThreadSettings& settings = block.modal.cycles.thread;
  refuse_words_of_other_forms(block, "PQRF");
  for (const char letter : {'P', 'Q'})
    refuse_thousandths(block, letter, thread_depth_max, "a depth");
  if (!moves.names_x()) ask_for(block, 'X', "X, the root of the thread");
  if (!block.has('P') || block.value('P') <= 0.0) ask_for(block, 'P', "P, a positive depth");
  if (!block.has('Q') || block.value('Q') <= 0.0) ask_for(block, 'Q', "Q, a positive first depth");
  if (!block.has('F') || block.value('F') <= 0.0) ask_for(block, 'F', "F, a positive lead");
  if (block.failed()) return;
  const TurningPoint start = moves.position();
  const TurningPoint root = moves.programmed_end();
  const double taper = block.has('R') ? block.length('R') : 0.0;
  const double depth = value_or_thousandths(block, 'P') * block.length_unit();
  thread.inward = start.x > root.x ? -1.0 : 1.0;
  thread.lead = block.length('F');
  thread.depth = depth;
  thread.peak_end = {root.x - thread.inward * depth, root.z};
  thread.peak_start = {thread.peak_end.x + taper, start.z};
  thread.infeed_tangent = tangent_of_deg(settings.angle_deg / 2.0);
  thread.exit = settings.run_out_tenths * thread.lead / 10.0;
  thread.depth = depth - settings.last_cut;
  if (thread.depth <= 0.0) ask_for(block, 'P', "P larger than the last cut");
  if (settings.smallest_cut >= depth) ask_for(block, 'P', "P larger than the smallest cut");
  if (block.failed()) return;
  const double first_cut = value_or_thousandths(block, 'Q') * block.length_unit();
  add_passes(block, thread, first_cut, 0.5, settings.smallest_cut, 0);
  thread.depth = depth;
  const int finishing = (settings.last_cut > 0.0 ? 1 : 0) + settings.spring_passes;
  thread.passes.insert(thread.passes.end(), static_cast<std::size_t>(finishing), depth);
  cut_passes(block, moves, thread);
}

// G76 X Z K D F [I] [A] in one block, as Haas and older Fanuc controls have it: height K, first
// depth D, lead F, taper I (radii), tool angle A; of Haas the angle Q where the spindle begins, in
// thousandths without a point.
void cut_in_one_block(ActiveBlock& block, CycleMoves& moves, Thread thread) {
  refuse_words_of_other_forms(block, block.words.rules.is_haas() ? "KFIPQ" : "KFIP");
  const double first = value_or_thousandths(block, 'D') * block.length_unit();
  if (!moves.names_x()) ask_for(block, 'X', "X, the root of the thread");
  if (block.value('K') <= 0.0) ask_for(block, 'K', "K, a positive height");
  if (first <= 0.0) ask_for(block, 'D', "D, a positive first depth");
  if (!block.has('F') || block.value('F') <= 0.0) ask_for(block, 'F', "F, a positive lead");
  const double angle = block.has('A') ? block.value('A') : 0.0;
  if (angle < 0.0 || angle >= 160.0) ask_for(block, 'A', "A from 0 to below 160 degrees");
  if (block.failed()) return;
  const TurningPoint start = moves.position();
  const TurningPoint root = moves.programmed_end();
  thread.inward = start.x > root.x ? -1.0 : 1.0;
  thread.lead = block.length('F');
  thread.depth = block.length('K');
  thread.peak_end = {root.x - thread.inward * thread.depth, root.z};
  thread.peak_start = {thread.peak_end.x + (block.has('I') ? block.length('I') : 0.0), start.z};
  thread.infeed_tangent = tangent_of_deg(angle / 2.0);
  thread.start_angle_deg = thread_start_angle_deg(block);
  if (block.failed()) return;
  add_passes(block, thread, first, 0.5, 0.0, 0);
  cut_passes(block, moves, thread);
}

}  // namespace

void switch_thread_chamfer(ActiveBlock& block, CodeNumber code) {
  block.modal.switches.thread_chamfer = code == m(23);
}

void cut_thread_in_passes(ActiveBlock& block, CodeNumber code) {
  auto moves = CycleMoves::of(block, code);
  if (!moves) return;
  const bool only_settings = !block.has('K') && block.programmed == 0;
  if (only_settings) return take_thread_settings(block);
  const auto spindle = named_spindle(block);
  if (!spindle) return;
  check_spindle_turns(block, *spindle, code);
  if (!moves->names_z()) ask_for(block, 'Z', "Z, the end of the thread");
  if (block.failed()) return;
  Thread thread;
  thread.spindle = *spindle;
  if (block.has('K') && block.has('D')) {
    cut_in_one_block(block, *moves, std::move(thread));
  } else if (block.has('K')) {
    cut_with_full_depth(block, *moves, std::move(thread));
  } else {
    cut_with_root(block, *moves, std::move(thread));
  }
}

}  // namespace stanok::lang
