package tellosimulator.recording;

import static java.util.stream.Collectors.joining;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.DoubleStream;
import tellosimulator.command.CommandSyntax;
import tellosimulator.command.Request;
import tellosimulator.command.WireText;
import tellosimulator.controller.FlightEvent;
import tellosimulator.controller.Sticks;
import tellosimulator.sim.SimEvent;

/**
 * The columns of {@code flight.csv} that do not describe motion: unanswered commands, sticks and
 * sensor values. They are derived from a drone's events and datagrams. Confined to the writer's
 * thread.
 */
final class FlightRowState {

  /**
   * Maximum number of unanswered commands that are tracked. Decided: more than any program sends at
   * once.
   */
  private static final int MOST_OPEN = 100;

  /** The keys of the state line, in the order of the columns. */
  private static final List<String> KEYS = List.of("h", "tof", "baro", "yaw", "bat");

  private static final String NO_SENSORS = ",,,,";

  /**
   * Matches a value of the state line if the value is a number. In a corrupted line, it may not be
   * one.
   */
  private static final Pattern SENSOR =
      Pattern.compile(";(h|tof|baro|yaw|bat):([-.0-9]{1,12})(?=;)");

  private static final String STICK = " +([-+]?[0-9]{1,3}(?:\\.[0-9]{1,6})?)";
  private static final Pattern RC =
      Pattern.compile(
          CommandSyntax.RC.verb()
              + STICK.repeat(4)
              + "(?:"
              + Pattern.quote(WireText.APP_SUFFIX)
              + ")?");

  /** Unanswered commands by number, in order of arrival. */
  private final Map<Integer, String> open = new LinkedHashMap<>();

  private Sticks sticks = Sticks.CENTERED;
  private Sticks sticksBefore = Sticks.CENTERED;
  private String sensors = NO_SENSORS;

  /** Processes an event of the drone. */
  void take(SimEvent.ForDrone event) {
    if (event instanceof SimEvent.CommandReceived received) {
      receive(received.request());
    } else if (event instanceof SimEvent.OfCommand answered) {
      open.remove(answered.request().number());
      set(answered);
    } else if (event instanceof SimEvent.DroneFlight flight
        && flight.event() instanceof FlightEvent.PutBack) {
      forgetCommands();
    }
  }

  private void receive(Request request) {
    if (WireText.isUnanswered(request.text())) {
      steer(request.text());
    } else if (open.size() < MOST_OPEN) {
      open.put(request.number(), request.text());
    }
  }

  /**
   * Updates the sticks: a stop centres them; the refusal of an {@code rc} restores their previous
   * positions.
   */
  private void set(SimEvent.OfCommand answered) {
    String text = answered.text();
    if (answered instanceof SimEvent.ReplySent && text.strip().equals(CommandSyntax.STOP.verb())) {
      sticks = Sticks.CENTERED;
    } else if (answered instanceof SimEvent.CommandRefused && WireText.isUnanswered(text)) {
      sticks = sticksBefore;
    }
  }

  private void steer(String text) {
    Matcher rc = RC.matcher(text.strip());
    if (rc.matches()) {
      sticksBefore = sticks;
      sticks = new Sticks(value(rc, 1), value(rc, 2), value(rc, 3), value(rc, 4));
    }
  }

  private static double value(Matcher rc, int stick) {
    return Double.parseDouble(rc.group(stick));
  }

  /**
   * Forgets all commands and centres the sticks. Called when the drone is off or back at its start.
   */
  void forgetCommands() {
    open.clear();
    sticks = Sticks.CENTERED;
    sticksBefore = Sticks.CENTERED;
  }

  /** Processes a state line. */
  void report(String line) {
    Map<String, String> values = new HashMap<>();
    Matcher sensor = SENSOR.matcher(line);
    while (sensor.find()) {
      values.putIfAbsent(sensor.group(1), sensor.group(2));
    }
    sensors = KEYS.stream().map(key -> values.getOrDefault(key, "")).collect(joining(","));
  }

  /** The latest stick positions, separated by commas. */
  String sticks() {
    return DoubleStream.of(sticks.right(), sticks.forward(), sticks.up(), sticks.clockwise())
        .mapToObj(value -> Long.toString(Math.round(value)))
        .collect(joining(","));
  }

  /** The oldest unanswered command; empty if there is none. */
  String command() {
    return open.isEmpty() ? "" : WireText.printable(open.values().iterator().next());
  }

  /** Height, range, barometer, yaw and battery as last sent, separated by commas. */
  String sensors() {
    return sensors;
  }
}
