package tellosimulator.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.testing.SteppedDrone.Sent;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Room;

/** Executes one row of the table. */
final class WireRun {

  /** The clients of the table by their names. A2 is another program on the host of A. */
  static final Map<String, InetSocketAddress> CLIENTS =
      Map.of(
          "A", SteppedDrone.CLIENT,
          "A2", SteppedDrone.address("192.168.10.2", 38065),
          "B", SteppedDrone.address("192.168.10.3", 9000));

  /** Time at the end without further replies [s]; longer than the second reply to `stop` takes. */
  private static final double QUIET = 3;

  private final WireRow row;
  private final SteppedDrone drone;
  private final StateChecks checks;

  private final List<MissionPad> pads = new ArrayList<>();

  /** Number of expected replies that have arrived. */
  private int seen;

  WireRun(WireRow row) {
    this.row = row;
    this.drone = SteppedDrone.of(row.profile(), row.behavior());
    this.checks = new StateChecks(drone);
  }

  void carryOut() {
    row.before().forEach(this::step);
    Message input = message(row.input());
    double start = drone.seconds();
    seen = drone.replies().size();
    checks.begin();
    drone.send(input.from(), input.text());
    for (ExpectedReply expected : row.replies()) {
      await(expected, input.from(), start);
    }
    row.afterwards().forEach(this::step);
    drone.advance(QUIET);
    assertThat(drone.replies().subList(seen, drone.replies().size()))
        .as("replies on top of the expected ones")
        .isEmpty();
  }

  private void await(ExpectedReply expected, InetSocketAddress asker, double start) {
    ExpectedReply.When when = expected.when();
    String what = "reply `%s` @%s".formatted(expected.text().notation(), when.word());
    drone.advanceUntil(
        () -> drone.replies().size() > seen, start + when.most() - drone.seconds() + 1e-6);
    assertThat(drone.replies().size()).as(what + " did not come").isGreaterThan(seen);
    Sent reply = drone.replies().get(seen++);
    assertThat(expected.text().fits(reply.text()))
        .as(what + ", but came `" + tellosimulator.command.WireText.printable(reply.text()) + "`")
        .isTrue();
    assertThat(reply.seconds() - start)
        .as(what + ": time of the reply")
        .isBetween(when.least() - 1e-6, when.most() + 1e-6);
    assertThat(reply.to())
        .as(what + ": addressee")
        .isEqualTo(expected.to().isEmpty() ? asker : CLIENTS.get(expected.to()));
    if (when.whenMotionIsOver()) {
      assertThat(drone.state().motion().velocity().norm()).as(what + ": speed").isLessThan(0.05);
    }
  }

  /** Executes a step, a check, or a command; the notation is explained beside the tables. */
  private void step(String step) {
    if (step.startsWith("@")) {
      control(Arrays.asList(step.substring(1).split(" ", -1)));
    } else if (step.contains(" => ")) {
      int arrow = step.indexOf(" => ");
      exchange(step.substring(0, arrow), step.substring(arrow + 4));
    } else if (step.startsWith("? ")) {
      checks.check(step.substring(2));
    } else if (step.endsWith(" &")) {
      Message message = message(step.substring(0, step.length() - 2));
      drone.send(message.from(), message.text());
      seen = drone.replies().size();
    } else {
      exchange(step, "ok");
    }
  }

  private void exchange(String command, String reply) {
    Message message = message(command);
    int before = drone.replies().size();
    assertThat(drone.replies().subList(seen, before))
        .as("replies that nobody expected before `" + command + "`")
        .isEmpty();
    drone.send(message.from(), message.text());
    drone.advanceUntil(() -> drone.replies().size() > before, reply.equals("-") ? QUIET : 30);
    List<Sent> came = drone.replies().subList(before, drone.replies().size());
    if (reply.equals("-")) {
      assertThat(came).as("replies to `" + command + "`").isEmpty();
    } else {
      assertThat(came).as("replies to `" + command + "`").isNotEmpty();
      assertThat(came.get(0).text())
          .as("reply to `" + command + "`")
          .matches(ExpectedText.of(reply).pattern());
      seen = before + 1;
    }
  }

  private void control(List<String> words) {
    switch (words.get(0)) {
      case "wait" -> drone.advance(Double.parseDouble(words.get(1)));
      case "quiet" -> seen = drone.replies().size();
      case "battery" -> drone.control(new Control.SetBattery(1, Double.parseDouble(words.get(1))));
      case "link" -> drone.control(new Control.SetLink(LinkPreset.of(words.get(1))));
      case "reset" -> drone.control(new Control.Reset(1));
      case "on" -> drone.control(new Control.Power(1, true));
      case "off" -> drone.control(new Control.Power(1, false));
      case "start" ->
          drone.control(
              new Control.SetStart(
                  1,
                  new Vec3(
                      Double.parseDouble(words.get(1)) / 100,
                      Double.parseDouble(words.get(2)) / 100,
                      0)));
      case "room" ->
          drone.control(
              new Control.SetRoom(
                  new Room(
                      Double.parseDouble(words.get(1)) / 100,
                      Double.parseDouble(words.get(2)) / 100,
                      Double.parseDouble(words.get(3)) / 100)));
      case "pad" -> lay(words);
      default -> throw new IllegalArgumentException("unknown step @" + words.get(0));
    }
  }

  /** Adds a mission pad, given by number, x, y and heading, in cm and degrees. */
  private void lay(List<String> words) {
    Vec3 place =
        new Vec3(Double.parseDouble(words.get(2)) / 100, Double.parseDouble(words.get(3)) / 100, 0);
    pads.add(
        MissionPad.onFloor(
            Integer.parseInt(words.get(1)),
            place,
            Math.toRadians(Double.parseDouble(words.get(4)))));
    drone.control(new Control.Furnish(List.of(), pads));
  }

  private record Message(InetSocketAddress from, String text) {}

  /** Parses a message: {@code B> takeoff} comes from client B, {@code takeoff} from A. */
  private static Message message(String notation) {
    int mark = notation.indexOf("> ");
    InetSocketAddress from = mark < 0 ? null : CLIENTS.get(notation.substring(0, mark));
    return from == null
        ? new Message(SteppedDrone.CLIENT, ExpectedText.bytes(notation))
        : new Message(from, ExpectedText.bytes(notation.substring(mark + 2)));
  }
}
