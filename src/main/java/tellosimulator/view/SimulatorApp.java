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
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.log.LogFeed;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.text.Language;

/** The program with a window. */
public final class SimulatorApp implements AutoCloseable {

  private final LogFeed feed = new LogFeed();
  private final OnlineSimulation simulation;
  private final CountDownLatch closed = new CountDownLatch(1);
  private volatile boolean failed;

  /**
   * Starts the simulation; all drones are off.
   *
   * @param replyPort port to which all replies go; empty for the port each command came from
   */
  public SimulatorApp(SimConfig config, AddressPlan plan, OptionalInt replyPort) {
    simulation = new OnlineSimulation(config, plan, replyPort, List.of(feed));
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
    ViewContext context = ViewContext.of(simulation, language);
    Stage stage = new Stage();
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

  @Override
  public void close() {
    simulation.close();
  }
}
