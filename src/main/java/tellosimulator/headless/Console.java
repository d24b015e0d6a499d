package tellosimulator.headless;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import tellosimulator.command.WireText;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.network.PortTakenException;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * Executes the commands that users or scripts type into a simulator without a window. Confined to
 * the thread of its {@link #agent}.
 */
final class Console {

  /**
   * A number in decimal digits. Other forms that Java accepts, such as 0x1p3 or NaN, are excluded.
   */
  private static final Pattern NUMBER = Pattern.compile("-?[0-9]+(\\.[0-9]+)?");

  private static final String HELP =
      "type reset [N], release [N], power on|off [N], battery PERCENT [N], fault TEXT|clear, faults,"
          + " link PRESET, pause, resume, state, help, finish or quit";

  private static final String LONG_HELP =
      """
      state             see where each drone is and what it does
      reset [N]         put drones back to their start
      release [N]       take drones from their operators: the next `command` decides
      power on [N]      use the power switch; also: power off [N]
      battery P [N]     charge or drain the battery to P percent
      fault TEXT        let something go wrong, such as: fault loss state 20% for 10s
      fault clear       end all faults
      faults            see what goes wrong
      link PRESET       how good the link is: ideal, lab, classroom or crowded
      pause, resume     let time stand still, and go on
      finish            land all drones, then give the verdict on the goals and end
      quit              end the simulator
      N is a drone's number; without it, all drones.
      """;

  /** Carries out a {@link Control}, and returns when its effect is complete. */
  @FunctionalInterface
  interface Controls {
    void carryOut(Control control) throws PortTakenException;
  }

  private final Supplier<SimSnapshot> snapshots;
  private final Controls controls;
  private final BufferedReader in;
  private final PrintStream out;

  /** Creates a console without reading any input. */
  Console(Supplier<SimSnapshot> snapshots, Controls controls, BufferedReader in, PrintStream out) {
    this.snapshots = snapshots;
    this.controls = controls;
    this.in = in;
    this.out = out;
  }

  /**
   * Returns an agent that reads until {@code quit} or the end of input.
   *
   * @param onFinish called on {@code finish}, after all drones in the air have begun to land
   * @param onQuit called on {@code quit}
   */
  Agent agent(Runnable onFinish, Runnable onQuit) {
    return new Agent() {

      private final ErrorPolicy failed = ErrorPolicy.goOn("What was typed could not be done");
      private final ErrorPolicy unreadable =
          ErrorPolicy.finish("Standard input cannot be read any more");

      @Override
      public Outcome doWork() throws IOException {
        return readLine(onFinish, onQuit) ? Outcome.WORKED : Outcome.FINISHED;
      }

      @Override
      public ErrorPolicy onError(Throwable failure) {
        return failure instanceof IOException ? unreadable : failed;
      }
    };
  }

  /** Reads and executes one line; returns whether to read another one. */
  private boolean readLine(Runnable onFinish, Runnable onQuit) throws IOException {
    String line = in.readLine();
    if (line == null) {
      return false;
    }
    String typed = line.strip();
    if (typed.equals("quit")) {
      onQuit.run();
      return false;
    }
    if (!typed.isEmpty()) {
      take(typed);
    }
    if (typed.equals("finish")) {
      onFinish.run();
    }
    return true;
  }

  private void take(String line) {
    List<String> words = List.of(line.split("\\s+", -1));
    try {
      carryOut(words, line);
    } catch (IllegalArgumentException e) {
      out.println(notDone(line) + WireText.printable(e.getMessage()) + "; " + HELP + ".");
    } catch (PortTakenException e) {
      out.println(notDone(line) + e.getMessage());
    }
    out.flush();
  }

  private static String notDone(String line) {
    return "`" + WireText.printable(line) + "` was not done: ";
  }

  private void carryOut(List<String> words, String line) throws PortTakenException {
    switch (words.get(0)) {
      case "reset" -> forDrones(words, 1, Control.Reset::new);
      case "release" -> forDrones(words, 1, Control.Release::new);
      case "power" -> power(words);
      case "battery" -> battery(words);
      case "fault" -> fault(words, line);
      case "faults" -> faults(words);
      case "link" -> link(words);
      case "pause" -> pause(words, true);
      case "resume" -> pause(words, false);
      case "state" -> state(words);
      case "finish" -> finish(words);
      case "quit" -> checkEnd(words, 1);
      case "help" -> out.print(LONG_HELP);
      default -> throw new IllegalArgumentException("there is no such command");
    }
  }

  private void finish(List<String> words) throws PortTakenException {
    checkEnd(words, 1);
    if (snapshots.get().clock().paused()) {
      controls.carryOut(new Control.Pause(false)); // otherwise no drone would ever land
    }
    forDrones(words, 1, Control.Land::new);
  }

  private void pause(List<String> words, boolean paused) throws PortTakenException {
    checkEnd(words, 1);
    controls.carryOut(new Control.Pause(paused));
  }

  private void fault(List<String> words, String line) throws PortTakenException {
    String text = line.substring(words.get(0).length()).strip();
    controls.carryOut(
        text.equals("clear") ? new Control.ClearFaults() : new Control.InjectFault(Fault.of(text)));
  }

  private void faults(List<String> words) {
    checkEnd(words, 1);
    for (DroneSnapshot drone : snapshots.get().drones()) {
      List<String> texts = new ArrayList<>(List.of("link " + drone.faults().link().option()));
      drone.faults().faults().forEach(fault -> texts.add(fault.text()));
      out.println("drone " + drone.state().drone() + ": " + String.join("; ", texts));
    }
  }

  private void link(List<String> words) throws PortTakenException {
    String word = word(words, 1, "one of " + String.join(", ", LinkPreset.options()));
    checkEnd(words, 2);
    controls.carryOut(new Control.SetLink(LinkPreset.of(word)));
  }

  private void state(List<String> words) {
    checkEnd(words, 1);
    out.print(describe(snapshots.get()));
  }

  private static void checkEnd(List<String> words, int end) {
    if (words.size() > end) {
      throw new IllegalArgumentException("there is a word too many, " + words.get(end));
    }
  }

  private void power(List<String> words) throws PortTakenException {
    String position = word(words, 1, "on or off");
    if (!List.of("on", "off").contains(position)) {
      throw new IllegalArgumentException("expected on or off, found " + position);
    }
    boolean on = position.equals("on");
    forDrones(words, 2, n -> new Control.Power(n, on));
  }

  private void battery(List<String> words) throws PortTakenException {
    double percent = number(word(words, 1, "a percentage"), "a percentage");
    forDrones(words, 2, n -> new Control.SetBattery(n, percent));
  }

  private void forDrones(List<String> words, int index, IntFunction<Control> control)
      throws PortTakenException {
    for (int drone : drones(words, index)) {
      controls.carryOut(control.apply(drone));
    }
  }

  /**
   * Returns the drone whose number is the word at {@code index}; all drones if there is no such
   * word.
   */
  private List<Integer> drones(List<String> words, int index) {
    checkEnd(words, index + 1);
    List<Integer> all =
        snapshots.get().drones().stream().map(drone -> drone.state().drone()).toList();
    if (words.size() <= index) {
      return all;
    }
    double number = number(words.get(index), "a drone's number");
    return all.stream()
        .filter(n -> n == number)
        .findFirst()
        .map(List::of)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    all.size() == 1
                        ? "there is only drone 1"
                        : "the drones are 1 to " + all.size()));
  }

  private static String word(List<String> words, int index, String expected) {
    if (words.size() <= index) {
      throw new IllegalArgumentException("expected " + expected);
    }
    return words.get(index);
  }

  private static double number(String word, String expected) {
    if (!NUMBER.matcher(word).matches()) {
      throw new IllegalArgumentException("expected " + expected + ", found " + word);
    }
    return Double.parseDouble(word);
  }

  private static String describe(SimSnapshot snapshot) {
    StringBuilder lines = new StringBuilder();
    snapshot.drones().forEach(drone -> lines.append(describe(snapshot, drone)).append('\n'));
    return lines.toString();
  }

  private static String describe(SimSnapshot snapshot, DroneSnapshot drone) {
    DroneState state = drone.state();
    Vec3 position = state.motion().position().times(100);
    return String.format(
        Locale.ROOT,
        "drone %d: %s, x %.1f y %.1f z %.1f cm, yaw %.1f degrees, battery %d %%, %s, %.3f s%s",
        state.drone(),
        state.phase().words(),
        tenths(position.x()),
        tenths(position.y()),
        tenths(position.z()),
        tenths(Frames.yawOfHeading(state.reference().turned(state.motion().attitude()))),
        state.energy().battery().percent(),
        drone
            .link()
            .operator()
            .map(peer -> "operated by " + peer.host())
            .orElse("waits for `command`"),
        snapshot.time().seconds(),
        describe(snapshot.clock()));
  }

  private static String describe(SimSnapshot.Clock clock) {
    String lost =
        clock.lostSeconds() > 0
            ? String.format(Locale.ROOT, ", %.1f s lost", clock.lostSeconds())
            : "";
    return lost + (clock.paused() ? ", paused" : "");
  }

  /** Rounds a value to tenths; never returns negative zero. */
  private static double tenths(double value) {
    return Math.round(value * 10) / 10.0;
  }
}
