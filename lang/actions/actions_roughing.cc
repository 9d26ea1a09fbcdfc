// Actions of contour cycles of lathe channels: G71 rough turning, G72 rough facing, G73 pattern
// repeating, G70 finishing.
//
// G71 cuts along Z on levels of X, G72 along X on levels of Z, from the start point to the contour
// with its allowance, with a last pass along it; the tool comes back to the start point. Between
// two levels lies the depth of cut. Every pass is left at 45 degrees by the retract. G73 follows
// the contour itself, shifted by less from pass to pass. On mill channels G70 and G71 are inch and
// millimetre, G73 drills.
//
// The lathe cycles of LinuxCNC follow a profile in an O-subprogram: G71, G71.1,
// G71.2 rough it along Z, G72, G72.1, G72.2 along X, G70 finishes it.
//
// Q is the number of the subprogram, X Z the start point, D what stays on the profile, measured
// across it, I the depth of a cut, R the retract; the codes with .1 leave out pockets, those with
// .2 cut these alone. G70 follows the profile P times, first D, at last E from it: pass n at (n -
// 1) (D - E) / P + E, n from P to 1. The tool ends over the end of the profile, in G70 on it.
// Source: LinuxCNC, G-Codes, "G70 Lathe finishing cycle", "G71 G72 Lathe roughing cycles".
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "lang/actions/block_execution.h"
#include "lang/actions/cycle_moves.h"
#include "lang/block/other_controls.h"
#include "lang/block/radius_compensation.h"

