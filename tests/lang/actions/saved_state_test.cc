// The modal state saved and restored: M70 to M73, save_gvector, restore_gvector.
#include "lang/actions/saved_state.h"

#include <random>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class SavedStates : public ProgramTest {
 protected:
  std::mt19937 random{70};

  double number() {
    return std::ldexp(std::uniform_real_distribution<double>(-1.0, 1.0)(random),
                      std::uniform_int_distribution<int>(-30, 30)(random));
  }
  bool chance() { return std::uniform_int_distribution<int>(0, 1)(random) == 1; }

  void turn(ModalState& state) {
    state.set(Group::rotation, 680, 0);
    ProgrammedRotation& turned = state.frames.rotation;
    turned = {{}, {number(), number(), 1.0}, number(), {number(), number(), number()}};
    turned.rotation = Rotation::about(vector3(turned.axis), turned.angle_deg);
  }

  // A state as programs leave it, every field set.
  ModalState random_state() {
    ModalState state = default_modal_state(chance() ? ChannelKind::mill : ChannelKind::lathe);
    const std::pair<Group, std::vector<CodeNumber>> choices[] = {
        {Group::motion, {0, 10, 20, 810}},     {Group::plane, {170, 180, 190}},
        {Group::distance, {900, 910}},         {Group::arc_distance, {901, 911}},
        {Group::feed_mode, {930, 940, 950}},   {Group::units, {200, 210}},
        {Group::return_level, {980, 990}},     {Group::work_offset, {540, 550, 593, 541}},
        {Group::path_mode, {610, 611, 640}},   {Group::diameter, {70, 80}},
        {Group::length, {430, 434, 440, 490}}, {Group::spindle, {30, 40, 50}},
        {Group::override_control, {480, 490}}};
    for (const auto& [group, codes] : choices) {
      state.set(group,
                codes[std::uniform_int_distribution<std::size_t>(0, codes.size() - 1)(random)], 0);
    }
    for (bool* const flag :
         {&state.feed.known, &state.spindles.any_runs, &state.switches.mist, &state.switches.flood,
          &state.switches.feed_override, &state.frames.axis_shift_active}) {
      *flag = chance();
    }
    state.feed.programmed = number();
    state.feed.mm = number();
    state.spindles.speed_rev_per_min = number();
    state.path.tolerance_mm = number();
    state.tool.active = std::uniform_int_distribution<int>(0, 99999)(random);
    state.tool.length.tool = state.tool.active;
    for (double& part : state.tool.length.offset_mm) part = number();
    state.frames.work_offset_number = std::uniform_int_distribution<int>(1, 309)(random);
    for (double& shift : state.frames.local_shift) shift = number();
    for (double& shift : state.frames.axis_shift) shift = number();
    state.tool.overhang_axis = std::uniform_int_distribution<int>(-1, axes_max - 1)(random);
    state.tool.overhang_shift_mm = number();
    state.tool.turning = static_cast<TurningWay>(std::uniform_int_distribution(0, 2)(random));
    state.set(Group::spindle_mode, chance() ? 960 : 970, 0);
    state.spindles.cutting_speed_m_per_min = number();
    state.spindles.speed_limit_rev_per_min = number();
    if (chance()) turn(state);
    if (chance())
      state.frames.set_up.set({number(), number(), number()}, {number(), number(), 0.5});
    state.frames.is_carried = chance();
    if (chance()) state.map.scale(1, number(), 1.0 + std::abs(number()));
    if (chance()) state.map.mirror(0, number());
    return state;
  }
};

TEST_F(SavedStates, AreTheSameAfterTheirText) {
  for (int n = 0; n < 500; ++n) {
    const ModalState state = random_state();
    const std::string text = saved_state_text(state, state_all);
    const auto read = read_saved_state(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(read->parts, state_all);
    for (const Group group : {Group::motion, Group::plane, Group::feed_mode, Group::work_offset,
                              Group::path_mode, Group::length, Group::spindle}) {
      EXPECT_EQ(read->state.code(group), state.code(group)) << text;
    }
    EXPECT_EQ(read->state.feed.programmed, state.feed.programmed);
    EXPECT_EQ(read->state.feed.known, state.feed.known);
    EXPECT_EQ(read->state.spindles.speed_rev_per_min, state.spindles.speed_rev_per_min);
    EXPECT_EQ(read->state.path.tolerance_mm, state.path.tolerance_mm);
    EXPECT_EQ(read->state.tool.active, state.tool.active);
    EXPECT_EQ(read->state.tool.length.offset_mm, state.tool.length.offset_mm);
    EXPECT_EQ(read->state.frames.local_shift, state.frames.local_shift);
    EXPECT_EQ(read->state.frames.axis_shift, state.frames.axis_shift);
    EXPECT_EQ(read->state.frames.axis_shift_active, state.frames.axis_shift_active);
    EXPECT_EQ(read->state.tool.turning, state.tool.turning);
    EXPECT_EQ(read->state.frames.set_up.shift, state.frames.set_up.shift);
    EXPECT_EQ(read->state.frames.set_up.rotation, state.frames.set_up.rotation);
    EXPECT_EQ(read->state.frames.is_carried, state.frames.is_carried);
    EXPECT_EQ(read->state.switches.mist, state.switches.mist);
    EXPECT_EQ(read->state.frames.rotation.rotation, state.frames.rotation.rotation);
    EXPECT_EQ(read->state.map.numbers(), state.map.numbers());
    EXPECT_EQ(saved_state_text(read->state, state_all), text);
    for (const char c : text) ASSERT_TRUE(c >= 0x20 && c < 0x7F);
  }
}

TEST_F(SavedStates, AreRefusedWhenOneCharacterOfTheTextIsWrong) {
  const std::string text = saved_state_text(random_state(), state_all);
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string damaged = text;
    damaged[i] = damaged[i] == '0' ? '1' : '0';
    EXPECT_FALSE(read_saved_state(damaged)) << i;
    EXPECT_FALSE(read_saved_state(text.substr(0, i))) << i;
  }
  EXPECT_FALSE(read_saved_state(text + " "));
}

