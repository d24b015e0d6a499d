package tellosimulator.recording;

import static java.util.Map.entry;

import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import tellosimulator.controller.FlightEvent;
import tellosimulator.files.Sha256;
import tellosimulator.goal.GoalEvent;
import tellosimulator.json.Json;
import tellosimulator.json.JsonRecords;
import tellosimulator.math.Frames;
import tellosimulator.model.Motion;
import tellosimulator.network.WireTap.Kind;
import tellosimulator.protocol.app.NamedPacket;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimInput;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.SimTime;
import tellosimulator.time.WallTime;
import tellosimulator.words.Phrase;

/** Formats the lines of a recording; see docs/recordings.md. Confined to the writer's thread. */
final class RecordingFormat {

  /** The header line of the table. */
  static final String HEADER =
      "t_s,drone,x_cm,y_cm,z_cm,roll_deg,pitch_deg,heading_deg,vx_cm_s,vy_cm_s,vz_cm_s,phase,"
          + "battery_pct,rc_a,rc_b,rc_c,rc_d,state_h_cm,state_tof_cm,state_baro_m,state_yaw_deg,"
          + "state_bat_pct,command\n";

  /** The words for the kinds of events, by the class of the event. */
  private static final Map<Class<?>, String> KINDS =
      Map.ofEntries(
          entry(SimEvent.CommandReceived.class, "command"),
          entry(SimEvent.ReplySent.class, "reply"),
          entry(SimEvent.CommandRefused.class, "refused"),
          entry(SimEvent.CommandFailed.class, "failed"),
          entry(SimEvent.CommandIgnored.class, "ignored"),
          entry(SimEvent.TurnedAway.class, "ignored"),
          entry(SimEvent.CommandLost.class, "lost"),
          entry(SimEvent.ReplyLost.class, "lost"),
          entry(SimEvent.FaultBegan.class, "fault"),
          entry(SimEvent.FaultEnded.class, "fault"),
          entry(FlightEvent.TookOff.class, "took-off"),
          entry(FlightEvent.Landed.class, "landed"),
          entry(FlightEvent.Crashed.class, "crashed"),
          entry(FlightEvent.Touched.class, "touched"));

  private static final Function<Phrase, List<Object>> MEMBERS = RecordedPhrase::members;

  /** Number of digits in the digest of a video datagram. */
  private static final int DIGEST_DIGITS = 16;

  private final MessageDigest sha256 = Sha256.create();

  // --- wire.jsonl ---

  /** Formats a received datagram. */
  static String line(Entry.Input input, SimInput.Datagram datagram, WallTime begun) {
    return line(
        Json.object(
            "t", input.time().seconds(),
            "wall", begun.millisUntil(input.nanos()),
            "drone", datagram.drone(),
            "dir", "in",
            "kind", Kind.COMMAND.word(),
            "from", JsonRecords.text(datagram.peer().address()),
            "to", JsonRecords.text(datagram.peer().via()),
            "text", datagram.text(),
            "words", NamedPacket.of(datagram.bytes()).map(NamedPacket::words)));
  }

  /** Formats a sent datagram. */
  String line(Entry.Sent datagram, WallTime begun) {
    Optional<byte[]> video = Optional.of(datagram.bytes()).filter(b -> datagram.isVideo());
    return line(
        Json.object(
            "t", datagram.time().seconds(),
            "wall", begun.millisUntil(datagram.nanos()),
            "drone", datagram.drone(),
            "dir", "out",
            "kind", datagram.kind().word(),
            "from", JsonRecords.text(datagram.ends().from()),
            "to", JsonRecords.text(datagram.ends().to()),
            "size", video.map(bytes -> bytes.length),
            "sha256", video.map(this::digest),
            "text", Optional.of(datagram.text()).filter(text -> video.isEmpty()),
            "words",
                NamedPacket.of(datagram.bytes())
                    .filter(packet -> video.isEmpty())
                    .map(NamedPacket::words)));
  }

  private String digest(byte[] bytes) {
    return HexFormat.of().formatHex(sha256.digest(bytes)).substring(0, DIGEST_DIGITS);
  }

  private static String line(Map<String, Object> members) {
    return Json.text(members) + "\n";
  }