namespace stanok::lang {
namespace {

// Passes that one block may make; all of them are held at once.
constexpr double levels_max = 10000.0;
constexpr int roughing_passes_max = 9999;

// Words that the code does not have on this channel, or not in this form.
void refuse_words(ActiveBlock& block, std::string_view refused) {
  std::vector<std::string> help;
  if (block.channel.kind != ChannelKind::lathe) {
    help.emplace_back(
        "on a mill G70 and G71 are inch and millimetre; the contour cycles exist only on lathe "
        "channels");
  }
  for (const char letter : refused) {
    if (!block.has(letter)) continue;
    block
        .fail("E4003", {letter, -1, {}}, std::string("nothing in this block uses `") + letter + "`",
              "unused word")
        .help = help;
  }
}

std::optional<Contour> find_contour(ActiveBlock& block, CodeNumber code) {
  for (const char letter : {'P', 'Q'}) {
    if (block.has(letter)) continue;
    block.fail("E4007", {'G', code, {}},
               "`" + code_text('G', code) + "` needs P and Q, the block numbers of the contour",
               std::string("no ") + letter);
    return std::nullopt;
  }
  const auto first = block.integer('P', 0, 99999999);
  const auto last = block.integer('Q', 0, 99999999);
  if (!first || !last) return std::nullopt;
  Contour contour;
  contour.problem = "a contour cannot hold a contour cycle";
  if (block.contours != nullptr) contour = block.contours->contour(*first, *last);
  if (contour.problem.empty() && !contour.blocks.empty()) return contour;
  fail_contour(block, code, contour.problem.empty() ? "it has no moves" : contour.problem);
  return std::nullopt;
}

std::vector<PlaneMove> moves_of_contour(ActiveBlock& block, CodeNumber code,
                                        const Contour& contour) {
  return plane_moves(block, code, commands_of(block, contour, block.modal));
}

void take_settings(ActiveBlock& block, CodeNumber code) {
  const bool turning = code == g(71);
  RoughingSettings& settings =
      turning ? block.modal.cycles.turning_roughing : block.modal.cycles.facing_roughing;
  const char depth = turning ? 'U' : 'W';
  if (block.has(depth)) settings.depth = block.length(depth);
  if (block.has('R')) settings.retract = block.length('R');
  if (settings.depth > 0.0 && settings.retract >= 0.0) return;
  const char letter = settings.depth > 0.0 ? 'R' : depth;
  block.fail(block.has(letter) ? "E4008" : "E4007",
             {block.has(letter) ? letter : 'G', block.has(letter) ? -1 : code, {}},
             letter == 'R' ? "the retract must not be negative"
                           : std::string("`") + letter + "`, the depth of cut, must be positive",
             "");
}

// G71 P Q U W D F: one line, as Haas and older Fanuc controls have it. The depth D is a radius; the
// tool goes back by what a block with R said, or a millimetre.
bool take_depth_of_line(ActiveBlock& block, CodeNumber code) {
  if (!block.has('D')) return true;
  constexpr double retract_mm = 1.0;
  RoughingSettings& settings =
      code == g(71) ? block.modal.cycles.turning_roughing : block.modal.cycles.facing_roughing;
  settings.depth = value_or_thousandths(block, 'D') * block.length_unit();
  if (settings.retract <= 0.0) settings.retract = retract_mm;
  if (settings.depth > 0.0) return true;
  block.fail("E4008", {'D', -1, {}}, "`D`, the depth of cut, must be positive", "");
  return false;
}

// The allowance of a contour: U a diameter in diameter mode, W.
TurningPoint allowance_of(const ActiveBlock& block) {
  const double across = block.modal.diameters() ? 0.5 : 1.0;
  return {block.has('U') ? across * block.length('U') : 0.0,
          block.has('W') ? block.length('W') : 0.0};
}

// A contour that stands behind its cycle is not run again.
void pass_contour(ActiveBlock& block, const Contour& contour) {
  if (contour.blocks.front().origin.line <= block.line) return;
  block.flow.kind = Flow::behind_line;
  block.flow.line = contour.blocks.back().origin.line;
}

void rough(ActiveBlock& block, CodeNumber code, CycleMoves& moves, const Contour& contour) {
  const bool turning = code == g(71);
  const RoughingSettings& settings =
      turning ? block.modal.cycles.turning_roughing : block.modal.cycles.facing_roughing;
  std::vector<PlaneMove> list = moves_of_contour(block, code, contour);
  if (block.failed()) return;
  const TurningPoint allowance = allowance_of(block);
  const PassAxis along = turning ? PassAxis::z : PassAxis::x;
  TurnedContour turned(list, moves.position(), allowance, along);
  // A contour may end with a rapid back to where it began: nothing is cut there.
  while (!turned.problem().empty() && list.size() > 1 && list.back().rapid) {
    list.pop_back();
    turned = TurnedContour(list, moves.position(), allowance, along);
  }
  if (!turned.problem().empty()) {
    return fail_contour(block, code,
                        turned.problem() + ", see line " + std::to_string(turned.problem_line()));
  }
  if (turned.deepest() / settings.depth > levels_max) {
    block.fail("E4063", {'G', code, {}}, "the depth of cut results in too many passes",
               "too small");
    return;
  }
  Roughing roughing(moves, turned, settings);
  roughing.cut_levels();
  roughing.follow(list, allowance);
}

// First block of G73: U and W, the way from the last pass to the first one (U a radius), R passes.
void take_repeating_settings(ActiveBlock& block) {
  RepeatingSettings& settings = block.modal.cycles.repeating;
  if (block.has('U')) settings.relief_x = block.length('U');
  if (block.has('W')) settings.relief_z = block.length('W');
  if (!block.has('R')) return;
  if (const auto passes = block.integer('R', 1, roughing_passes_max)) settings.passes = *passes;
}

// G73 P Q I K D: one line, as Haas has it. I (a radius) and K are the way from the last pass to the
// first one, D is how many there are. Source: Haas lathe operator's manual, G73.
void take_passes_of_line(ActiveBlock& block) {
  RepeatingSettings& settings = block.modal.cycles.repeating;
  settings.relief_x = block.has('I') ? block.length('I') : 0.0;
  settings.relief_z = block.has('K') ? block.length('K') : 0.0;
  if (const auto passes = block.integer('D', 1, roughing_passes_max)) settings.passes = *passes;
}

// One pass along the contour, shifted; it begins at the start point shifted in the same way.
void follow_shifted(CycleMoves& moves, const std::vector<PlaneMove>& list, TurningPoint start,
                    TurningPoint shift) {
  const auto shifted = [&](TurningPoint p) { return TurningPoint{p.x + shift.x, p.z + shift.z}; };
  moves.rapid(shifted(start));
  for (const PlaneMove& move : list) {
    if (move.rapid) {
      moves.rapid(shifted(move.end));
    } else if (move.arc) {
      moves.arc({shifted(move.end), shifted(move.centre), move.counter_clockwise});
    } else {
      moves.feed(shifted(move.end));
    }
  }
}

void repeat_pattern(ActiveBlock& block, CodeNumber code, CycleMoves& moves,
                    const Contour& contour) {
  const RepeatingSettings& settings = block.modal.cycles.repeating;
  const std::vector<PlaneMove> list = moves_of_contour(block, code, contour);
  if (block.failed()) return;
  if (static_cast<double>(list.size()) * settings.passes > levels_max) {
    block.fail("E4063", {'G', code, {}}, "R results in too many passes", "too many");
    return;
  }
  const TurningPoint allowance = allowance_of(block);
  const TurningPoint start = moves.position();
  for (int n = 1; n <= settings.passes; ++n) {
    const double part = settings.passes == 1 ? 0.0 : 1.0 - (n - 1.0) / (settings.passes - 1.0);
    follow_shifted(
        moves, list, start,
        {allowance.x + part * settings.relief_x, allowance.z + part * settings.relief_z});
  }
  moves.rapid(start);
}

void repeat_contour(ActiveBlock& block, CodeNumber code) {
  block.kept_groups |= group_bit(Group::motion);
  auto moves = CycleMoves::of(block, code);
  if (!moves) return;
  const bool in_one_line = block.words.rules.is_haas() && block.has('D');
  if (block.programmed != 0 || (block.has('K') && !in_one_line) || block.has('L')) {
    block.fail("E4003", {'G', code, {}}, "pattern repeating does not use axis words, K and L",
               "unused word");
    return;
  }
  if (in_one_line) take_passes_of_line(block);
  if (!block.has('P') && !block.has('Q')) return take_repeating_settings(block);
  refuse_words(block, "R");
  if (block.failed()) return;
  if (block.modal.cycles.repeating.passes == 0) {
    block
        .fail("E4007", {'G', code, {}}, "the number of passes is not known",
              "no earlier block gives it")
        .help.emplace_back("program a block `G73 U8 W2 R5` first");
    return;
  }
  const auto contour = find_contour(block, code);
  if (!contour) return;
  repeat_pattern(block, code, *moves, *contour);
  if (!block.failed()) pass_contour(block, *contour);
}

constexpr double profile_levels_max = 10000.0;
constexpr int finishing_roughing_passes_max = 1000;
constexpr double usual_increment = 1.0;  // in units of the program, as the manual has them
constexpr double usual_retract = 0.5;

// What there is to cut lies on this side of the profile.
struct ProfileSide {
  PassAxis along = PassAxis::z;
  double towards = 1.0;  // from the profile to the tool, along the other axis
};

double across(TurningPoint p, PassAxis along) {
  return along == PassAxis::z ? p.x : p.z;
}

struct Reach {
  double low = 0.0;
  double high = 0.0;
};

Reach reach_across(const std::vector<PlaneMove>& profile, PassAxis along) {
  Reach reach{across(profile.front().end, along), across(profile.front().end, along)};
  for (const PlaneMove& move : profile) {
    reach.low = std::min(reach.low, across(move.end, along));
    reach.high = std::max(reach.high, across(move.end, along));
  }
  return reach;
}

// Where the tool stands beyond all of the profile; nothing: nowhere.
std::optional<ProfileSide> side_of(const std::vector<PlaneMove>& profile, TurningPoint tool,
                                   PassAxis along) {
  const Reach reach = reach_across(profile, along);
  if (across(tool, along) >= reach.high - same_point) return ProfileSide{along, 1.0};
  if (across(tool, along) <= reach.low + same_point) return ProfileSide{along, -1.0};
  return std::nullopt;
}

// Left of the profile, seen in its direction in the plane of Z and X.
bool is_left(const std::vector<PlaneMove>& profile, const ProfileSide& side) {
  const TurningPoint first = profile.front().end;
  const TurningPoint last = profile.back().end;
  const double ahead = side.along == PassAxis::z ? last.z - first.z : first.x - last.x;
  return ahead * side.towards > 0.0;
}

class Profile {
 public:
  Profile(ActiveBlock& block, CodeNumber code) : block_(block), code_(code) {}

