// Probes that do not do what they should: the program ends before anything is written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "channels/contract/operator_command.h"
#include "tests/runtime/workpiece/measuring_bench.h"

namespace stanok::runtime {
namespace {

using ::testing::ElementsAre;

constexpr std::int64_t long_after = 40'000;  // cycles: every program here has ended

struct Fault {
  const char* name;
  void (*make)(MeasuringBench& bench);
  const char* blank;  // and what comes before the cycles
  const char* cycles;
  const char* code;
};

void nothing(MeasuringBench& /*bench*/) {}

// On while the axis is between the two.
void contact(MeasuringBench& bench, int axis, double from, double to) {
  bench.options.file.contacts.push_back({.input = 5, .axis = axis, .from = from, .to = to});
}

constexpr const char* block_of_faults = "#workpiece (0, 0.1, 0, 40, 30, 10, 20, 15, 10)\n";
constexpr const char* web_and_write =
    "measure_web (X, 40, -5);\nmeasure_write_offset (1);\nmeasure_write_wear_radius (2);\n";

class MeasuringFaults : public ::testing::TestWithParam<Fault> {};

// Work offset and wear are asked for by MDI behind the alarm.
TEST_P(MeasuringFaults, EndTheProgramAndNothingIsWritten) {
  const Fault& fault = GetParam();
  MeasuringBench bench;
  fault.make(bench);
  const auto event = [](std::int64_t cycle, channels::OperatorCommand command) {
    channels::OperatorEvent operator_event;
    operator_event.channel = 1;
    operator_event.command = command;
    return TimedEvent{cycle, operator_event};
  };
  const auto line = [&](std::int64_t cycle, std::string_view text) {
    return event(cycle, channels::commands::Mdi{channels::ShortText(text)});
  };
  bench.options.events = {
      event(long_after, channels::commands::ProgramReset{}),
      line(long_after + 100, "msg (\"x=\" + str (gettable_zs (1, 1, X), 7));"),
      line(long_after + 200, "msg (\"y=\" + str (gettable_zs (1, 1, Y), 7));"),
      line(long_after + 300, "msg (\"z=\" + str (gettable_zs (1, 1, Z), 7));"),
      line(long_after + 400, "msg (\"turn=\" + str (gettable_zs (1, 1, \"R\"), 7));"),
      line(long_after + 500, "msg (\"wear=\" + str (gettable_tool (2, 1, \"wear_radius\"), 7));"),
      line(long_after + 600, "msg (\"length=\" + str (gettable_tool (2, 1, \"wear_length\"), 7));"),
  };
  bench.run(std::string("#include \"measure/features.nc\"\n#include \"measure/edges.nc\"\n#include "
                        "\"measure/write.nc\"\n#include \"measure/tools.nc\"\n") +
            "settable_zs (1, 1, X, 0.5);\nsettable_zs (1, 1, \"R\", 0.25);\n" + fault.blank +
            fault.cycles + "msg (\"end=1\");\nM30\n");
  EXPECT_THAT(bench.alarms, ElementsAre(fault.code));
  EXPECT_EQ(bench.told.count("end"), 0U);
  EXPECT_EQ(bench.found("x"), 0.5);
  EXPECT_EQ(bench.found("y"), 0.0);
  EXPECT_EQ(bench.found("z"), 0.0);
  EXPECT_EQ(bench.found("turn"), 0.25);
  EXPECT_EQ(bench.found("wear"), 0.0);
  EXPECT_EQ(bench.found("length"), 0.0);
}

const std::string probe_over_block =
    std::string(block_of_faults) + "T9 M6\nG43\nG0 X0 Y0 Z30\nZ5\n";
const std::string probe_over_nothing = "T9 M6\nG43\nG0 X0 Y0 Z30\nZ5\n";
const std::string mill_over_block = std::string(block_of_faults) + "T2 M6\nG43\nG0 X0 Y0 Z30\nZ5\n";
const std::string mill_high = "T2 M6\nG43\nG0 X0 Y0 Z150\n";

constexpr const char* g37_at_the_setter = "G59.3\nG0 X0 Y0\nG37 Z0\n";

INSTANTIATE_TEST_SUITE_P(
    Probes, MeasuringFaults,
    ::testing::Values(
        Fault{"never_touches", nothing, probe_over_nothing.c_str(), web_and_write, "E4320"},
        Fault{"is_no_probe", nothing, mill_over_block.c_str(), web_and_write, "E4320"},
        Fault{"is_no_tool", nothing, "G0 X0 Y0 Z30\n", web_and_write, "U4323"},
        Fault{"is_on_all_the_time", [](MeasuringBench& bench) { contact(bench, 2, -1e3, 1e3); },
              probe_over_block.c_str(), web_and_write, "E4322"},
        Fault{"is_on_at_the_side",
              // X of the first touch, where it goes down.
              [](MeasuringBench& bench) { contact(bench, 0, 20.0, 60.0); },
              probe_over_block.c_str(), web_and_write, "U4324"},
        Fault{"touches_early_over_a_face",
              [](MeasuringBench& bench) { contact(bench, 2, -1e3, 113.0); },
              "T9 M6\nG43\nG0 X0 Y0 Z30\n",
              "measure_surface (Z, -20);\nmeasure_write_offset (1);\n", "U4325"},
        Fault{"has_no_input",
              [](MeasuringBench& bench) {
                bench.options.file.machine.channels[0].probe_input = -1;
                bench.options.file.simulation.setter.channel = 0;
              },
              probe_over_block.c_str(), web_and_write, "E4323"},
        Fault{"collides_on_its_way", nothing, probe_over_block.c_str(),
              "measure_bore (24, -5);\nmeasure_write_offset (1);\n", "U4324"},
        Fault{"is_out_of_tolerance", nothing, probe_over_block.c_str(),
              "measure_web (X, 39.9, -5);\nmeasure_demand (#<_measured_size>, 39.9, 0.05, "
              "\"width\");\nmeasure_write_offset (1);\n",
              "U4327"},
        Fault{"wants_too_much_wear", nothing, probe_over_block.c_str(),
              "measure_web (X, 38.9, -5);\nmeasure_write_wear_radius (2);\n", "U4329"},
        Fault{"writes_another_offset", nothing, probe_over_block.c_str(),
              "measure_web (X, 40, -5);\nmeasure_write_offset (2);\n", "U4328"},
        Fault{"writes_a_width_as_length", nothing, probe_over_block.c_str(),
              "measure_web (X, 39.9, -5);\nmeasure_write_tool_length ();\n", "U4328"},
        Fault{"lies_on_a_plane_that_is_none", nothing, probe_over_block.c_str(),
              "measure_web (X, 40, -5);\nmeasure_write_set_up ();\n", "U4328"},
        Fault{"writes_a_length_as_radius", nothing, mill_high.c_str(),
              "measure_tool_length ();\nmeasure_write_tool_radius ();\n", "U4328"},
        Fault{"writes_a_length_as_wear_of_the_radius", nothing, mill_high.c_str(),
              "measure_tool_length ();\nmeasure_write_wear_radius (2);\n", "U4328"},
        Fault{"tool_is_not_at_the_setter",
              [](MeasuringBench& bench) {
                bench.options.file.simulation.tools.push_back({.number = 2, .length = 60.0});
              },
              mill_high.c_str(), "measure_tool_length ();\nmeasure_write_tool_length ();\n",
              "E4320"},
        Fault{"setter_is_on", [](MeasuringBench& bench) { contact(bench, 2, -1e3, 1e3); },
              mill_high.c_str(), "measure_tool_length ();\nmeasure_write_tool_length ();\n",
              "E4322"},
        Fault{"g37_touches_too_early",
              [](MeasuringBench& bench) {
                bench.options.file.simulation.tools.push_back({.number = 2, .length = 78.0});
              },
              mill_high.c_str(), g37_at_the_setter, "E4324"},
        Fault{"g37_never_touches",
              [](MeasuringBench& bench) {
                bench.options.file.simulation.tools.push_back({.number = 2, .length = 60.0});
              },
              mill_high.c_str(), g37_at_the_setter, "E4320"},
        Fault{"g37_is_on", [](MeasuringBench& bench) { contact(bench, 2, -1e3, 1e3); },
              mill_high.c_str(), g37_at_the_setter, "E4322"},
        Fault{"setter_is_on_at_the_look_for_a_break",
              [](MeasuringBench& bench) { contact(bench, 2, -1e3, 1e3); }, mill_high.c_str(),
              "if (measure_is_broken (0.5)) { msg (\"broken=1\"); }\n", "E4322"}),
    [](const auto& fault) { return std::string(fault.param.name); });

// Outside of a tolerance the program may also leave something out.
TEST(MeasuringTolerance, CanBeAskedFor) {
  MeasuringBench bench;
  bench.run_to_end(
      "#include \"measure/features.nc\"\n#include \"measure/write.nc\"\n" + probe_over_block +
      "measure_web (X, 39.9, -5);\nif (measure_is_within (#<_measured_size>, 39.9, 0.05)) { msg "
      "(\"good=1\"); } else { msg (\"good=0\"); }\nif (measure_is_within (#<_measured_size>, 39.9, "
      "0.11)) { msg (\"fair=1\"); }\nM30\n");
  EXPECT_EQ(bench.found("good"), 0.0);
  EXPECT_EQ(bench.found("fair"), 1.0);
}

}  // namespace
}  // namespace stanok::runtime
