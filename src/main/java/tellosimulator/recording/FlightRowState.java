package tellosimulator.recording;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.command.CommandSyntax;
import tellosimulator.command.Sticks;
import tellosimulator.command.WireText;
import tellosimulator.controller.FlightEvent;
import tellosimulator.sim.SimEvent;

/**
 * What the next row of {@code flight.csv} says of a drone beside its motion, by events and
 * datagrams: commands that are not answered yet, the sticks, and the sensors. For the writer's
 * thread.
 */
final class FlightRowState {

  /** Commands that wait for their answer. Decided: more than any program sends at once. */
  private static final int MOST_OPEN = 100;

  private static final int LONGEST_VALUE = 12;

  /** In the order of the columns. */
  private static final List<String> KEYS = List.of("h", "tof", "baro", "yaw", "bat");

  private static final String NO_SENSORS = ",,,,";

  private final List<String> open = new ArrayList<>();
  private Sticks sticks = Sticks.CENTERED;
  private Sticks sticksBefore = Sticks.CENTERED;
  private String sensors = NO_SENSORS;

  /** Something happened to the drone. */
  void take(SimEvent.ForDrone event) {
    if (event instanceof SimEvent.CommandReceived received) {
      receive(received.text());
    } else if (event instanceof SimEvent.ReplySent sent) {
      open.remove(sent.text());
      if (sent.text().strip().equals(CommandSyntax.STOP.verb())) {
        sticks = Sticks.CENTERED;
      }
    } else if (event instanceof SimEvent.CommandFailed failed) {
      open.remove(failed.text());
    } else if (event instanceof SimEvent.CommandRefused refused) {
      refuse(refused.text());
    } else if (event instanceof SimEvent.DroneFlight flight
        && flight.event() instanceof FlightEvent.PutBack) {
      forgetCommands();
    }
  }

  private void receive(String text) {
    if (WireText.isUnanswered(text)) {
      steer(text);
    } else if (open.size() < MOST_OPEN) {
      open.add(text);
    }
  }

  /** At once, so it is the last one. */
  private void refuse(String text) {
    int last = open.lastIndexOf(text);
    if (last >= 0) {
      open.remove(last);
    } else {
      sticks = sticksBefore;
    }
  }

  private void steer(String text) {
    String[] words = text.strip().split(" +", -1);
    if (words.length != 5 || !words[0].equals(CommandSyntax.RC.verb())) {
      return;
    }
    double[] values = new double[4];
    for (int i = 0; i < values.length; i++) {
      if (!words[i + 1].matches("[-+]?[0-9]{1,3}(\\.[0-9]{1,6})?")) {
        return;
      }
      values[i] = Double.parseDouble(words[i + 1]);
    }
    sticksBefore = sticks;
    sticks = new Sticks(values[0], values[1], values[2], values[3]);
  }

  /** The drone has no power, or stands at its start. */
  void forgetCommands() {
    open.clear();
    sticks = Sticks.CENTERED;
    sticksBefore = Sticks.CENTERED;
  }

  /** It sent a state line. */
  void report(String line) {
    StringBuilder cells = new StringBuilder();
    for (String key : KEYS) {
      cells.append(cells.isEmpty() && key.equals(KEYS.get(0)) ? "" : ",").append(value(line, key));
    }
    sensors = cells.toString();
  }

  /** That of a key; empty if it is not there, or no number, as when the line was corrupted. */
  private static String value(String line, String key) {
    int start = line.indexOf(";" + key + ":");
    if (start < 0) {
      return "";
    }
    int begin = start + key.length() + 2;
    int end = line.indexOf(';', begin);
    if (end < 0 || end == begin || end - begin > LONGEST_VALUE) {
      return "";
    }
    for (int i = begin; i < end; i++) {
      char c = line.charAt(i);
      if ((c < '0' || c > '9') && c != '.' && c != '-') {
        return "";
      }
    }
    return line.substring(begin, end);
  }

  /** The sticks as they were set last. */
  Sticks sticks() {
    return sticks;
  }

  /**
   * The command that was taken first of those that are not answered yet; empty if there is none.
   */
  String command() {
    return open.isEmpty() ? "" : WireText.printable(open.get(0));
  }

  /** Height, range, barometer, yaw and battery as it last sent them, with commas in between. */
  String sensors() {
    return sensors;
  }
}
