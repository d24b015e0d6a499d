package tellosimulator.view;

import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.concurrent.CountDownLatch;
import javafx.application.Platform;
import javafx.stage.Stage;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.sim.SimConfig;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.log.LogFeed;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.Album;
import tellosimulator.view.video.WindowVideo;

/** The program with a window. */
public final class SimulatorApp implements AutoCloseable {

  /** Frames that the window shows before filming is warmed up. Decided: half a second. */
  private static final int FRAMES_BEFORE_WARM_UP = 30;

  private final LogFeed feed = new LogFeed();
  private final OnlineSimulation simulation;
  private final WindowVideo video;
  private final CountDownLatch closed = new CountDownLatch(1);
  private volatile boolean failed;
  private int frames;

  /**
   * Starts the simulation; all drones are off.
   *
   * @param replyPort port to which all replies go; empty for the port each command came from
   * @param optics of the drones' cameras
   */
  public SimulatorApp(
      SimConfig config, AddressPlan plan, OptionalInt replyPort, DroneOptics optics) {
    simulation = new OnlineSimulation(config, plan, replyPort, List.of(feed));
    video = WindowVideo.of(simulation, optics, Album.ofUser());
  }

  /**
   * Switches all drones on, or none.
   *
   * @throws PortTakenException if an address or port cannot be had
   */
  public void switchAllOn() throws PortTakenException {
    simulation.switchAllOn();
  }

  /** Which drone listens where; see {@link OnlineSimulation#ready}. */
  public String ready() {
    return simulation.ready();
  }

  /**
   * Opens the window, and returns after it was closed. The {@link Toolkit} must run.
   *
   * @param settings what was remembered, and what is to be remembered
   * @param state what the window is switched to
   * @return whether there was a window; if not, the log says why
   */
  public boolean run(Settings settings, WindowState state) throws InterruptedException {
    Platform.runLater(
        () -> {
          try {
            open(settings, state);
          } catch (RuntimeException e) {
            failed = true;
            closed.countDown(); // or the program would go on, with nothing to be seen of it
            throw e;
          }
        });
    closed.await();
    Platform.exit();
    return !failed;
  }

  private void open(Settings settings, WindowState state) {
    Language language = new Language(Locale.getDefault());
    settings.bind("language", language.localeProperty(), Language.codec());
    ViewContext context = ViewContext.of(simulation, language, video);
    Stage stage = new Stage();
    context.pulse().onBeat(nanos -> warmUp());
    SimulatorWindow window = new SimulatorWindow(stage, context, state, feed);
    window.remember(settings);
    stage.setOnHidden(
        hidden -> {
          window.close();
          settings.save();
          closed.countDown();
        });
    window.show();
  }

  /** Opening the window has the machine to itself. */
  private void warmUp() {
    frames++;
    if (frames == FRAMES_BEFORE_WARM_UP) {
      video.warmUp();
    }
  }

  @Override
  public void close() {
    video.close();
    simulation.close();
  }
}
