// What force control needs of the machine: [process] of the machine file.
#pragma once

namespace stanok::process {

enum class SensorFault { hold, feed_min };  // what the feed does without a trustworthy power

struct ForceControlConfig {
  // Clamps where a program gives none.
  double feed_min = 0.0;  // S_min, mm/s; 0: a twentieth of the programmed feed
  double feed_max = 0.0;  // S_max, mm/s; 0: the programmed feed

  // Spindle drive and its power sensor, blocks 7 to 9.
  double efficiency = 1.0;         // of the power that cuts
  double power_lag_s = 0.03;       // first-order lag of the sensor, with half a poll of its bus
  double idle_settle_s = 0.3;      // at speed, before the idle power is taken
  double idle_capture_s = 0.2;     // over which it is averaged
  double idle_coulomb_part = 0.5;  // of the idle power at speed that grows with n; the rest: n^2
  double power_min_w = 0.0;        // below it the power says nothing of the force
  double air_part = 0.1;           // of N_z: with less power the tool is in the air
  double power_answer_s = 0.0;     // to a change of the feed, beyond chip and lags
  double air_time_s = 5.0;         // longest air cut: beyond it the missing force is told
  double lighter_max = 0.09;       // part by which the cut may become lighter than it was
  double feed_step = 0.1;          // part by which the feed rises before the power has answered
  bool asks_downwards = true;      // once a minute, by less feed, whether the power answers
  int gaps_per_turn = 0;           // of an interrupted cut; 0: they are looked for
  SensorFault on_sensor_fault = SensorFault::hold;

  // Feed controller, block 14.
  double gain = 0.35;           // open loop gain times dead time; 1/e has no overshoot
  double feed_exponent = 0.75;  // y of P_z = C t S^y
  double feed_lag_s = 0.0;      // of the feed drives

  // Vibration, blocks 16 to 21.
  double vibration_level_um = 0.0;   // permissible; 0: vibration does not act
  double vibration_release = 0.8;    // of the level: below it the amplifier is quiet again
  double reduced_mass_kg = 0.0;      // m_d
  double oscillation_hz = 0.0;       // f of the automatic oscillation
  double oscillation_reserve = 1.1;  // of P_osc over equation (2)
};

}  // namespace stanok::process
