package tellosimulator.recording;

import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import tellosimulator.command.Sticks;
import tellosimulator.controller.FlightEvent;
import tellosimulator.goal.GoalEvent;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.model.Motion;
import tellosimulator.network.WireTap.Kind;
import tellosimulator.sim.Severity;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.SimTime;
import tellosimulator.time.WallTime;

/** Formats the lines of a recording; see docs/recordings.md. For the writer's thread. */
final class RecordingFormat {

  /** The first line of the table. */
  static final String HEADER =
      "t_s,drone,x_cm,y_cm,z_cm,roll_deg,pitch_deg,heading_deg,vx_cm_s,vy_cm_s,vz_cm_s,phase,"
          + "battery_pct,rc_a,rc_b,rc_c,rc_d,state_h_cm,state_tof_cm,state_baro_m,state_yaw_deg,"
          + "state_bat_pct,command\n";

  /** Digits of a video datagram's digest. */
  private static final int DIGEST_DIGITS = 16;

  private static final int MOST_NAMES = 1000;

  private final Map<InetSocketAddress, String> names = new HashMap<>();
  private final MessageDigest sha256 = sha256();

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("each JDK has SHA-256", e);
    }
  }

  // --- wire.jsonl ---

  /** A datagram that came. */
  void write(TextRow row, Entry.Received datagram, WallTime begun) {
    head(row, datagram.time(), begun.millisUntil(datagram.nanos()), datagram.drone());
    row.raw(",\"dir\":\"in\",\"kind\":\"").raw(Kind.COMMAND.word()).raw('"');
    ends(row, datagram.ends());
    row.raw(",\"text\":").quoted(datagram.text()).raw('}').end();
  }

  /** A datagram that left. */
  void write(TextRow row, Entry.Sent datagram, WallTime begun) {
    head(row, datagram.time(), begun.millisUntil(datagram.nanos()), datagram.drone());
    row.raw(",\"dir\":\"out\",\"kind\":\"").raw(datagram.kind().word()).raw('"');
    ends(row, datagram.ends());
    if (datagram.kind() == Kind.VIDEO) {
      String digest = HexFormat.of().formatHex(sha256.digest(datagram.bytes()));
      row.raw(",\"size\":").whole(datagram.bytes().length);
      row.raw(",\"sha256\":\"").raw(digest.substring(0, DIGEST_DIGITS)).raw("\"}").end();
    } else {
      row.raw(",\"text\":").quoted(text(datagram)).raw('}').end();
    }
  }

  /** One character a byte. */
  static String text(Entry.Sent datagram) {
    return new String(datagram.bytes(), StandardCharsets.ISO_8859_1);
  }

  private static void head(TextRow row, SimTime time, long wall, int drone) {
    row.raw("{\"t\":").seconds(time).raw(",\"wall\":").whole(wall);
    row.raw(",\"drone\":").whole(drone);
  }

  private void ends(TextRow row, Entry.Ends ends) {
    row.raw(",\"from\":\"").raw(name(ends.from()));
    row.raw("\",\"to\":\"").raw(name(ends.to())).raw('"');
  }

  private String name(InetSocketAddress address) {
    if (names.size() > MOST_NAMES) {
      names.clear();
    }
    return names.computeIfAbsent(
        address, each -> each.getAddress().getHostAddress() + ":" + each.getPort());
  }

  // --- events.jsonl ---

  /** Something that happened. */
  static void write(TextRow row, Entry.Happened happened) {
    SimEvent event = happened.event();
    row.raw("{\"t\":").seconds(event.time());
    if (event instanceof SimEvent.ForDrone one) {
      row.raw(",\"drone\":").whole(one.drone());
    }
    row.raw(",\"kind\":\"").raw(kind(event));
    row.raw("\",\"severity\":\"").raw(word(event.severity()));
    row.raw("\",\"text\":").quoted(event.words());
    if (event instanceof SimEvent.ReplyLost lost) {
      member(row, "reply", lost.text());
    } else if (event instanceof SimEvent.FromPeer said) {
      member(row, "command", said.text());
    }
    reply(event).ifPresent(reply -> member(row, "reply", reply));
    reason(event).ifPresent(reason -> member(row, "reason", reason));
    happened.place().ifPresent(place -> place(row, place));
    row.raw('}').end();
  }

  private static void member(TextRow row, String name, String text) {
    row.raw(",\"").raw(name).raw("\":").quoted(text);
  }

  private static void place(TextRow row, Vec3 place) {
    row.raw(",\"x\":").decimal(Frames.centimeters(place.x()), 2);
    row.raw(",\"y\":").decimal(Frames.centimeters(place.y()), 2);
    row.raw(",\"z\":").decimal(Frames.centimeters(place.z()), 2);
  }

  private static String kind(SimEvent event) {
    if (event instanceof SimEvent.DroneFlight flight) {
      return kind(flight.event());
    } else if (event instanceof SimEvent.CommandReceived) {
      return "command";
    } else if (event instanceof SimEvent.ReplySent) {
      return "reply";
    } else if (event instanceof SimEvent.CommandRefused) {
      return "refused";
    } else if (event instanceof SimEvent.CommandFailed) {
      return "failed";
    } else if (event instanceof SimEvent.CommandIgnored || event instanceof SimEvent.TurnedAway) {
      return "ignored";
    } else if (event instanceof SimEvent.CommandLost || event instanceof SimEvent.ReplyLost) {
      return "lost";
    } else if (event instanceof GoalEvent) {
      return "goal";
    } else if (event instanceof SimEvent.FaultBegan || event instanceof SimEvent.FaultEnded) {
      return "fault";
    }
    return "other";
  }

  private static String kind(FlightEvent event) {
    if (event instanceof FlightEvent.TookOff) {
      return "took-off";
    } else if (event instanceof FlightEvent.Landed) {
      return "landed";
    } else if (event instanceof FlightEvent.Crashed) {
      return "crashed";
    } else if (event instanceof FlightEvent.Touched) {
      return "touched";
    }
    return "other";
  }

  private static String word(Severity severity) {
    return severity.name().toLowerCase(Locale.ROOT);
  }

  private static Optional<String> reply(SimEvent event) {
    if (event instanceof SimEvent.ReplySent sent) {
      return Optional.of(sent.reply().text());
    } else if (event instanceof SimEvent.CommandRefused refused) {
      return Optional.of(refused.reply().text());
    } else if (event instanceof SimEvent.CommandFailed failed) {
      return Optional.of(failed.reply().text());
    }
    return Optional.empty();
  }

  private static Optional<String> reason(SimEvent event) {
    if (event instanceof SimEvent.CommandRefused refused) {
      return Optional.of(refused.reason().english());
    } else if (event instanceof SimEvent.CommandFailed failed) {
      return Optional.of(failed.reason().english());
    } else if (event instanceof SimEvent.CommandIgnored ignored) {
      return Optional.of(ignored.reason().english());
    } else if (event instanceof SimEvent.TurnedAway turned) {
      return Optional.of(turned.reason().english());
    } else if (event instanceof SimEvent.CommandLost lost) {
      return Optional.of(lost.cause().english());
    } else if (event instanceof SimEvent.ReplyLost lost) {
      return Optional.of(lost.cause().english());
    }
    return Optional.empty();
  }

  // --- flight.csv ---

  /** How a drone is at a moment. */
  static void write(TextRow row, SimTime time, DroneSnapshot drone, FlightRowState pilot) {
    Motion motion = drone.state().motion();
    row.seconds(time).raw(',').whole(drone.state().drone());
    vector(row, motion.position(), 2);
    row.raw(',').decimal(Math.toDegrees(motion.attitude().bank()), 2);
    row.raw(',').decimal(Math.toDegrees(motion.attitude().elevation()), 2);
    row.raw(',').decimal(Frames.yawOfHeading(motion.attitude().heading()), 2);
    vector(row, motion.velocity(), 1);
    row.raw(',').raw(word(drone.state().phase()));
    row.raw(',').whole(drone.state().energy().battery().percent());
    Sticks sticks = pilot.sticks();
    row.raw(',').whole(Math.round(sticks.right())).raw(',').whole(Math.round(sticks.forward()));
    row.raw(',').whole(Math.round(sticks.up())).raw(',').whole(Math.round(sticks.clockwise()));
    row.raw(',').raw(pilot.sensors());
    row.raw(',').cell(pilot.command()).end();
  }

  private static void vector(TextRow row, Vec3 meters, int decimals) {
    row.raw(',').decimal(Frames.centimeters(meters.x()), decimals);
    row.raw(',').decimal(Frames.centimeters(meters.y()), decimals);
    row.raw(',').decimal(Frames.centimeters(meters.z()), decimals);
  }

  private static String word(FlightPhase phase) {
    return switch (phase) {
      case OFF -> "off";
      case GROUNDED -> "grounded";
      case IDLING -> "idling";
      case TAKING_OFF -> "taking-off";
      case FLYING -> "flying";
      case LANDING -> "landing";
      case FALLING -> "falling";
      case CRASHED -> "crashed";
    };
  }
}
