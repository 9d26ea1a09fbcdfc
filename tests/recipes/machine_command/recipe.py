"""program.flow, which the machine executes."""
from recipe import Recipe, after, before, replaced

RECIPE = Recipe("A command that the machine executes", [
    before("protocol/contract/methods_of_program.cc", '    {.name = "program.skip",', """
    {.name = "program.flow",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "continuous",
     .parameters = of_channel,
     .help = "end single block"},
"""),
    after("channels/contract/operator_command.h", "  program_retrace,", "  continuous,"),
    before("channels/contract/operator_command.h", "// The session that has the channel to itself.", """
// The program no longer stops after each block.
struct Continuous {};
"""),
    replaced("channels/contract/operator_command.h", """
    commands::FirstPart, commands::ProgramRetrace>;
""", """
    commands::FirstPart, commands::ProgramRetrace, commands::Continuous>;
"""),
    after("channels/contract/operator_action.cc", """
    {Action::program_retrace, "program_retrace", Effect::begins, Rule::interlude, Reach::channel},
""", """
    {Action::continuous, "continuous", Effect::none, Rule::always, Reach::channel},
"""),
    before("channels/coordinator/operator_desk.cc",
           "  Result operator()(const commands::BlockSkip& command) const RT_SAFE {", """
  Result operator()(const commands::Continuous& /*command*/) const RT_SAFE {
    return each([](Channel& c) RT_SAFE { c.set_single_block(Switch::off); });
  }
"""),
    after("daemon/desk/command_desk.cc", """
    notes.single_block = step->to == channels::Switch::on;
""", """
  if (std::holds_alternative<commands::Continuous>(command)) notes.single_block = false;
"""),
    after("tests/channels/contract/operator_command_test.cc", """
      {ProgramRetrace{RetraceDirection::forward, 2.5}, 36, "program_retrace", 1, 2.5},
""", """
      {Continuous{}, 37, "continuous"},
"""),
    replaced("tests/channels/contract/operator_command_test.cc",
             "  EXPECT_FALSE(command_of({.action = static_cast<OperatorAction>(37)}));",
             "  EXPECT_FALSE(command_of({.action = static_cast<OperatorAction>(38)}));"),
])
