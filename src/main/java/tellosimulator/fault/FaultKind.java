package tellosimulator.fault;

import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** All kinds of faults, with their parameters. The page {@code docs/faults.md} lists them. */
public enum FaultKind {
  LOSS(
      "Datagrams never arrive, one by one or in bursts.",
      new Range(FaultParameter.SHARE, 0, 1, 0.2),
      new Range(FaultParameter.BURST, 1, 100, 1)),
  DELAY(
      "Datagrams take longer, without overtaking each other; log-normally spread.",
      new Range(FaultParameter.TIME, 0, 10, 0.1),
      new Range(FaultParameter.SPREAD, 0, 10, 0),
      new Range(FaultParameter.LEAST, 0, 10, 0),
      new Range(FaultParameter.MOST, 0, 10, 10)),
  DUPLICATE("Datagrams arrive twice.", new Range(FaultParameter.SHARE, 0, 1, 0.2)),
  REORDER(
      "Datagrams are late, and those after them overtake them.",
      new Range(FaultParameter.SHARE, 0, 1, 0.2),
      new Range(FaultParameter.TIME, 0, 10, 0.15)),
  CORRUPT(
      "One to three bytes of a datagram are wrong.", new Range(FaultParameter.SHARE, 0, 1, 0.2)),
  BANDWIDTH(
      "The link is slow: datagrams wait for each other, and are lost after half a second.",
      new Range(FaultParameter.RATE, 1000, 1e8, 100_000)),
  CUT("Nothing goes through."),
  LATE_REPLY(
      "Replies come after a program has given up waiting, and those after them overtake them.",
      new Range(FaultParameter.TIME, 0, 60, 10)),
  STRAY_BINARY(
      "The command socket sends binary datagrams of 12, 13 and 35 bytes that begin with CC.",
      new Range(FaultParameter.EVERY, 0.02, 60, 0.5)),
  CONN_ACK_LOST("The answer to a connection request of the app's protocol is lost."),
  STRANGER(
      "A program on another host sends `command`, and then `land` again and again.",
      new Range(FaultParameter.EVERY, 0.02, 60, 5)),

  NO_VALID_IMU(
      "Moves, turns and flips answer `error No valid imu`; takeoff, land and rc work; it drifts.",
      new Range(FaultParameter.SPEED, 0, 1, 0.1)),
  DARK(
      "The camera below sees nothing: it drifts, and after a while it is as with `no-valid-imu`.",
      new Range(FaultParameter.SPEED, 0, 1, 0.2),
      new Range(FaultParameter.TIME, 0, 60, 5)),
  NOT_JOYSTICK(
      "A move shortly after `rc` or an `ok` answers `error Not joystick`.",
      new Range(FaultParameter.SHARE, 0, 1, 0.2),
      new Range(FaultParameter.TIME, 0, 60, 0.5)),
  UNACTIVATED("Only `command` is answered with `ok`, every other command with `error`."),
  SENSOR_ERROR("A takeoff answers `error`."),
  LOW_BATTERY(
      "The battery falls to a level, at which it lands by itself; it stays there.",
      new Range(FaultParameter.LEVEL, 0, 1, 0.05)),
  OVERHEAT(
      "It is hot: in the air it lands by itself, and a takeoff answers `error, high temp`.",
      new Range(FaultParameter.HEAT, 60, 120, 95)),
  MOTOR_STOP("Its motors stop in the air, and it falls."),
  REBOOT("It switches itself off, is silent for 8 s, and has forgotten SDK mode."),
  SILENT_LAND("It lands by itself, and a command that is still running gets no reply."),
  WEAK_TAKEOFF(
      "A takeoff ends lower than usual, with `ok`.",
      new Range(FaultParameter.HEIGHT, 0.1, 1, 0.15)),
  NO_VIDEO_IN_STATION_MODE(
      "`streamon` answers `ok`, but no picture comes, as in a network of others."),

  PAD_BLIND("It sees no mission pads."),
  TOF_OUT("The distance sensor below has no echo: `tof` is 6553."),
  BARO_JUMP("The barometer is wrong by a step.", new Range(FaultParameter.STEP, 0, 100, 5)),
  YAW_DRIFT(
      "The reported yaw turns away, and does not come back.",
      new Range(FaultParameter.TURN, 0, 90, 1)),

  STATE_STUCK("All state lines are as the last one before."),
  STATE_STOPPED("No state lines are sent."),
  STATE_SLOW("State lines are sent less often.", new Range(FaultParameter.EVERY, 0.1, 60, 1)),

  VIDEO_FREEZE("The stream goes on, but all pictures are the same."),
  VIDEO_LOSS(
      "Datagrams of the pictures are lost.",
      new Range(FaultParameter.SHARE, 0, 1, 0.05),
      new Range(FaultParameter.BURST, 1, 100, 1)),
  VIDEO_LATE(
      "Pictures come later.",
      new Range(FaultParameter.TIME, 0, 10, 0.5),
      new Range(FaultParameter.SPREAD, 0, 10, 0),
      new Range(FaultParameter.LEAST, 0, 10, 0),
      new Range(FaultParameter.MOST, 0, 10, 10)),
  VIDEO_NO_PARAMETERS("The stream has no parameter sets, without which it cannot be decoded.");

  /**
   * The range of a parameter of a fault, in the unit given at {@link FaultParameter}.
   *
   * @param usual the default
   */
  public record Range(FaultParameter parameter, double least, double most, double usual) {

    /** Describes the range, such as {@code 0% to 100%}. */
    public String words() {
      FaultParameter.Unit unit = parameter.unit();
      return unit.write(least) + " to " + unit.write(most);
    }
  }

  private final String words;
  private final List<Range> ranges;

  FaultKind(String words, Range... ranges) {
    this.words = words;
    this.ranges = List.of(ranges);
  }

  /** Returns the word at the beginning of a fault's text. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** Returns a description for the documentation. */
  public String words() {
    return words;
  }

  /**
   * Returns the ranges of the parameters. A fault's text may omit the word of the first parameter.
   */
  public List<Range> ranges() {
    return ranges;
  }

  /** Returns the range of a parameter; empty if faults of this kind do not have the parameter. */
  Optional<Range> range(FaultParameter parameter) {
    return ranges.stream().filter(range -> range.parameter() == parameter).findFirst();
  }

  /**
   * Returns the directions of the link that the fault can affect; empty if it is not a link fault.
   */
  public Set<LinkDirection> directions() {
    return switch (this) {
      case LOSS, DELAY, DUPLICATE, REORDER, CORRUPT, BANDWIDTH, CUT ->
          EnumSet.allOf(LinkDirection.class);
      case LATE_REPLY -> EnumSet.of(LinkDirection.REPLIES);
      case VIDEO_LOSS, VIDEO_LATE -> EnumSet.of(LinkDirection.VIDEO);
      default -> EnumSet.noneOf(LinkDirection.class);
    };
  }

  /**
   * Returns the link fault that has the same effect on datagrams, if this is a fault of the video;
   * otherwise, this kind.
   */
  FaultKind onLink() {
    return switch (this) {
      case VIDEO_LOSS -> LOSS;
      case VIDEO_LATE -> DELAY;
      default -> this;
    };
  }

  /** Returns all kinds, keyed by their words. */
  public static Map<String, FaultKind> byWord() {
    return Stream.of(values())
        .collect(Collectors.toMap(FaultKind::word, kind -> kind, (a, b) -> a, TreeMap::new));
  }
}
