package tellosimulator.endurance;

import java.awt.AWTException;
import java.awt.GraphicsEnvironment;
import java.awt.Robot;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import tellosimulator.benchmark.Measurement;
import tellosimulator.benchmark.ProcessFigures;

/**
 * What the window costs while nothing moves, drawn by the software pipeline and in 3D (by Mesa's
 * llvmpipe where there is no graphics card). The first minute and a half does not count, nor does
 * what the compilers of the Java machine take after it: they are warming up, and come to an end.
 */
final class WindowTrial {

  private static final double LARGEST_PERCENT = 5;
  private static final double WARM_UP_SECONDS = 90;
  private static final double SECONDS = 30;

  /** From a window that has opened to one that has the keys [s]. */
  private static final double OPENING_SECONDS = 8;

  private static final int KEY_MS = 50;
  private static final int PRESSES = 5;

  /** Observations of 2 s after each press. */
  private static final int LOOKS = 8;

  private static final int PATIENCE_MS = 30_000;

  /** A pipeline of the toolkit. */
  private enum Pipeline {
    SOFTWARE("drawn by software", "-Dprism.order=sw"),
    THREE_DIMENSIONS("in 3D", "-Dprism.forceGPU=true");

    private final String words;
    private final String property;

    Pipeline(String words, String property) {
      this.words = words;
      this.property = property;
    }
  }

  /** What does not move. */
  private enum Scene {
    PAUSED("paused in flight"),
    OFF("drone off"),
    ON_THE_GROUND("drone on the ground"),
    INSET("drone on the ground, its camera's picture shown");

    private final String words;

    Scene(String words) {
      this.words = words;
    }
  }

  /**
   * Processor time [s].
   *
   * @param compiling what of it the compilers of the Java machine took
   */
  private record Used(double seconds, double compiling) {
    Used since(Used before) {
      return new Used(seconds - before.seconds, compiling - before.compiling);
    }
  }

  /** A window that was opened. */
  private record Opened(Pipeline pipeline, Scene scene, SimulatorProcess simulator)
      implements AutoCloseable {

    Used used() {
      ProcessFigures figures = simulator.figures();
      return new Used(figures.processorSeconds(), figures.compilerSeconds());
    }

    @Override
    public void close() {
      simulator.close();
    }
  }

  private WindowTrial() {}

  /** All windows at once: what a process uses is counted for it alone. */
  static List<Measurement> run(double minutes) throws IOException {
    String what = "The window while nothing moves";
    if (System.getenv("DISPLAY") == null) {
      return List.of(Measurement.beside(what, "not measured: no display"));
    }
    List<Opened> windows = new ArrayList<>();
    try {
      for (Pipeline pipeline : Pipeline.values()) {
        for (Scene scene : scenes()) {
          windows.add(open(pipeline, scene));
        }
      }
      Waiting.pass(WARM_UP_SECONDS);
      return rows(windows);
    } finally {
      windows.forEach(Opened::close);
    }
  }

  /** A Java without AWT, as build servers have it, cannot press the key for a pause. */
  private static List<Scene> scenes() {
    return Stream.of(Scene.values())
        .filter(scene -> scene != Scene.PAUSED || !GraphicsEnvironment.isHeadless())
        .toList();
  }

  private static List<Measurement> rows(List<Opened> windows) {
    List<Used> before = windows.stream().map(Opened::used).toList();
    long begun = System.nanoTime();
    Waiting.pass(SECONDS);
    List<Measurement> rows = new ArrayList<>();
    for (Opened window : windows) {
      Used used = window.used().since(before.get(rows.size()));
      double seconds = (System.nanoTime() - begun) * 1e-9;
      double compilers = 100 * used.compiling / seconds;
      double percent = 100 * used.seconds / seconds - compilers;
      rows.add(
          new Measurement(
              "The window %s, %s".formatted(window.pipeline.words, window.scene.words),
              String.format(Locale.ROOT, "at most %.0f %% of a processor", LARGEST_PERCENT),
              String.format(Locale.ROOT, "%.1f %%, and %.1f %% the compilers", percent, compilers),
              percent <= LARGEST_PERCENT));
    }
    return rows;
  }

  private static Opened open(Pipeline pipeline, Scene scene) throws IOException {
    Path settings = Files.createTempDirectory("endurance-window");
    Path file = settings.resolve("tello-simulator").resolve("settings.properties");
    Files.createDirectories(file.getParent());
    // with settings it is no first start, at which the gallery would take the keys
    Files.writeString(file, "show.inset=" + (scene == Scene.INSET) + "\n");
    SimulatorProcess simulator =
        SimulatorProcess.inWindow(settings, List.of(pipeline.property), scene != Scene.OFF);
    Opened window = new Opened(pipeline, scene, simulator);
    try {
      if (scene == Scene.PAUSED) {
        Waiting.pass(OPENING_SECONDS);
        pauseInFlight(simulator.drone(1));
      }
    } catch (IOException | AWTException e) {
      window.close();
      throw new IOException("the flight cannot be paused: " + e.getMessage(), e);
    }
    return window;
  }

  /**
   * Presses the key for a pause in the window that was opened last, again if it did not have the
   * keys yet. Between two presses it waits as long as a window that gets little processor time may
   * take to react, since a second press ends the pause.
   */
  private static void pauseInFlight(InetSocketAddress drone) throws IOException, AWTException {
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.connect(drone);
      socket.setSoTimeout(PATIENCE_MS);
      StudentProgram.ask(socket, "command");
      StudentProgram.ask(socket, "takeoff");
      Robot robot = new Robot();
      for (int press = 0; press < PRESSES; press++) {
        robot.keyPress(KeyEvent.VK_F9);
        robot.delay(KEY_MS);
        robot.keyRelease(KeyEvent.VK_F9);
        for (int look = 0; look < LOOKS; look++) {
          String before = StudentProgram.ask(socket, "time?");
          Waiting.pass(2);
          if (StudentProgram.ask(socket, "time?").equals(before)) {
            return;
          }
        }
      }
      throw new IOException("time passes after F9 was pressed " + PRESSES + " times");
    }
  }
}