TEST_F(SavedStates, ComeBackByFunctions) {
  tables.offsets[2] = {100.0, 0.0, 0.0};
  run("string kept = save_gvector (GV_MODAL + GV_FEED + GV_COOLANT);\n"
      "G1 G20 G91 G18 F3 G55 M8\nif (restore_gvector (kept)) { msg (\"back\"); }\n"
      "G4 P0.1\nX5\nM30\n");
  EXPECT_EQ(error.code, "");
  EXPECT_EQ(all<Message>().at(0).text, "back");
  ASSERT_EQ(all<Move>().size(), 1u);
  EXPECT_EQ(all<Move>()[0].kind, MoveKind::rapid);
  EXPECT_EQ(all<Move>()[0].end[0], 5.0);
  EXPECT_EQ(all<FrameChange>().back().work_offset, 1);
  EXPECT_FALSE(all<CoolantCommand>().back().flood);
  EXPECT_EQ(all<ProgramRequest>().size(), 1u);
}

TEST_F(SavedStates, DoNotChangeTheTool) {
  tables.tools[1] = {1, {0.0, 0.0, 10.0}, 1.0};
  const std::string text = "string kept = save_gvector (GV_ALL);\nT1 M6\n";
  EXPECT_EQ(messages(text + "if (restore_gvector (kept) == false) { msg (\"no\"); }\nM30\n"),
            Texts{"no"});
  EXPECT_EQ(error_code(text + "restore_gvector (kept);\nM30\n"), "E4014");
  EXPECT_EQ(error_code("restore_gvector (\"GV1;modal G0\");\nM30\n"), "E3022");
  EXPECT_EQ(error_code("string kept = save_gvector (64);\nM30\n"), "E3009");
}

TEST_F(SavedStates, BringConstantCuttingSpeedBack) {
  run("G96 S180 D2000 M3\nstring kept = save_gvector (GV_SPINDLE);\nG97 S500\n"
      "restore_gvector (kept);\nM30\n");
  EXPECT_EQ(error.code, "");
  const CuttingSpeedMode mode = all<CuttingSpeedMode>().back();
  EXPECT_TRUE(mode.constant);
  EXPECT_EQ(mode.speed_m_per_min, 180.0);
  EXPECT_EQ(mode.limit_rev_per_min, 2000.0);
}

TEST_F(SavedStates, HoldForTheirCallOnly) {
  EXPECT_EQ(messages("G91 F7\nO1 call\n(DEBUG,%d#<_incremental> #<_feed> #<_motion_mode>)\n"
                     "M70 G90\nO2 call\nM72\n(DEBUG,%d#<_incremental>)\nM30\n"
                     "O1 sub\nM73\nG90 F9\nG1 X1\nO1 endsub\n"
                     "O2 sub\nM70\nM71\nG91\nO2 endsub\n"),
            (Texts{"1 7 10", "1"}));
  EXPECT_EQ(error_code("M70\nO2 call\nM30\nO2 sub\nM72\nO2 endsub\n"), "E4014");
  EXPECT_EQ(error_code("M70\nM71\nM72\nM30\n"), "E4014");
}

TEST_F(SavedStates, ComeBackWithWhatTheMachineMustFollow) {
  run("S100 M3 M70\nS200 M4 M8 M49\nM72\nM30\n");
  EXPECT_EQ(error.code, "");
  const auto spindle = all<SpindleCommand>();
  ASSERT_EQ(spindle.size(), 7u);
  EXPECT_EQ(spindle[4].speed_rev_per_min, 100.0);
  EXPECT_EQ(spindle[5].action, SpindleAction::clockwise);
  EXPECT_TRUE(all<OverrideControl>().back().feed_enabled);
  EXPECT_FALSE(all<CoolantCommand>().back().flood);
}

}  // namespace
}  // namespace stanok::lang::testing
