"""The voltage of the DC link, which each answer of a drive brings."""
from recipe import Recipe, after, before, replaced, words_replaced

RECIPE = Recipe("A sensor of a drive", [
    after("drives/register_map.h", "  RegisterField temperature;     // deg C",
          "  RegisterField dc_link;         // V"),
    replaced("drives/register_map.h",
             "inline constexpr std::array<FieldOfMap, 13> read_fields = {&RegisterMap::status_word,",
             "inline constexpr std::array<FieldOfMap, 14> read_fields = {&RegisterMap::status_word,"),
    replaced("drives/register_map.h", """
                                                           &RegisterMap::temperature};
""", """
                                                           &RegisterMap::temperature,
                                                           &RegisterMap::dc_link};
"""),
    replaced("config/sections/register_section.cc", "constexpr std::array<Quantity, 17> quantities = {{",
             "constexpr std::array<Quantity, 18> quantities = {{"),
    after("config/sections/register_section.cc",
          '    {"temperature", &RegisterMap::temperature, "deg C", "temperature of the motor"},',
          '    {"dc_link", &RegisterMap::dc_link, "V", "voltage of the DC link"},'),
    after("drives/drive.h", "  double temperature_c = 0.0;", "  double dc_link_v = 0.0;"),
    after("drives/modbus/drive_registers.h", "  std::int32_t temperature = 0;", "  std::int32_t dc_link = 0;"),
    after("drives/modbus/drive_registers.cc", "  visit(map.temperature, &StatusBlock::temperature);",
          "  visit(map.dc_link, &StatusBlock::dc_link);"),
    after("drives/modbus/axis_exchange.cc",
          "  feedback_.temperature_c = map.temperature.value(answer.temperature);",
          "  feedback_.dc_link_v = map.dc_link.value(answer.dc_link);"),
    before("plant/drive/simulated_drive.cc", "constexpr unsigned one_lost_in = 5;", """
// Of a drive on 400 V, rectified: 400 V times the root of 2.
constexpr double dc_link_v = 565.0;

"""),
    after("plant/drive/simulated_drive.cc", """
      .temperature = map.temperature.saturated_increments(temperature_c_),
""", """
      .dc_link = map.dc_link.saturated_increments(dc_link_v),
"""),
    replaced("plant/drive/simulated_drive.cc", "          .temperature = word()};", """
          .temperature = word(),
          .dc_link = word()};
"""),
    after("daemon/report/drive_report.cc", '          {"temperature_c", feedback.temperature_c},',
          '          {"dc_link_v", feedback.dc_link_v},'),
    replaced("protocol/contract/result_shapes.cc", """
      "vibration_um":"number","vibration_hz":"number","temperature_c":"number",
      "referenced":"boolean","brake_closed":"boolean","home_switch":"boolean",
""", """
      "vibration_um":"number","vibration_hz":"number","temperature_c":"number",
      "dc_link_v":"number","referenced":"boolean","brake_closed":"boolean","home_switch":"boolean",
"""),
    after("panel/src/views/drives/DrivesView.svelte", """
              <th scope="col" class="number">{t('drives.temperature')}, °C</th>
""", """
              <th scope="col" class="number">{t('drives.dc_link')}, V</th>
"""),
    after("panel/src/views/drives/DrivesView.svelte", """
                <td class="number">{fixed(drive.temperature_c, 0)}</td>
""", """
                <td class="number">{fixed(drive.dc_link_v, 0)}</td>
"""),
    after("panel/src/text/english.ts", "  'drives.temperature': 'temperature',", "  'drives.dc_link': 'DC link',"),
    after("panel/src/text/russian.ts", "  'drives.temperature': 'температура',",
          "  'drives.dc_link': 'звено постоянного тока',"),
    words_replaced("docs/reference/protocol.md", '"temperature_c","referenced"',
                   '"temperature_c","dc_link_v","referenced"'),
    after("docs/reference/configuration.md",
          "| `temperature` | table | deg C | none | – | temperature of the motor |",
          "| `dc_link` | table | V | none | – | voltage of the DC link |"),
    after("tests/plant/register_map_loopback_test.cc",
          "  drive.map.temperature = {.address = 0x0005, .scale = 10.0, .offset = 400.0};",
          "  drive.map.dc_link = {.address = 0x0007, .scale = 8.0};"),
    after("tests/plant/register_map_loopback_test.cc",
          "  EXPECT_EQ(cycle.feedback[0].temperature_c, 22.0);",
          "  EXPECT_EQ(cycle.feedback[0].dc_link_v, 565.0);"),
])
