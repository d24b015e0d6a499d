package tellosimulator.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.sim.SimEvent;
import tellosimulator.testing.SteppedDrone;

/** Checks the drone's state against the names and values of a table. */
final class StateChecks {

  private static final Pattern NUMBER =
      Pattern.compile("(?<value>-?[0-9.]+)(±(?<tolerance>[0-9.]+))?");

  private final SteppedDrone drone;
  private final Map<String, Consumer<String>> checks = new LinkedHashMap<>();
  private Vec3 position = Vec3.ZERO;
  private double yawDeg;
  private int stateLines;
  private int events;

  StateChecks(SteppedDrone drone) {
    this.drone = drone;
    number("height", 1, () -> position().z() * 100);
    number("rise", 1, () -> flown().z() * 100);
    number("ahead", 1, () -> flown().x() * 100);
    number("left", 1, () -> flown().y() * 100);
    number("turned", 0.5, () -> wrapped(yaw() - yawDeg));
    number("speed", 1, () -> drone.state().motion().velocity().norm() * 100);
    number("battery", 0.5, () -> drone.state().energy().battery().level() * 100);
    number("motortime", 1, () -> drone.state().energy().motorTime());
    number("lines", 0, () -> (double) drone.stateLines().size() - stateLines);
    text("lineto", () -> lastLine().to().toString().substring(1));
    text("phase", () -> drone.state().phase().words());
    text("motors", () -> drone.state().phase().motorsOn() ? "on" : "off");
    text("pads", () -> drone.state().perception().padMode().name());
    text("video", () -> drone.state().video().toString());
    text("operator", () -> drone.link().operator().map(peer -> peer.host()).orElse("none"));
    text("ports", () -> drone.link().statePort() + " " + drone.link().videoPort());
    checks.put("line", this::line);
    checks.put("event", this::event);
  }

  /**
   * Called before a command is sent; the values flown, turned and new are relative to this time.
   */
  void begin() {
    position = position();
    yawDeg = yaw();
    stateLines = drone.stateLines().size();
    events = drone.events().size();
  }

  void check(String words) {
    int blank = words.indexOf(' ');
    Consumer<String> check = blank < 0 ? null : checks.get(words.substring(0, blank));
    if (check == null) {
      throw new IllegalArgumentException("expected one of " + checks.keySet() + ": " + words);
    }
    check.accept(words.substring(blank + 1));
  }

  private void number(String name, double usualTolerance, Supplier<Double> value) {
    checks.put(
        name,
        expected -> {
          Matcher matcher = NUMBER.matcher(expected);
          assertThat(matcher.matches()).as(name + " " + expected).isTrue();
          String tolerance = matcher.group("tolerance");
          double most = tolerance == null ? usualTolerance : Double.parseDouble(tolerance);
          double wanted = Double.parseDouble(matcher.group("value"));
          assertThat(value.get()).as(name).isBetween(wanted - most, wanted + most);
        });
  }

  private void text(String name, Supplier<String> value) {
    checks.put(
        name,
        expected -> assertThat(value.get()).as(name).matches(ExpectedText.of(expected).pattern()));
  }

  private void line(String expected) {
    assertThat(lastLine().text()).as("state line").matches(ExpectedText.of(expected).pattern());
  }

  private SteppedDrone.Sent lastLine() {
    List<SteppedDrone.Sent> lines = drone.stateLines();
    assertThat(lines).as("state lines").isNotEmpty();
    return lines.get(lines.size() - 1);
  }

  /** Checks one of the events since the command. */
  private void event(String expected) {
    List<String> words =
        drone.events().subList(events, drone.events().size()).stream()
            .map(SimEvent::words)
            .toList();
    assertThat(words)
        .as("events since the command")
        .anyMatch(each -> ExpectedText.of(expected).fits(each));
  }

  private Vec3 position() {
    return drone.state().motion().position();
  }

  /** Returns the displacement since the command, in the frame of the drone at that time [m]. */
  private Vec3 flown() {
    return position().minus(position).turned(-Frames.headingOfYaw(yawDeg));
  }

  /** Returns the yaw, clockwise [degrees]. */
  private double yaw() {
    DroneState state = drone.state();
    return Frames.yawOfHeading(state.motion().attitude().heading());
  }

  private static double wrapped(double degrees) {
    return StrictMath.IEEEremainder(degrees, 360);
  }
}