  // False, with the block failed, where the subprogram is no profile.
  bool read() {
    if (!block_.has('Q')) {
      block_.fail("E4007", {'G', code_, {}},
                  "`" + code_text('G', code_) + "` needs Q, the subprogram of the profile", "no Q");
      return false;
    }
    const auto number = block_.integer('Q', 1, 99999999);
    if (!number) return false;
    if (block_.contours == nullptr) {
      fail_contour(block_, code_, "a contour cannot hold a contour cycle");
      return false;
    }
    const Contour contour = block_.contours->o_subprogram(*number);
    if (!contour.problem.empty()) {
      fail_contour(block_, code_, contour.problem);
      return false;
    }
    made_ = commands_of(block_, contour, block_.modal);
    moves_ = plane_moves(block_, code_, made_);
    for (PlaneMove& move : moves_) move.rapid = false;
    if (!block_.failed() && moves_.size() < 2)
      fail_contour(block_, code_,
                   "its first block leads to the profile, and another one must follow");
    return !block_.failed();
  }

  [[nodiscard]] const std::vector<PlaneMove>& moves() const { return moves_; }

  // The parallel of the profile at a distance on the side where the tool is; empty, with the block
  // failed, where there is none.
  [[nodiscard]] std::vector<PlaneMove> at_distance(double distance_mm, const ProfileSide& side) {
    if (distance_mm == 0.0) return moves_;
    const bool left = is_left(moves_, side) == (distance_mm > 0.0);
    CompensationStage stage(block_.channel_words);
    StageResult fault = stage.select(
        {.side = left ? RadiusCompensation::Side::left : RadiusCompensation::Side::right,
         .plane = Plane::zx,
         .orientation = 0,
         .radius_mm = std::abs(distance_mm),
         .arc_leads_in = false},
        block_.modal.position_W);
    ContourCommands parallel;
    const auto take_ready = [&] {
      Command command;
      while (!stage.ready().empty()) {
        stage.ready().take(command);
        parallel.commands.push_back(command);
      }
    };
    for (const Command& programmed : made_.commands) {
      if (move_of(programmed.payload) == nullptr || fault) continue;
      Command command = programmed;
      fault = stage.take(command);
      take_ready();
    }
    if (!fault) fault = stage.finish();
    take_ready();
    if (fault) {
      fail_contour(block_, code_,
                   "it has no parallel contour at that distance, see line " +
                       std::to_string(fault->origin.line) + ": " + fault->fault.message);
      return {};
    }
    std::vector<PlaneMove> moves = plane_moves(block_, code_, parallel);
    for (PlaneMove& move : moves) move.rapid = false;
    return moves;
  }