  // --- events.jsonl ---

  /** Formats an event. */
  static String line(Entry.Happened happened) {
    SimEvent event = happened.event();
    Optional<Phrase> reason = reason(event);
    boolean lost = event instanceof SimEvent.ReplyLost;
    Optional<SimEvent.FromPeer> said =
        event instanceof SimEvent.FromPeer peer ? Optional.of(peer) : Optional.empty();
    return line(
        Json.object(
            "t", event.time().seconds(),
            "drone", event instanceof SimEvent.ForDrone one ? one.drone() : Optional.empty(),
            "kind", kind(event),
            "severity", word(event.severity()),
            "text", event.words(),
            // events about a command are shown with that command
            "said", Optional.of(event.phrase()).filter(p -> said.isEmpty()).map(MEMBERS),
            "command", said.filter(peer -> !lost).map(SimEvent.FromPeer::text),
            "number",
                event instanceof SimEvent.OfCommand of ? of.request().number() : Optional.empty(),
            "reply", reply(event),
            "reason", reason.map(Phrase::english),
            "reasonSaid", reason.map(MEMBERS),
            "x", happened.place().map(place -> Frames.centimeters(place.x())),
            "y", happened.place().map(place -> Frames.centimeters(place.y())),
            "z", happened.place().map(place -> Frames.centimeters(place.z()))));
  }

  private static String kind(SimEvent event) {
    Object what = event instanceof SimEvent.DroneFlight flight ? flight.event() : event;
    return KINDS.getOrDefault(what.getClass(), event instanceof GoalEvent ? "goal" : "other");
  }

  private static Optional<String> reply(SimEvent event) {
    if (event instanceof SimEvent.ReplySent sent) {
      return Optional.of(sent.reply().text());
    } else if (event instanceof SimEvent.CommandRefused refused) {
      return Optional.of(refused.reply().text());
    } else if (event instanceof SimEvent.CommandFailed failed) {
      return Optional.of(failed.reply().text());
    } else if (event instanceof SimEvent.ReplyLost lost) {
      return Optional.of(lost.text());
    }
    return Optional.empty();
  }

  private static Optional<Phrase> reason(SimEvent event) {
    if (event instanceof SimEvent.CommandRefused refused) {
      return Optional.of(refused.reason());
    } else if (event instanceof SimEvent.CommandFailed failed) {
      return Optional.of(failed.reason());
    } else if (event instanceof SimEvent.CommandIgnored ignored) {
      return Optional.of(ignored.reason());
    } else if (event instanceof SimEvent.TurnedAway turned) {
      return Optional.of(turned.reason());
    } else if (event instanceof SimEvent.CommandLost lost) {
      return Optional.of(lost.cause());
    } else if (event instanceof SimEvent.ReplyLost lost) {
      return Optional.of(lost.cause());
    }
    return Optional.empty();
  }

  // --- flight.csv ---

  /** Returns the sample of a simulated drone. */
  static Sample sample(SimTime time, DroneSnapshot drone, FlightRowState pilot) {
    Motion motion = drone.state().motion();
    return new Sample(
        time.seconds(),
        motion.position(),
        motion.velocity(),
        new Sample.Angles(
            Math.toDegrees(motion.attitude().bank()),
            Math.toDegrees(motion.attitude().elevation()),
            Frames.yawOfHeading(motion.attitude().heading())),
        word(drone.state().phase()),
        drone.state().energy().battery().percent(),
        pilot.command());
  }

  /**
   * Formats a row.
   *
   * @param sticks the stick values; four empty cells if they are unknown
   * @param sensors the sensor values as sent
   */
  static String row(int drone, Sample sample, String sticks, String sensors) {
    return new CsvRow()
            .number(sample.time(), 3)
            .number(drone, 0)
            .vector(sample.position(), 2)
            .number(sample.angles().roll(), 2)
            .number(sample.angles().pitch(), 2)
            .number(sample.angles().heading(), 2)
            .vector(sample.velocity(), 1)
            .text(sample.phase())
            .number(sample.batteryPercent(), 0)
            .cells(sticks)
            .cells(sensors)
            .text(sample.command())
        + "\n";
  }

  private static String word(Enum<?> constant) {
    return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
