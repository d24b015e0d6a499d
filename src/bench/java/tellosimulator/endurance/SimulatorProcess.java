package tellosimulator.endurance;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import tellosimulator.benchmark.ProcessFigures;

/** The runnable jar without a window, its console and what it costs. */
final class SimulatorProcess implements AutoCloseable {

  private static final Pattern ADDRESS = Pattern.compile("drone (\\d+) at ([0-9.]+):(\\d+)");

  private static final Pattern TIME = Pattern.compile(" ([0-9.]+) s(?=$|,)");

  private static final double START_SECONDS = 30;

  /** Of a window, which takes much of a processor to open, beside whatever else runs. */
  private static final double WINDOW_START_SECONDS = 120;

  private static final double CONSOLE_SECONDS = 10;

  private final Program program;
  private final ProcessFigures figures;
  private final Map<Integer, InetSocketAddress> drones = new LinkedHashMap<>();
  private final String ready;

  private SimulatorProcess(Program program, String ready) {
    this.program = program;
    this.ready = ready;
    figures = new ProcessFigures(program.process());
    Matcher matcher = ADDRESS.matcher(ready);
    while (matcher.find()) {
      drones.put(
          Integer.valueOf(matcher.group(1)),
          new InetSocketAddress(matcher.group(2), Integer.parseInt(matcher.group(3))));
    }
  }

  /** Starts it on this machine, on ports that nobody uses, and waits until it is ready. */
  static SimulatorProcess here(String... options) throws IOException {
    return start(Host.HERE, List.of(), options);
  }

  /**
   * Starts it and waits until it is ready.
   *
   * @param jvm options of the JVM
   */
  static SimulatorProcess start(Host host, List<String> jvm, String... options) throws IOException {
    Program program = host.start(command(jvm, withoutWindow(options)));
    try {
      return new SimulatorProcess(program, program.await("ready", START_SECONDS));
    } catch (IOException e) {
      program.close();
      throw e;
    }
  }

  /** Starts it on this machine, and waits until it is ready or has ended. */
  static SimulatorProcess tryToStart(List<String> jvm, String... options) throws IOException {
    Program program = Host.HERE.start(command(jvm, withoutWindow(options)));
    try {
      return new SimulatorProcess(program, program.await("ready", START_SECONDS));
    } catch (IOException e) {
      return new SimulatorProcess(program, "");
    }
  }

  private static String[] withoutWindow(String... options) {
    return Stream.concat(Stream.of("--headless"), Stream.of(options)).toArray(String[]::new);
  }

  /**
   * Starts it with a window, on ports that nobody uses. If its drones are on, waits until it is
   * ready.
   *
   * @param settings the folder of what it remembers
   */
  static SimulatorProcess inWindow(Path settings, List<String> jvm, boolean on) throws IOException {
    List<String> command =
        command(jvm, "--command-port", "0", "--state-port", "" + FreePort.find());
    if (on) {
      command.add("--on");
    }
    Host here =
        new Host(
            List.of("env", "XDG_CONFIG_HOME=" + settings, "XDG_DATA_HOME=" + settings),
            Host.HERE.address());
    Program program = here.start(command);
    try {
      return new SimulatorProcess(program, on ? program.await("ready", WINDOW_START_SECONDS) : "");
    } catch (IOException e) {
      program.close();
      throw e;
    }
  }

  /** What starts it. */
  static List<String> command(List<String> jvm, String... options) {
    List<String> command = new ArrayList<>(List.of(ProcessFigures.tool("java")));
    command.addAll(jvm);
    command.addAll(List.of("-jar", System.getProperty("simulator.jar")));
    command.addAll(List.of(options));
    return command;
  }

  /** The line that says where the drones are; empty if it did not come. */
  String ready() {
    return ready;
  }

  /** Where a drone was when it was ready. */
  InetSocketAddress drone(int number) {
    return drones.get(number);
  }

  Program program() {
    return program;
  }

  ProcessFigures figures() {
    return figures;
  }

  /** Types a line that has no answer, and waits until it is carried out. */
  void type(String line) throws IOException {
    program.type(line);
    state(1);
  }

  /** What the console says about a drone. */
  String state(int drone) throws IOException {
    program.type("state");
    return program.await("drone " + drone + ":", CONSOLE_SECONDS);
  }

  /** What the console says about the simulation's time [s]. */
  double simulatedSeconds() throws IOException {
    String state = state(1);
    Matcher matcher = TIME.matcher(state);
    if (!matcher.find()) {
      throw new IOException("no time in: " + state);
    }
    return Double.parseDouble(matcher.group(1));
  }

  @Override
  public void close() {
    program.close();
  }
}