 private:
  ActiveBlock& block_;
  CodeNumber code_;
  ContourCommands made_;
  std::vector<PlaneMove> moves_;
};

double length_or(const ActiveBlock& block, char letter, double usual) {
  return block.has(letter) ? block.length(letter) : usual * block.length_unit();
}

bool is_positive(ActiveBlock& block, char letter, double value) {
  if (value > 0.0) return true;
  block.fail("E4008", {letter, -1, {}}, std::string("`") + letter + "` must be above zero", "");
  return false;
}

// To the start point that the block names.
TurningPoint go_to_start(CycleMoves& moves) {
  const TurningPoint start = moves.programmed_end();
  moves.rapid(start);
  return start;
}

void fail_start(ActiveBlock& block, CodeNumber code) {
  fail_contour(
      block, code,
      "the tool starts beside the profile; give a start point X Z beyond the whole profile");
}

}  // namespace

void drill_or_repeat(ActiveBlock& block, CodeNumber code) {
  if (block.channel.kind != ChannelKind::lathe) return drill_hole(block, code);
  repeat_contour(block, code);
}

void rough_contour(ActiveBlock& block, CodeNumber code) {
  if (block.channel.kind != ChannelKind::lathe) return refuse_words(block, "PQRUWD");
  auto moves = CycleMoves::of(block, code);
  if (!moves) return;
  const bool only_settings = !block.has('P') && !block.has('Q');
  refuse_words(block, !only_settings ? "R" : code == g(71) ? "DW" : "DU");
  if (block.failed() || !take_depth_of_line(block, code)) return;
  if (only_settings) return take_settings(block, code);
  const RoughingSettings& settings =
      code == g(71) ? block.modal.cycles.turning_roughing : block.modal.cycles.facing_roughing;
  if (settings.depth <= 0.0) {
    block
        .fail("E4007", {'G', code, {}}, "the depth of cut is not known",
              "no earlier block gives it")
        .help.push_back(code == g(71) ? "program a block `G71 U2 R0.5` first"
                                      : "program a block `G72 W2 R0.5` first");
    return;
  }
  const auto contour = find_contour(block, code);
  if (!contour) return;
  rough(block, code, *moves, *contour);
  if (!block.failed()) pass_contour(block, *contour);
}

// The blocks themselves are run, with all they do; then the tool comes back.
void finish_contour(ActiveBlock& block, CodeNumber code) {
  if (block.channel.kind != ChannelKind::lathe) return refuse_words(block, "PQRUW");
  // Those of roughing in a line with G70 say nothing on controls of Haas.
  if (!block.words.rules.is_haas()) refuse_words(block, "UW");
  const auto contour = find_contour(block, code);
  if (!contour || block.failed()) return;
  for (const Contour::Block& one : contour->blocks) {
    const bool nested = std::any_of(one.words.g.begin(), one.words.g.end(), [](CodeNumber number) {
      return number >= g(70) && number <= g(73);
    });
    if (nested) return fail_contour(block, code, "a contour cannot hold a contour cycle");
  }
  block.flow.kind = Flow::run_contour;
  block.flow.contour_line = contour->blocks.front().origin.line;
  block.flow.line = contour->blocks.back().origin.line;
}

void rough_profile(ActiveBlock& block, CodeNumber code) {
  auto moves = CycleMoves::of(block, code);
  if (!moves) return;
  const bool turning = code < g(72);
  const RoughingSettings settings{length_or(block, 'I', usual_increment),
                                  length_or(block, 'R', usual_retract)};
  if (!is_positive(block, 'I', settings.depth)) return;
  if (block.has('R') && block.value('R') != 0.0 && !is_positive(block, 'R', settings.retract))
    return;
  Profile profile(block, code);
  const TurningPoint start = go_to_start(*moves);
  if (!profile.read()) return;
  const PassAxis along = turning ? PassAxis::z : PassAxis::x;
  const auto side = side_of(profile.moves(), start, along);
  if (!side) return fail_start(block, code);
  std::vector<PlaneMove> list =
      profile.at_distance(block.has('D') ? block.length('D') : 0.0, *side);
  if (block.failed()) return;
  TurnedContour contour(list, start, {}, along);
  const bool leaves_pockets = code == g(71, 1) || code == g(72, 1);
  if (contour.problem().empty() && leaves_pockets) {
    list = contour.without_pockets();
    contour = TurnedContour(list, start, {}, along);
  }
  if (!contour.problem().empty()) {
    return fail_contour(block, code,
                        contour.problem() + ", see line " + std::to_string(contour.problem_line()));
  }
  if (contour.deepest() / settings.depth > profile_levels_max) {
    block.fail("E4063", {'I', -1, {}}, "`I` results in too many passes", "too small");
    return;
  }
  const bool pockets_alone = code == g(71, 2) || code == g(72, 2);
  Roughing roughing(*moves, contour, settings);
  roughing.cut_levels(pockets_alone ? PassChoice::pockets : PassChoice::all);
  roughing.follow(list, {}, EndOfRoughing::over_its_end);
}

void finish_profile(ActiveBlock& block, CodeNumber code) {
  auto moves = CycleMoves::of(block, code);
  if (!moves) return;
  const auto passes = block.has('P') ? block.integer('P', 1, finishing_roughing_passes_max) : 1;
  if (!passes) return;
  Profile profile(block, code);
  const TurningPoint start = go_to_start(*moves);
  if (!profile.read()) return;
  auto side = side_of(profile.moves(), start, PassAxis::z);
  if (!side) side = side_of(profile.moves(), start, PassAxis::x);
  if (!side) return fail_start(block, code);
  const double first = block.has('D') ? block.length('D') : 0.0;
  const double last = block.has('E') ? block.length('E') : 0.0;
  for (int pass = *passes; pass >= 1; --pass) {
    const double distance = (pass - 1) * (first - last) / *passes + last;
    const std::vector<PlaneMove> list = profile.at_distance(distance, *side);
    if (block.failed()) return;
    if (pass != *passes) moves->rapid(start);
    // Beside the profile first, then to where it begins.
    const TurningPoint begin = list.front().end;
    const bool z_first = side->along == PassAxis::z;
    moves->rapid(z_first ? TurningPoint{start.x, begin.z} : TurningPoint{begin.x, start.z});
    moves->rapid(begin);
    for (std::size_t k = 1; k < list.size(); ++k) {
      if (list[k].arc) {
        moves->arc({list[k].end, list[k].centre, list[k].counter_clockwise});
      } else {
        moves->feed(list[k].end);
      }
    }
  }
}

}  // namespace stanok::lang
