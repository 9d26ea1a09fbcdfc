// Made from openrpc.json by tools/client.mjs: do not change it by hand.

export interface Methods {
  /** switch on the drives of all axes that are not parked */
  "machine.on": {
    params: {
      seen_cycle?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** stop all channels and switch the drives off */
  "machine.off": {
    params: Record<string, never>;
    result: {
      accepted: boolean;
    };
  };
  /** STOP ALL (not the E-stop): stop immediately along the path, then switch the drives off; always accepted */
  "machine.estop": {
    params: Record<string, never>;
    result: {
      accepted: boolean;
    };
  };
  /** list the commands of operators and the starts and ends of the daemon: the newest 2000 entries, including those from before the last start */
  "machine.journal": {
    params: Record<string, never>;
    result: {
      error: string | null;
      records: {
        at: number;
        by?: string;
        kind: string;
        method?: string;
        outcome?: string;
        parameters?: unknown;
        session?: number;
        text?: string;
        version?: string;
      }[];
    };
  };
  /** show cycle, drives, real-time figures, and the state of every channel */
  "machine.status": {
    params: Record<string, never>;
    result: {
      age_ms: number;
      channels: {
        id: number;
        name: string;
        program_status: string;
        state: string;
      }[];
      cycle: number;
      cycle_us: number;
      drives: string;
      idle: boolean;
      log_lines_lost: number;
      machine_time_s: number;
      name: string;
      on: boolean;
      outputs_lost: number;
      real_time: {
        memory_locked: boolean;
        notes: string[];
        scheduling: string;
      };
      replies_lost: number;
      rt: {
        cycle_us: {
          max: number;
          p50: number;
          p90?: number;
          p99: number;
          p999: number;
        };
        latency_us: {
          max: number;
          p50: number;
          p90?: number;
          p99: number;
          p999: number;
        };
        overruns: number;
        periods_skipped: number;
      };
    };
  };
  /** list the channels with kind, axes, scheme and state */
  "channel.list": {
    params: Record<string, never>;
    result: {
      channels: {
        axes: string[];
        id: number;
        kind: string;
        name: string;
        program_status: string;
        scheme: number;
        state: string;
        travel: unknown[];
        words: string[];
      }[];
    };
  };
  /** show state, program, block, position, feed and overrides of a channel */
  "channel.status": {
    params: {
      channel?: number;
    };
    result: {
      age_ms: number;
      alarm: {
        acknowledged?: boolean;
        at: number | null;
        channel: number;
        code: string;
        column: number | null;
        cycle: number;
        file: string | null;
        line: number | null;
        number: number;
        reaction: number | null;
        remedy: string | null;
        text: string;
      } | null;
      aside: boolean;
      axes: Record<string, {
        brake: boolean;
        enabled: boolean;
        position: number;
        takes_part: boolean;
        verified: boolean;
      }>;
      axis_names: string[];
      begins_at: string | null;
      block: number;
      block_skip: number[];
      controlled_by: string | null;
      coolant: string[];
      coolant_off: boolean;
      cycle: number;
      diameter: string[];
      feed_mm_min: number;
      feed_mm_rev: number;
      feed_mm_s: number;
      file: string | null;
      first_part: boolean;
      foreseen: {
        acknowledged?: boolean;
        at: number | null;
        channel: number;
        code: string;
        column: number | null;
        cycle: number;
        file: string | null;
        line: number | null;
        number: number;
        reaction: number | null;
        remedy: string | null;
        text: string;
      } | null;
      g_codes: string[];
      held_by: string | null;
      id: number;
      line: number;
      m_codes: string[];
      name: string;
      on_part: {
        direction: number[];
        machine: unknown;
        tip: number[];
        work: unknown;
      } | null;
      optional_stop: boolean;
      override: {
        feed: number;
        rapid: number;
        spindle: number;
      };
      planned_path: number | null;
      point_W: Record<string, number>;
      position: Record<string, number>;
      predicted_s: number | null;
      program: string | null;
      program_status: string;
      queue: {
        programs: number;
        started: boolean;
        version: number;
      };
      remaining_s: number | null;
      retrace: {
        blocks: number;
        line: number | null;
        to_line: number;
      };
      run: number;
      scheme: number;
      single_block: boolean;
      situation: number;
      speed_mm_min: number;
      speed_mm_s: number;
      spindles: ({
        actual_rev_min: number | null;
        commanded_rev_min: number;
        direction: string;
        id: number;
        power_w: number | null;
      })[];
      spindles_off: boolean;
      state: string;
      tap_in_hole: boolean;
      to_go: Record<string, number> | null;
      tool: {
        edge: number;
        name: string | null;
        number: number;
      };
      tool_direction: unknown;
      units: string;
      waits_for: {
        channels: number[];
        for: string;
        number: number | null;
      } | null;
      words: string[];
      work_offset: string | null;
    };
  };
  /** show the words that would lead to the present position of a channel, and how they are derived */
  "channel.position": {
    params: {
      why?: number;
      channel?: number;
    };
    result: {
      axes: {
        axis: string;
        machine: number;
        shown: number;
        terms?: {
          amount: number;
          fixed: boolean;
          name: string;
          of: string;
          term: string;
          value: number;
        }[];
        unit: string;
        word: string;
      }[];
      channel: number;
      diameter: string[];
      point_W: Record<string, number>;
      position: Record<string, number>;
      scheme: number;
      situation: number;
      units: string;
    };
  };
  /** take sole control of a channel until the connection ends; others can still stop it */
  "channel.control": {
    params: {
      on?: number;
      channel?: number;
    };
    result: {
      channel: number;
      controlled_by: string | null;
    };
  };
  /** show the status of a channel as it changes */
  "channel.watch": {
    params: {
      channel?: number;
      rate_hz?: number;
    };
    result: {
      rate_hz: number;
      topics: string[];
    };
  };
  /** read the text of a program and its version, at most 512 KiB at a time */
  "program.read": {
    params: {
      program: string;
      offset?: number;
    };
    result: {
      bytes: number;
      complete: boolean;
      exact: boolean;
      offset: number;
      program: string;
      text: string;
      version: string;
    };
  };
  /** write a program, completely or not at all, if nobody has changed it in the meantime */
  "program.write": {
    params: {
      program: string;
      text: string;
      version?: string;
      more?: number;
      file?: string;
    };
    result: {
      bytes: number;
      program: string;
      version: string | null;
    };
  };
  /** remove a program, if nobody has changed it in the meantime */
  "program.remove": {
    params: {
      program: string;
      version?: string;
    };
    result: {
      program: string;
    };
  };
  /** find errors and warnings of a program without running it, and the positions of the rotary axes in its tilted planes; another check on this connection cancels this one */
  "program.check": {
    params: {
      program: string;
      text?: string;
      channel?: number;
      file?: string;
    };
    result: {
      blocks: number;
      diagnostics: {
        code: string;
        column: number;
        end_column: number;
        end_line: number;
        file: string;
        help: string[];
        label: string;
        line: number;
        message: string;
        notes: unknown[];
        severity: string;
        stack: string[];
      }[];
      ok: boolean;
      program: string;
      tilted_planes: {
        axes: Record<string, number>;
        file: string;
        line: number;
        other?: {
          axes: Record<string, number>;
          limit?: number;
          word: string;
        };
        tool: number[];
      }[];
      version: string | null;
    };
  };
  /** draw the virtual workpiece as the program leaves it after a run on a virtual clock: `picture` is a PNG in base64, seen from the front, right and above, or null if the program declares no blank; a check on this connection cancels it */
  "program.picture": {
    params: {
      program: string;
      channel?: number;
    };
    result: {
      alarm: {
        acknowledged?: boolean;
        at: number | null;
        channel: number;
        code: string;
        column: number | null;
        cycle: number;
        file: string | null;
        line: number | null;
        number: number;
        reaction: number | null;
        remedy: string | null;
        text: string;
      } | null;
      blank_mm3: number | null;
      complete: boolean;
      findings: number | null;
      ok: boolean;
      picture: string | null;
      program: string;
      removed_mm3: number | null;
      time_s: number;
    };
  };
  /** find the time and path length of a program from a run on a virtual clock, with the present tables, schemes and positions and with overrides at 100 %; a check on this connection cancels it */
  "program.estimate": {
    params: {
      program: string;
      channel?: number;
    };
    result: {
      alarm: {
        acknowledged?: boolean;
        at: number | null;
        channel: number;
        code: string;
        column: number | null;
        cycle: number;
        file: string | null;
        line: number | null;
        number: number;
        reaction: number | null;
        remedy: string | null;
        text: string;
      } | null;
      complete: boolean;
      ok: boolean;
      program: string;
      runs: {
        blocks: number;
        channel: number;
        ok: boolean;
        path_mm: number;
        program: string;
        time_s: number;
      }[];
      time_s: number;
    };
  };
  /** cancel the check or estimate of this connection, which then answers E9017 */
  "program.check_cancel": {
    params: Record<string, never>;
    result: {
      accepted: boolean;
    };
  };
  /** read the planned path of the tool tip from the simulation of the loaded program: pages of points with the program lines that lead to them */
  "program.path": {
    params: {
      channel?: number;
      path?: number;
      page?: number;
      follow?: number;
      system?: "work" | "part";
    };
    result: {
      channel: number;
      complete: boolean;
      geometry: unknown;
      given_up: string | null;
      id: number | null;
      pages: number;
      part: {
        pose: number[];
        scheme: number;
      } | null;
      points: number;
      program: string | null;
      system: string;
    };
  };
  /** load and compile a program; errors are reported with file, line and column */
  "program.load": {
    params: {
      program: string;
      channel?: number;
      wait?: "accepted" | "done";
    };
    result: {
      accepted: boolean;
    };
  };
  /** load a program and start it */
  "program.run": {
    params: {
      program: string;
      channel?: number;
      wait?: "accepted" | "done";
      seen_cycle?: number;
    };
    result: {
      accepted?: boolean;
      blocks?: number;
      ok?: boolean;
      path_mm?: number;
      program?: string;
      time_s?: number;
    };
  };
  /** start the loaded program, or continue it if it is held */
  "program.start": {
    params: {
      channel?: number;
      wait?: "accepted" | "done";
      approach?: number;
      restore?: number;
      situation?: number;
      seen_cycle?: number;
    };
    result: {
      accepted?: boolean;
      blocks?: number;
      ok?: boolean;
      path_mm?: number;
      program?: string;
      time_s?: number;
    };
  };
  /** feed hold: stop along the path */
  "program.hold": {
    params: {
      channel?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** continue after a feed hold */
  "program.resume": {
    params: {
      channel?: number;
      seen_cycle?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** move the axes of a held program back to where it was held, the way that they came, jogged or along the path; first spindles and coolant are as the program left them */
  "program.return": {
    params: {
      velocity?: number;
      channel?: number;
      seen_cycle?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** move the axes of a held program back along its path, or forward again, at the programmed feed under the overrides: by an increment, or for 200 ms at a time */
  "program.retrace": {
    params: {
      direction: "back" | "forward";
      increment?: number;
      channel?: number;
      seen_cycle?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** stop the spindles of a held program, or let them turn again; they turn before the program continues */
  "program.spindles": {
    params: {
      on: number;
      channel?: number;
      seen_cycle?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** switch the coolant of a held program off, or on again; it is on before the program continues */
  "program.coolant": {
    params: {
      on: number;
      channel?: number;
      seen_cycle?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** hold the feed, then end the program without an alarm */
  "program.stop": {
    params: {
      channel?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** end the program and clear the alarms of the channel */
  "program.reset": {
    params: {
      channel?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** optional stop: set whether M1 stops the program */
  "program.optional_stop": {
    params: {
      on: number;
      channel?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** first part: rapid traverse keeps to 25 %, whatever the rapid override is */
  "program.first_part": {
    params: {
      on: number;
      channel?: number;
      seen_cycle?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** single block: stop after each block; `program start` begins the next one */
  "program.step": {
    params: {
      on: number;
      channel?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** skip the blocks of a level from the next sync point on */
  "program.skip": {
    params: {
      level: number;
      channel?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** execute the blocks of a level again */
  "program.unskip": {
    params: {
      level: number;
      channel?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** list the program files under the program root, with the times (Unix) of their last change, and of the last check and run since the daemon started */
  "program.list": {
    params: Record<string, never>;
    result: {
      complete: boolean;
      programs: ({
        bytes: number;
        changed_s: number;
        check_ok: boolean | null;
        checked_s: number | null;
        name: string;
        ran_s: number | null;
        run_ok: boolean | null;
      })[];
      root: string;
    };
  };
  /** list the newest 500 program runs of each channel, with their times and how they ended; cycles count from the last start of the daemon */
  "program.history": {
    params: {
      channel?: number;
    };
    result: {
      forgotten?: number;
      runs: ({
        begun_at: number | null;
        begun_cycle: number | null;
        blocks: number;
        channel: number;
        end: string | null;
        ended: boolean;
        ended_at: number | null;
        ended_cycle: number | null;
        longest_gap_ms: number;
        lost_periods: number;
        number: number;
        ok: boolean;
        path_mm: number;
        program: string;
        time_s: number;
      })[];
    };
  };
  /** block search: make the loaded program begin at this block when it is started; the answer shows what precedes the block */
  "program.search": {
    params: {
      target: string;
      pass?: number;
      calculation?: "with" | "without";
      channel?: number;
    };
    result: {
      approach?: {
        changes: string[];
        moves: ({
          feed_mm_min: number | null;
          kind: string;
          length_mm: number;
          to: Record<string, number>;
        })[];
        number: number;
      };
      calculated: boolean;
      target: string;
    };
  };
  /** set the feed override of a channel */
  "override.feed": {
    params: {
      percent: number;
      channel?: number;
      seen_cycle?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** set the rapid override of a channel */
  "override.rapid": {
    params: {
      percent: number;
      channel?: number;
      seen_cycle?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** set the spindle override of a channel */
  "override.spindle": {
    params: {
      percent: number;
      channel?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** list the waiting programs of one channel or of all, and what stopped a queue */
  "queue.list": {
    params: {
      channel?: number;
    };
    result: {
      queues: ({
        channel: number;
        programs: {
          id: number;
          program: string;
        }[];
        started: boolean;
        started_by: string | null;
        stopped_by: string | null;
        under_way: number | null;
      })[];
    };
  };
  /** add a program to the end of the queue of a channel */
  "queue.add": {
    params: {
      program: string;
      channel?: number;
    };
    result: {
      queues: ({
        channel: number;
        programs: {
          id: number;
          program: string;
        }[];
        started: boolean;
        started_by: string | null;
        stopped_by: string | null;
        under_way: number | null;
      })[];
    };
  };
  /** remove a program from the queue, unless it is in progress */
  "queue.remove": {
    params: {
      id: number;
      channel?: number;
    };
    result: {
      queues: ({
        channel: number;
        programs: {
          id: number;
          program: string;
        }[];
        started: boolean;
        started_by: string | null;
        stopped_by: string | null;
        under_way: number | null;
      })[];
    };
  };
  /** move a program to another position in the queue */
  "queue.move": {
    params: {
      id: number;
      place: number;
      channel?: number;
    };
    result: {
      queues: ({
        channel: number;
        programs: {
          id: number;
          program: string;
        }[];
        started: boolean;
        started_by: string | null;
        stopped_by: string | null;
        under_way: number | null;
      })[];
    };
  };
  /** run the programs of the queue one after the other, until one fails, an alarm occurs, or somebody stops or resets something or takes the channel */
  "queue.start": {
    params: {
      channel?: number;
      seen_cycle?: number;
    };
    result: {
      queues: ({
        channel: number;
        programs: {
          id: number;
          program: string;
        }[];
        started: boolean;
        started_by: string | null;
        stopped_by: string | null;
        under_way: number | null;
      })[];
    };
  };
  /** start no further program of the queue; the one in progress continues */
  "queue.stop": {
    params: {
      channel?: number;
    };
    result: {
      queues: ({
        channel: number;
        programs: {
          id: number;
          program: string;
        }[];
        started: boolean;
        started_by: string | null;
        stopped_by: string | null;
        under_way: number | null;
      })[];
    };
  };
  /** list the kinematic schemes of a channel */
  "kinematics.list": {
    params: {
      channel?: number;
    };
    result: {
      channel: number;
      schemes: ({
        active: boolean;
        axes: string[];
        file: string | null;
        id: number;
        type: string;
      })[];
    };
  };
  /** switch a channel to another kinematic scheme; the channel must be idle */
  "kinematics.select": {
    params: {
      scheme: number;
      channel?: number;
      seen_cycle?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** show the active scheme, its axes, and their drives and brakes */
  "kinematics.status": {
    params: {
      channel?: number;
    };
    result: {
      axes: {
        brake: boolean;
        enabled: boolean;
        name: string;
        takes_part: boolean;
      }[];
      channel: number;
      scheme: number;
      type: string | null;
    };
  };
  /** list the drives of the machine file with bus address, kind and requests per exchange */
  "drive.list": {
    params: Record<string, never>;
    result: {
      bus: string;
      drives: ({
        absolute_encoder: boolean;
        axis: string;
        kind: string;
        position_scale: number;
        requests: number;
        unit: number;
        velocity_scale: number;
        watchdog_ms: number | null;
      })[];
      poll_ms: number;
      timeout_ms: number;
    };
  };
  /** show state, fault, position, switches and errors of every drive, and exchanges and latency of the bus */
  "drive.status": {
    params: Record<string, never>;
    result: {
      axes: {
        answers: number;
        axis: string;
        brake_closed: boolean;
        errors: number;
        errors_by_kind: Record<string, number>;
        fault_code: number;
        following_error: number;
        home_switch: boolean;
        in_contact: boolean;
        index_count: number;
        index_position: number;
        limit_negative: boolean;
        limit_positive: boolean;
        losses: number;
        position: number;
        power_w: number;
        referenced: boolean;
        state: string;
        temperature_c: number;
        velocity: number;
        vibration_hz: number;
        vibration_um: number;
      }[];
      choice: string;
      connected: boolean;
      connections: number;
      endpoint: string | null;
      errors: Record<string, number>;
      exchanges: number;
      round_trip_us: {
        max: number;
        p50: number;
        p90?: number;
        p99: number;
        p999: number;
      };
      vibration: {
        amplitude_um: number;
        errors: number;
        frequency_hz: number;
        lost: number;
        samples: number;
        sensor: string;
        synchronous_um: number;
      }[];
    };
  };
  /** clear the fault of a drive */
  "drive.reset": {
    params: {
      drive: string;
    };
    result: {
      accepted: boolean;
    };
  };
  /** make a simulated drive fail or work again */
  "drive.fault": {
    params: {
      drive: string;
      fault: "none" | "off" | "stuck" | "garbage" | "slow" | "intermittent" | "trip" | "elsewhere" | "mangled" | "hang_up" | "jammed" | "frozen";
    };
    result: {
      accepted: boolean;
    };
  };
  /** list the active alarms */
  "alarm.list": {
    params: {
      channel?: number;
    };
    result: {
      alarms: ({
        acknowledged?: boolean;
        at: number | null;
        channel: number;
        code: string;
        column: number | null;
        cycle: number;
        file: string | null;
        line: number | null;
        number: number;
        reaction: number | null;
        remedy: string | null;
        text: string;
      })[];
      forgotten?: number;
    };
  };
  /** acknowledge the alarms of a channel */
  "alarm.ack": {
    params: {
      channel?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** list the newest 500 alarms of each channel */
  "alarm.history": {
    params: {
      channel?: number;
    };
    result: {
      alarms: ({
        acknowledged?: boolean;
        at: number | null;
        channel: number;
        code: string;
        column: number | null;
        cycle: number;
        file: string | null;
        line: number | null;
        number: number;
        reaction: number | null;
        remedy: string | null;
        text: string;
      })[];
      forgotten?: number;
    };
  };
  /** list what programs have measured since the daemon started: the newest 500 results of each channel */
  "measurement.history": {
    params: {
      channel?: number;
    };
    result: {
      forgotten?: number;
      measurements: {
        channel: number;
        cycle: number;
        feature: string;
        number: number;
        text: string;
        values: Record<string, number>;
      }[];
    };
  };
  /** list the tool table */
  "tool.list": {
    params: Record<string, never>;
    result: {
      tools: {
        angle_back: number;
        angle_front: number;
        corner_radius: number;
        edge: number;
        flute_length: number;
        holder_diameter: number;
        holder_length: number;
        kind: string;
        length: number;
        length_x: number;
        length_y: number;
        name: string;
        number: number;
        orientation: number;
        overhang: number;
        point_angle: number;
        radius: number;
        shank_diameter: number;
        taper_angle: number;
        wear_length: number;
        wear_length_x: number;
        wear_radius: number;
      }[];
    };
  };
  /** show the values of one edge of a tool */
  "tool.get": {
    params: {
      number: number;
      edge?: number;
    };
    result: {
      angle_back: number;
      angle_front: number;
      corner_radius: number;
      edge: number;
      flute_length: number;
      holder_diameter: number;
      holder_length: number;
      kind: string;
      length: number;
      length_x: number;
      length_y: number;
      name: string;
      number: number;
      orientation: number;
      overhang: number;
      point_angle: number;
      radius: number;
      shank_diameter: number;
      taper_angle: number;
      wear_length: number;
      wear_length_x: number;
      wear_radius: number;
    };
  };
  /** change a value of a tool; not while a program runs */
  "tool.set": {
    params: {
      number: number;
      key: "length" | "length_x" | "length_y" | "radius" | "wear_length" | "wear_length_x" | "wear_radius" | "overhang" | "orientation" | "angle_front" | "angle_back";
      value: number;
      edge?: number;
      confirmed?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** touch off: set the length of a tool so that an axis is at a given value; at rest, or in a hold */
  "tool.touch": {
    params: {
      number: number;
      axis: string;
      value: number;
      as?: "radius" | "diameter";
      situation?: number;
      edge?: number;
      confirmed?: number;
      channel?: number;
    };
    result: {
      new: number;
      old: number;
      undo: number;
    };
  };
  /** set the tools and work offsets listed in a text; not while a program is running */
  "tool.load": {
    params: {
      tables: string;
      file?: string;
      confirmed?: number;
    };
    result: {
      values: number;
    };
  };
  /** print tools and work offsets as a text for `tool load` */
  "tool.save": {
    params: Record<string, never>;
    result: {
      tables: string;
    };
  };
  /** list the newest 500 changes of tools and work offsets since the daemon started, newest first: by an operator, or by the program that ran last */
  "tool.history": {
    params: Record<string, never>;
    result: {
      changes: {
        by: string;
        from: number;
        time_s: number;
        to: number;
        what: string;
      }[];
    };
  };
  /** list the work offsets */
  "offset.list": {
    params: Record<string, never>;
    result: {
      axes: string[];
      offsets: Record<string, Record<string, number>>;
    };
  };
  /** change a work offset; not while a program runs */
  "offset.set": {
    params: {
      offset: string;
      axis: string;
      value: number;
      confirmed?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** touch off: set a work offset so that an axis is at a given value; only at rest */
  "offset.touch": {
    params: {
      offset: string;
      axis: string;
      value: number;
      as?: "radius" | "diameter";
      situation?: number;
      confirmed?: number;
      channel?: number;
    };
    result: {
      new: number;
      old: number;
      undo: number;
    };
  };
  /** undo a touch-off of an offset or a tool, if nobody has changed the value since */
  "offset.undo": {
    params: {
      undo: number;
    };
    result: {
      new: number;
      old: number;
    };
  };
  /** execute one line of program text: a block or a statement */
  mdi: {
    params: {
      text: string;
      channel?: number;
      wait?: "accepted" | "done";
      situation?: number;
      seen_cycle?: number;
    };
    result: {
      accepted?: boolean;
      blocks?: number;
      ok?: boolean;
      path_mm?: number;
      program?: string;
      time_s?: number;
    };
  };
  /** jog an axis by an increment, or for 200 ms at a time; repeat the command to keep the axis moving */
  jog: {
    params: {
      axis: string;
      velocity: number;
      increment?: number;
      frame?: "machine" | "tool" | "plane";
      channel?: number;
      seen_cycle?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** move an axis as a handwheel does: the way is added to where the axis goes, and followed as fast as the axis can; what it cannot follow is dropped, so that it stands soon after the wheel */
  handwheel: {
    params: {
      axis: string;
      way: number;
      channel?: number;
      seen_cycle?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** home the axes of a channel in the order of the machine file; finds the home switches or index pulses, and answers when homing is done */
  home: {
    params: {
      axis?: string;
      channel?: number;
      seen_cycle?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** show feed law, feed, spindle, cutting speed and force control */
  "process.status": {
    params: {
      channel?: number;
    };
    result: {
      adaptive: unknown;
      automatic: unknown[];
      channel: number;
      cutting_speed_m_min: number;
      feed_mm_min: number;
      feed_mm_rev: number;
      increments: number;
      interruption: unknown;
      law: string | null;
      spindle_rev_min: number;
      stands: boolean;
    };
  };
  /** interrupt the feed for the time of L_A, immediately and then after each L_B of path */
  "process.interrupt": {
    params: {
      la: number;
      lb?: number;
      channel?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** switch an automatic feed law on or off: the channel derives the feed from a sensor */
  "process.automatic": {
    params: {
      law: "modulated" | "linear";
      on: number;
      channel?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** switch the adaptive control of the cutting force on or off, or change one of its values */
  "process.adaptive": {
    params: {
      action: "off" | "on" | "set";
      quantity?: "force" | "level" | "mass" | "frequency";
      value?: number;
      channel?: number;
    };
    result: {
      accepted: boolean;
    };
  };
  /** design a plunge grinding cycle from a process file, or verify one from a control file; samples are time s, X mm, remaining allowance mm, infeed mm/s, removal mm2/rad, and the ratio of the removal to its boundary; a check on this connection cancels it */
  "process.grinding": {
    params: {
      program: string;
    };
    result: {
      boundary?: number[][];
      burn_ratio_max?: number;
      constant_time_s?: number | null;
      continuous_time_s?: number | null;
      findings: {
        code: string;
        text: string;
      }[];
      force_max_n?: number;
      law?: number[][];
      least_time_s?: number;
      ok: boolean;
      program: string;
      ratio_max?: number;
      residual_um?: number;
      roundness_um?: number;
      samples?: number[][];
      spark_out_rev?: number;
      three_step_time_s?: number | null;
      time_s?: number;
    };
  };
  /** calculate stability lobes like `stanok process lobes`: the depths up to which a cut does not chatter; limits are speed rev/min, depth mm (null: any), chatter Hz (0: not known) */
  "process.stability": {
    params: {
      program: string;
      from?: number;
      to?: number;
      count?: number;
      method?: "zeroth-order" | "semi-discretisation";
      speed?: number;
      depth?: number;
    };
    result: {
      always_stable_mm: number | null;
      best: ({
        chatter_hz: number;
        depth_mm: number | null;
        speed_rev_per_min: number;
      })[];
      cuts: ({
        better_speed_rev_per_min: number | null;
        depth_mm: number;
        limit_mm: number | null;
        speed_rev_per_min: number;
        stable: boolean;
      })[];
      kind: string;
      limits: unknown[][];
      program: string;
    };
  };
  /** figures of a cut from its log, as `stanok process identify`, with intervals of 95 %; si is the same in SI units; power is time s, as recorded W, as fitted W; text is what to write into a file; fit says whether the model fits: if ok is false, the figures are not those of the cut; if it is true and there is a reason, their intervals are widened */
  "process.figures": {
    params: {
      file: string;
      kind?: "turning" | "milling" | "grinding";
      stock?: string;
      program?: string;
      channel?: number;
      spindle?: number;
      coefficient?: number;
      touch?: number;
      force_ratio?: number;
      wheel_speed?: number;
      tool?: number;
      efficiency?: number;
    };
    result: {
      figures: {
        high: number;
        low: number;
        name: string;
        si: {
          high: number;
          low: number;
          name: string;
          value: number;
        };
        value: number;
      }[];
      file: string;
      fit: {
        kind: string;
        ok: boolean;
        reason: string;
        remedy: string;
      };
      kind: string;
      noise: number;
      power: number[][];
      readings: number;
      residual_w: number;
      text: string;
    };
  };
  /** calculate forces along a program, and feeds that hold a force, like `stanok process optimise`; places are path mm, force as programmed N, force as planned N, feed as programmed mm/min, feed as planned mm/min, power W, depth mm or area mm2, deflection um; text is the program with the planned feeds */
  "process.forces": {
    params: {
      program: string;
      cut?: string;
      tool?: number;
      step?: number;
      force?: number;
      feed_min?: number;
      feed_max?: number;
      stiffness?: number;
      channel?: number;
    };
    result: {
      blocks: number;
      deflection_max_um: number;
      force_max_n: number;
      force_programmed_max_n: number;
      kind: string;
      places: number[][];
      power_max_w: number;
      program: string;
      text: string | null;
      time_programmed_s: number;
      time_s: number;
    };
  };
  /** cancel the process calculation of this connection, which then answers E9017 */
  "process.cancel": {
    params: Record<string, never>;
    result: {
      accepted: boolean;
    };
  };
  /** show whether announcements of workpieces are published, and the latest one of every channel */
  "workpiece.status": {
    params: Record<string, never>;
    result: {
      allowed: boolean;
      workpieces: {
        channel: number;
        tool: number;
      }[];
    };
  };
  /** read the surface of the workpiece that is being cut, page by page, or only what has changed */
  "workpiece.surface": {
    params: {
      channel?: number;
      workpiece?: number;
      since?: number;
      from?: number;
      reference?: string;
    };
    result: {
      base: {
        pose: number[];
        scheme: number;
      } | null;
      blank: unknown;
      channel: number;
      cycles_left_out: number;
      geometry: unknown;
      next: number | null;
      version: number;
      workpiece: number | null;
    };
  };
  /** publish the workpieces that programs announce with #workpiece, so that viewers can follow the cut */
  "workpiece.allow": {
    params: {
      on?: number;
    };
    result: {
      allowed: boolean;
    };
  };
  /** list the signals of axes, channels and cycle that can be recorded, with units and limits */
  "scope.signals": {
    params: Record<string, never>;
    result: {
      signals: ({
        limit: number | null;
        name: string;
        unit: string;
      })[];
    };
  };
  /** record signals in every cycle, starting before a trigger; ends the previous recording */
  "scope.start": {
    params: {
      signals: string;
      trigger?: "none" | "level" | "event" | "block" | "alarm";
      signal?: string;
      level?: number;
      edge?: "rising" | "falling";
      event?: string;
      line?: number;
      channel?: number;
      before_s?: number;
      length_s?: number;
    };
    result: {
      id: number;
    };
  };
  /** end the recording; what has been recorded can be read */
  "scope.stop": {
    params: Record<string, never>;
    result: {
      accepted: boolean;
    };
  };
  /** read the recording, at most 4096 cycles at a time: Float32, little endian, in base64, one value of each signal, cycle by cycle */
  "scope.read": {
    params: {
      from?: number;
    };
    result: {
      count: number;
      cycle_us: number;
      cycles: number;
      first_cycle: number;
      from: number;
      id: number;
      signals: ({
        limit: number | null;
        name: string;
        unit: string;
      })[];
      state: string;
      trigger: number | null;
      values: string;
    };
  };
  /** list the log files of the machine, newest first */
  "history.logs": {
    params: Record<string, never>;
    result: {
      folder: string;
      logs: {
        bytes: number;
        changed_s: number;
        file: string;
        is_open: boolean;
      }[];
    };
  };
  /** repeat the run of a log from its inputs and compare every setpoint; the verdict is same, part (the log is cut off, damaged or lacks inputs, but is the same as far as it goes), or differs */
  "history.verify": {
    params: {
      file: string;
    };
    result: {
      cycles: number;
      difference: unknown;
      file: string;
      lost_from_cycle: number | null;
      remarks: string[];
      setpoints: number;
      verdict: string;
    };
  };
  /** read the path of the tool tip of a channel from a log: pages of points with their times */
  "history.path": {
    params: {
      file: string;
      channel?: number;
      page?: number;
      system?: "work" | "part";
    };
    result: {
      channel: number;
      file: string;
      first_cycle: number;
      geometry: unknown;
      left_out_s: number;
      pages: number;
      points: number;
      system: string;
      time_s: number;
    };
  };
  /** show file, bytes and losses of the recorder and the LCM publisher */
  "log.status": {
    params: Record<string, never>;
    result: {
      file: {
        bytes: number;
        error: string | null;
        events: number;
        path: string | null;
        rests: boolean;
      };
      flight: string | null;
      inputs_lost: number;
      kept: {
        bytes: number;
        bytes_max: number | null;
        files: number;
        free_bytes: number | null;
        free_bytes_min: number | null;
        hours_max: number | null;
      };
      lcm: {
        lost: number;
        open: boolean;
        sent: number;
        url: string | null;
      };
      outputs_lost: number;
    };
  };
  /** start a new log file */
  "log.start": {
    params: Record<string, never>;
    result: {
      path: string;
    };
  };
  /** close the log file */
  "log.stop": {
    params: Record<string, never>;
    result: {
      path: string;
    };
  };
  /** send a snapshot of these topics, then their changes as notifications */
  subscribe: {
    params: {
      topics: ("machine" | "channels" | "drives" | "events")[];
      rate_hz?: number;
    };
    result: {
      rate_hz: number;
      topics: string[];
    };
  };
  /** lower the role of this connection, and name the person who works there */
  "session.role": {
    params: {
      role: "observer" | "operator" | "programmer" | "integrator";
      name?: string;
    };
    result: {
      role: string;
    };
  };
  /** show version, build, process, files and clients of the daemon */
  "system.info": {
    params: Record<string, never>;
    result: {
      api: number;
      build: string;
      history: string | null;
      pid: number;
      server: string;
      uptime_s: number;
      version: string;
    };
  };
  /** hold the feed, then switch the drives off, then end the daemon */
  "system.shutdown": {
    params: Record<string, never>;
    result: {
      accepted: boolean;
    };
  };
  /** show this table of methods as an OpenRPC document */
  "rpc.discover": {
    params: Record<string, never>;
    result: {
      info: {
        title: string;
        version: string;
      };
      methods: unknown[];
      openrpc: string;
    };
  };
}

export type MethodName = keyof Methods;

/** The role that each method wants. */
export const method_roles: Record<MethodName, string> = {
  "machine.on": 'operator',
  "machine.off": 'operator',
  "machine.estop": 'operator',
  "machine.journal": 'observer',
  "machine.status": 'observer',
  "channel.list": 'observer',
  "channel.status": 'observer',
  "channel.position": 'observer',
  "channel.control": 'operator',
  "channel.watch": 'observer',
  "program.read": 'observer',
  "program.write": 'programmer',
  "program.remove": 'programmer',
  "program.check": 'observer',
  "program.picture": 'observer',
  "program.estimate": 'observer',
  "program.check_cancel": 'observer',
  "program.path": 'observer',
  "program.load": 'operator',
  "program.run": 'operator',
  "program.start": 'operator',
  "program.hold": 'operator',
  "program.resume": 'operator',
  "program.return": 'operator',
  "program.retrace": 'operator',
  "program.spindles": 'operator',
  "program.coolant": 'operator',
  "program.stop": 'operator',
  "program.reset": 'operator',
  "program.optional_stop": 'operator',
  "program.first_part": 'operator',
  "program.step": 'operator',
  "program.skip": 'operator',
  "program.unskip": 'operator',
  "program.list": 'observer',
  "program.history": 'observer',
  "program.search": 'operator',
  "override.feed": 'operator',
  "override.rapid": 'operator',
  "override.spindle": 'operator',
  "queue.list": 'observer',
  "queue.add": 'operator',
  "queue.remove": 'operator',
  "queue.move": 'operator',
  "queue.start": 'operator',
  "queue.stop": 'operator',
  "kinematics.list": 'observer',
  "kinematics.select": 'operator',
  "kinematics.status": 'observer',
  "drive.list": 'observer',
  "drive.status": 'observer',
  "drive.reset": 'operator',
  "drive.fault": 'integrator',
  "alarm.list": 'observer',
  "alarm.ack": 'operator',
  "alarm.history": 'observer',
  "measurement.history": 'observer',
  "tool.list": 'observer',
  "tool.get": 'observer',
  "tool.set": 'operator',
  "tool.touch": 'operator',
  "tool.load": 'operator',
  "tool.save": 'observer',
  "tool.history": 'observer',
  "offset.list": 'observer',
  "offset.set": 'operator',
  "offset.touch": 'operator',
  "offset.undo": 'operator',
  mdi: 'operator',
  jog: 'operator',
  handwheel: 'operator',
  home: 'operator',
  "process.status": 'observer',
  "process.interrupt": 'operator',
  "process.automatic": 'operator',
  "process.adaptive": 'operator',
  "process.grinding": 'observer',
  "process.stability": 'observer',
  "process.figures": 'observer',
  "process.forces": 'observer',
  "process.cancel": 'observer',
  "workpiece.status": 'observer',
  "workpiece.surface": 'observer',
  "workpiece.allow": 'operator',
  "scope.signals": 'observer',
  "scope.start": 'operator',
  "scope.stop": 'operator',
  "scope.read": 'observer',
  "history.logs": 'observer',
  "history.verify": 'observer',
  "history.path": 'observer',
  "log.status": 'observer',
  "log.start": 'operator',
  "log.stop": 'operator',
  subscribe: 'observer',
  "session.role": 'observer',
  "system.info": 'observer',
  "system.shutdown": 'integrator',
  "rpc.discover": 'observer',
};

/** What begins motion, and says what was seen when it was asked for. */
export const aged_methods: readonly string[] = [
  'machine.on',
  'program.run',
  'program.start',
  'program.resume',
  'program.return',
  'program.retrace',
  'program.spindles',
  'program.coolant',
  'program.first_part',
  'override.feed',
  'override.rapid',
  'queue.start',
  'kinematics.select',
  'mdi',
  'jog',
  'handwheel',
  'home',
];

/** What only ever brings motion to rest. */
export const stop_methods: readonly string[] = [
  'machine.off',
  'machine.estop',
  'program.hold',
  'program.stop',
  'program.reset',
];
